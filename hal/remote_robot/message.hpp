#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "calls/device_list.hpp"
#include "calls/interceptor.hpp"
#include "eyebridge/base/clock.hpp"
#include "eyebridge/hal/device_facts.hpp"
#include "eyebridge/hal/radio.hpp"
#include "remote_robot/bytes.hpp"

namespace eyebridge::hal {

// What the program of a robot, in a process of its own, and its server in the world say to each
// other.
//
//   program                 server
//   request "robot hello" →  ← welcome
//   request              →  ← traces, if it wants them, then the reply
//
// Each message is its kind, one byte, and the fields of its struct in their order (bytes.hpp). Both
// ends are of one build: a hello with another version is refused.

using Message = std::vector<std::uint8_t>;

enum class MessageKind : std::uint8_t { Request = 'q', Reply = 'r', Welcome = 'w', Trace = 't' };

inline constexpr int kRobotLineVersion = 4;

/// A call of one of the robot's devices; of its "view" and its "world"; or of "robot" itself:
/// "hello", "arrive" (Backend::arrive()), "now", which only lets time pass, "trace" (1: from now
/// on, 0: no more) and "stop".
struct RobotRequest {
  Time time{0};  ///< In virtual time: where the program's clock is, or wants to be.
  std::string device;
  int id = 1;
  std::string name;
  bool is_command = false;
  Values request;
};

/// What came of it.
struct RobotReply {
  Time now{0};    ///< On the robot's clock.
  Time limit{0};  ///< In virtual time: before this the program's clock may move by itself.
  Result<Values> values;
};

/// What the program has to know of its robot.
struct RobotWelcome {
  Time now{0};
  Time limit{0};
  bool is_virtual = false;
  int robot_id = 1;
  RadioConditions radio;
  bool has_world = false;
  bool has_view = false;
  std::uint32_t carrier = 0;      ///< Of the view.
  std::string texture_directory;  ///< Likewise.
  std::vector<ListedDevice> devices;
  std::vector<std::pair<std::string, std::vector<DeviceFacts>>> facts;  ///< By kind.
};

/// The kind of a message; nothing when it is none.
std::optional<MessageKind> kind_of(std::span<const std::uint8_t> message);

Message encode(const RobotRequest& request);
Message encode(const RobotReply& reply);
Message encode(const RobotWelcome& welcome);

// Nothing when the bytes are not exactly one message of that kind. No bytes can do harm.
std::optional<RobotRequest> decode_request(std::span<const std::uint8_t> message);
std::optional<RobotReply> decode_reply(std::span<const std::uint8_t> message);
std::optional<RobotWelcome> decode_welcome(std::span<const std::uint8_t> message);

/// Begins a message.
void begin(ByteWriter& writer, MessageKind kind);
/// Reads one, which must be of this kind, from behind that.
ByteReader opened(std::span<const std::uint8_t> message, MessageKind kind);

}  // namespace eyebridge::hal
