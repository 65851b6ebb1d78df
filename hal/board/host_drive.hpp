#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/drive_goal.hpp"
#include "eyebridge/base/pose.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/files/hdt.hpp"
#include "eyebridge/hal/drive.hpp"
#include "eyebridge/robot/robot_model.hpp"

namespace eyebridge::hal {

/// What the v-omega controller on the host must know of the robot.
struct HostDriveSettings {
  int left_motor = 1;  ///< Numbers of the motors and of their encoders.
  int right_motor = 2;
  bool left_reversed = false;  ///< Positive speeds and counts of the board are backwards.
  bool right_reversed = false;
  double left_ticks_per_metre = 0;  ///< Encoder ticks a metre of travel; > 0.
  double right_ticks_per_metre = 0;
  double wheel_base = 0;                                                   ///< Metres; > 0.
  double max_linear = robot::DriveModel{}.max_linear;                      ///< Metres per second.
  double max_angular = robot::DriveModel{}.max_angular;                    ///< Radians per second.
  double linear_acceleration = robot::DriveModel{}.linear_acceleration;    ///< m/s^2; 0 = no ramp.
  double angular_acceleration = robot::DriveModel{}.angular_acceleration;  ///< rad/s^2; likewise.
  /// How far a wheel rolls on when its motor is told to stand still, per speed: seconds.
  double motor_lag = 0.0;
  double stall_timeout = 2.0;  ///< A goal that is stalled this long fails, seconds.
};

/// Settings from a board's HDT: its DRIVE and the ENCODERs of it; a motor that turns clockwise is
/// reversed. Ramps and the top turning speed, which an HDT does not have, are the defaults. Throws
/// ConfigError when one of the lines is missing or the drive is not differential.
HostDriveSettings host_drive_settings(const files::Hdt& hdt, const std::string& file);

/// Makes of a 16-bit counter that wraps around one that does not. It must be read before it moves
/// by 32768.
class UnwrappedCount {
 public:
  /// The counter's change since the last call, -32768 … 32767; 0 at the first one.
  int feed(std::uint16_t count);
  /// Sum of the changes.
  [[nodiscard]] std::int64_t total() const { return total_; }
  /// The next count is a first one: the board has restarted. The total stays.
  void forget() { last_.reset(); }

 private:
  std::optional<std::uint16_t> last_;
  std::int64_t total_ = 0;
};

/// The encoders' counters as the board gives them.
struct WheelCounts {
  std::uint16_t left = 0;
  std::uint16_t right = 0;
};

/// Speeds as letter `M` takes them: encoder ticks in 10 ms, -127 … 127.
struct WheelSpeeds {
  int left = 0;
  int right = 0;
  friend bool operator==(const WheelSpeeds&, const WheelSpeeds&) = default;
};

/// The v-omega drive of a board that has none of its own: encoder counts and the time in, wheel
/// speeds out, a hundred times a second.
///
/// The controller, its ramps and its meaning of goals are those of core/robot, fed with what the
/// encoders measured. Speeds between two whole ticks are reached on average. Pure: no clock, no
/// I/O. Not thread-safe. Metres, radians, seconds; numbers are finite.
class HostDrive {
 public:
  static constexpr Time kPeriod = std::chrono::milliseconds(10);
  /// Counts that are farther apart do not tell what was driven: whoever was told for so long that
  /// nothing is known of the robot must command it again. (They may even have wrapped around: at
  /// 127 ticks in 10 ms after 2.58 s.)
  static constexpr Time kLongestGap = std::chrono::seconds(1);

  /// Settings are asserted to be possible; host_drive_settings() gives such.
  explicit HostDrive(const HostDriveSettings& settings);
  ~HostDrive();
  HostDrive(HostDrive&&) noexcept;
  HostDrive& operator=(HostDrive&&) noexcept;

  // Commands take the motors over; the next step() begins them.
  void set_speed(const Twist& twist);  ///< Clamped to what the wheels can do, curvature kept.
  void start(const DriveGoal& goal);   ///< As Drive::start().
  void stop();                         ///< Speed zero without a ramp; a goal is dropped.
  /// Gives the motors up: the program uses them itself. Odometry goes on with step().
  void release();
  /// True when the speeds of step() are to be sent.
  [[nodiscard]] bool engaged() const;

  /// Takes counts read at `now`, and says how fast the wheels must turn until the next call. Calls
  /// that come less than half a period after the last one change nothing; after a late one the
  /// ramps have caught up. Fails once with Timeout when the last call was more than kLongestGap
  /// ago: what was driven meanwhile is unknown, a goal has failed, and the robot is to stand.
  Result<WheelSpeeds> step(const WheelCounts& counts, Time now);
  /// The board has restarted: the drive stands, and the next counts are first ones.
  void restart();

  /// Of the last command. A wheel counts as stalled that turned for 0.2 s less than a quarter of
  /// what it should have; after a goal that failed by it until the next command.
  [[nodiscard]] DriveStatus status() const;
  [[nodiscard]] Twist measured_twist() const;  ///< Over the last five counts: 50 ms.
  [[nodiscard]] Pose odometry() const;         ///< Heading in (-pi, pi].
  void set_odometry(const Pose& pose);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace eyebridge::hal
