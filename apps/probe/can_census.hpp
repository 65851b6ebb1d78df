#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/bridges/can/messages.hpp"
#include "eyebridge/bridges/can_bus.hpp"
#include "eyebridge/bridges/client/robot_watch.hpp"

namespace eyebridge::apps {

/// What was heard of one robot.
struct HeardRobot {
  int heartbeats = 0;
  std::uint8_t state = 0;  ///< EYECAN_STATE_…; of the last heartbeat.
  std::optional<bridges::can::VersionStatus> version;
  std::optional<bridges::can::BoardStatus> board;
  bridges::can::FaultStatus fault{};
  std::vector<int> psds;  ///< Numbers of those that are there.
  bool drives = false;    ///< It tells speed and pose.
  bool has_encoders = false;
  int lidar_points = 0;  ///< 0: none was announced.
  bool sends_fd = false;
  bool twice = false;  ///< Two robots have this number.
};

/// Who is on a bus.
struct CanCensus {
  std::map<int, HeardRobot> robots;  ///< By number.
  bool has_host = false;             ///< Another program commands robots.
  std::uint64_t frames = 0;
  std::uint64_t foreign = 0;  ///< Frames that are none of the protocol.
  std::uint64_t corrupt = 0;  ///< Of the protocol, but too short or with impossible values.
  bridges::CanStatistics bus{};
};

/// Makes a census of frames that are handed to it. No I/O.
class CensusTaker {
 public:
  void take(const bridges::CanFrame& frame, Time now);
  /// Robots that were heard, but have not told their version.
  [[nodiscard]] std::vector<int> without_version() const;
  /// What was found so far.
  [[nodiscard]] CanCensus census() const;

 private:
  struct Seen {
    HeardRobot robot;
    bridges::RobotWatch watch{"robot"};
    std::optional<std::uint32_t> first_uptime;
    int heartbeats_since = 0;  ///< Since first_uptime.
    int heartbeats_until = 0;  ///< Of these, until the last uptime.
  };

  void take_message(Seen& seen, const bridges::can::AnyMessage& message, Time now);
  [[nodiscard]] static bool is_twice(const Seen& seen);

  std::map<int, Seen> seen_;
  CanCensus counts_;
};

/// Listens to `bus` for `span`, half-way asking those robots for their version that have not told
/// it (a remote frame); sends nothing else. `clock` is the one of the bus. Fails with Disconnected
/// when the bus is lost.
Result<CanCensus> listen_to(bridges::CanBus& bus, Clock& clock, Time span);

/// What a person wants to know of it, several lines; `interface` as in can:INTERFACE.
std::string described(const CanCensus& census, const std::string& interface);

}  // namespace eyebridge::apps
