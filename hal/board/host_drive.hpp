#pragma once

#include <cstdint>
#include <memory>

#include "board/board_tables.hpp"
#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/drive_goal.hpp"
#include "eyebridge/base/pose.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/drive.hpp"
#include "eyebridge/robot/robot_model.hpp"

namespace eyebridge::hal {

/// What the v-omega controller on the host must know of the robot.
struct HostDriveSettings : BoardDriveShape {
  double linear_acceleration = robot::DriveModel{}.linear_acceleration;    ///< m/s^2; 0 = no ramp.
  double angular_acceleration = robot::DriveModel{}.angular_acceleration;  ///< rad/s^2; likewise.
  /// How far a wheel rolls on when its motor is told to stand still, per speed: seconds.
  double motor_lag = 0.0;
  double stall_timeout = 2.0;  ///< A goal that is stalled this long fails, seconds.
};

/// Counts of the encoders as BoardLink::encoder() gives them: they wrap as 32 bits do.
struct WheelCounts {
  std::int32_t left = 0;
  std::int32_t right = 0;
};

/// Speeds as letter `M` takes them: encoder ticks in 10 ms, -127 … 127.
struct WheelSpeeds {
  int left = 0;
  int right = 0;
  friend bool operator==(const WheelSpeeds&, const WheelSpeeds&) = default;
};

/// The v-omega drive of a board that has none of its own: encoder counts and their time in, wheel
/// speeds out, a hundred times a second, or as often as the line to the board lets the counts come.
///
/// The controller, its ramps and its meaning of goals are those of core/robot, fed with what the
/// encoders measured. Speeds between two whole ticks are reached on average. Pure: no clock, no
/// I/O. Not thread-safe. Metres, radians, seconds; numbers are finite.
class HostDrive {
 public:
  static constexpr Time kPeriod = std::chrono::milliseconds(10);
  /// After a longer gap between two counts the robot stands until it is commanded again.
  static constexpr Time kLongestGap = std::chrono::seconds(1);
  /// Up to here the counts still tell how far the wheels went: at top speed a counter of 16 bits
  /// needs a little longer for half of its range.
  static constexpr Time kLongestCount = std::chrono::milliseconds(2500);

  /// Settings are asserted to be possible.
  explicit HostDrive(const HostDriveSettings& settings);
  ~HostDrive();

  // Commands take the motors over; the next step() begins them.
  void set_speed(const Twist& twist);  ///< Clamped to what the wheels can do, curvature kept.
  void start(const DriveGoal& goal);   ///< As Drive::start().
  /// Gives the motors up: the program uses them itself. Odometry goes on with step().
  void release();
  /// True when the speeds of step() are to be sent.
  [[nodiscard]] bool engaged() const;

  /// Takes what the wheels had counted at `counted`, and says how fast they must turn from `late`
  /// after that until the next call. Calls that come less than half a period after the last one
  /// change nothing; after a late one the ramps have caught up. Fails once with Timeout when the
  /// last call was more than kLongestGap ago: a goal has failed, and the robot is to stand. The
  /// odometry then has what was driven meanwhile, unless that was more than kLongestCount ago.
  Result<WheelSpeeds> step(const WheelCounts& counts, Time counted, Time late = Time{0});
  /// How long it usually is from counts to counts, seconds: what the line lets it be. The longer,
  /// the slower the robot drives at most: some centimetres between two counts.
  [[nodiscard]] double cycle() const;
  /// Ends what it does: the next step() asks for no speed. Odometry goes on.
  void halt();
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
