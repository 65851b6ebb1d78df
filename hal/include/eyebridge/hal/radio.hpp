#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/device.hpp"

namespace eyebridge::hal {

/// A message as it came: who sent it, and what.
struct RadioMessage {
  int sender = 0;
  std::string text;  ///< Any bytes.

  friend bool operator==(const RadioMessage&, const RadioMessage&) = default;
};

/// What messages to a robot suffer on their way, as its model says.
struct RadioConditions {
  double loss = 0.0;     ///< Share that gets lost, 0 … 1.
  Time delay{0};         ///< Until one arrives, on the robot's clock.
  Time jitter{0};        ///< Up to so much later, evenly spread: messages may overtake.
  double corrupt = 0.0;  ///< Share in which one bit is flipped, 0 … 1.
  double range = 0.0;    ///< Metres beyond which nothing arrives; 0: no limit.
};

/// The radio of a robot: messages to other robots by number.
///
/// The backend owns it; any thread. All but id() and start() fail with Unsupported while it is off.
class Radio : public Device {
 public:
  static constexpr int kEveryone = -1;               ///< As a receiver: all others.
  static constexpr int kFirstId = 1;                 ///< Of a robot.
  static constexpr int kLastId = 255;                ///< Of a robot.
  static constexpr std::size_t kLongestText = 1024;  ///< Bytes.

  /// This robot's number, kFirstId … kLastId.
  [[nodiscard]] virtual int id() const = 0;
  /// Switches it on; messages that were sent before are not received. Twice does nothing.
  virtual Result<void> start() = 0;
  /// Switches it off; what has come is forgotten. Twice does nothing.
  virtual Result<void> stop() = 0;
  /// Sends to robot `receiver` (one's own number, too), or kEveryone; returns at once. A message to
  /// a robot that is not there is lost without an error. OutOfRange for no number of a robot and a
  /// longer text.
  virtual Result<void> send(int receiver, const std::string& text) = 0;
  /// The oldest message that has come; none when there is none. Never waits.
  virtual Result<std::optional<RadioMessage>> receive() = 0;
  /// The numbers of all robots that are known to have their radio on, this one too, ascending.
  virtual Result<std::vector<int>> robots() = 0;
};

}  // namespace eyebridge::hal
