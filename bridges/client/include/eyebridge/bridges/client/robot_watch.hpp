#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/result.hpp"

namespace eyebridge::bridges {

/// Whether a robot on the bus may be commanded. Pure: is told what was heard and when; no I/O.
///
/// A robot is heard, listened to for a while, enabled into speed 0, and Ready as soon as it says
/// that it is operational. Whatever ends that (silence, a restart, an emergency stop, a second
/// robot with its number) drops every command it was given: the old one is never resumed.
class RobotWatch {
 public:
  enum class Phase {
    Unheard,           ///< Never heard.
    Waking,            ///< Heard; is being enabled.
    Ready,             ///< Operational.
    Lost,              ///< Silent since longer than kHeartbeatLimit.
    EmergencyStopped,  ///< By whomever; only restart() leads out.
    Twice,             ///< Two robots have this number, or two hosts; only restart() leads out.
  };

  static constexpr Time kHeartbeatLimit = std::chrono::milliseconds(300);
  /// How long a robot is listened to before it is enabled for the first time.
  static constexpr Time kListening = std::chrono::milliseconds(400);

  /// `name` is what messages call the robot: "robot 1 on can0".
  explicit RobotWatch(std::string name) : name_(std::move(name)) {}

  /// A heartbeat with `state`, EYECAN_STATE_….
  void heartbeat(std::uint8_t state, Time now);
  /// Time since the robot started, 0.1 s; 24 bits that wrap.
  void uptime(std::uint32_t ds, Time now);
  /// A fault that the robot reports, EYECAN_FAULT_….
  void fault(std::uint16_t code);
  /// Somebody else speaks for the robot, or to it, as `what` says.
  void not_alone(const std::string& what);
  /// The bus does not work, for the reason that `why` gives.
  void bus_lost(const std::string& why);
  /// Time passes; to be called at least every 50 ms.
  void check(Time now);

  /// An enable command went out.
  void enabled();
  /// Whether one is to be sent now.
  [[nodiscard]] bool wants_enable(Time now) const {
    return phase_ == Phase::Waking && now >= enable_from_;
  }
  /// An emergency stop of our own begins.
  void emergency_stop();
  /// Leaves EmergencyStopped and Twice; no enable before `enable_from`.
  void restart(Time enable_from);

  [[nodiscard]] Phase phase() const { return phase_; }
  /// Grows each time that a robot stops being Ready.
  [[nodiscard]] std::uint32_t generation() const { return generation_; }
  /// Grows each time that a robot has restarted, or another one has taken its place. Known before
  /// it is Ready again.
  [[nodiscard]] std::uint32_t restarts() const { return restarts_; }
  /// Why the robot cannot be commanded now.
  [[nodiscard]] Error error() const { return error_; }
  /// What a person should know, each once; empty when there is nothing new.
  std::string take_news();

 private:
  void enter(Phase phase, Errc code, const std::string& what);
  void restarted(Time now);
  void look_at_birth(std::uint32_t step, Time now);

  const std::string name_;
  Phase phase_ = Phase::Unheard;
  Error error_{Errc::Disconnected, name_ + ": not heard yet; expected its heartbeat"};
  std::string news_;
  Time last_heartbeat_{0};
  std::optional<std::uint8_t> last_state_;
  Time enable_from_{0};
  bool enabled_ = false;  ///< Since Waking began.
  std::uint32_t generation_ = 0;
  std::uint32_t restarts_ = 0;
  std::optional<std::uint32_t> uptime_;
  std::optional<Time> uptime_at_;  ///< When `uptime_` came.
  std::optional<Time> born_;  ///< When the robot started, by the last uptime that came in time …
  Time born_seen_{0};         ///< … and when that was.
  std::optional<Time> restarted_at_;  ///< The last time that it was noticed.
  bool knows_restart_ = true;         ///< Whether the robot restarted before Waking began.
  unsigned steps_back_ = 0;  ///< Bit n: the uptime n steps ago was less than the one before.
  std::uint32_t window_start_ = 0;
  int window_heartbeats_ = 0;
};

}  // namespace eyebridge::bridges
