#include "board/host_drive.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "eyebridge/hal/slow_line.hpp"
#include "eyebridge/robot/drive_controller.hpp"
#include "eyebridge/robot/odometry.hpp"

namespace eyebridge::hal {
namespace {

constexpr double kPeriodSeconds = 0.01;
constexpr int kTopTicks = 127;           // of letter M
constexpr double kLongestStep = 0.1;     // seconds that the ramps make up for after a late call
constexpr int kCycles = 8;               // of which the usual cycle is an average
constexpr double kMemory = 2.0;          // seconds, for the worst one
constexpr double kMuchLonger = 1.5;      // times a cycle: another is this much longer
constexpr std::size_t kMeasured = 5;     // periods: one alone is too coarse for a speed
constexpr int kStallDebt = 4;            // ticks that a wheel owes before it counts as held …
constexpr int kStallPeriods = 20;        // … and for how long
constexpr double kCreepDistance = 1e-4;  // metres: nearer to its goal no motor drives
constexpr double kCreepAngle = 1e-3;     // radians

double speed_step(double acceleration, double seconds) {
  return acceleration > 0.0 ? acceleration * seconds : std::numeric_limits<double>::infinity();
}

/// How long it is from counts to counts: usually, and at worst of late. Seconds.
struct Cycle {
  double usual = kPeriodSeconds;
  double worst = kPeriodSeconds;
};

/// For speeds that hold for `seconds`, though now and then for the cycle's worst.
robot::DriveLimits limits_of(const HostDriveSettings& s, double seconds, const Cycle& cycle) {
  assert(s.wheel_base > 0.0 && s.left_ticks_per_metre > 0.0 && s.right_ticks_per_metre > 0.0);
  const double coarser = std::min(s.left_ticks_per_metre, s.right_ticks_per_metre);
  const double finer = std::max(s.left_ticks_per_metre, s.right_ticks_per_metre);
  robot::DriveLimits limits;
  limits.dt = seconds;
  limits.linear = std::min(s.max_linear, kFarthestBlind / cycle.usual);
  limits.angular = std::min(s.max_angular, kWidestBlind / cycle.usual);
  limits.linear_step = speed_step(s.linear_acceleration, seconds);
  limits.angular_step = speed_step(s.angular_acceleration, seconds);
  limits.wheel = kTopTicks / kPeriodSeconds / finer;
  limits.half_base = s.wheel_base / 2;
  // A goal between two ticks is reached at either of them; and the slowest speed is a tick in a
  // period, held until the next counts: half of that way, or of that turn, is as near as it gets.
  const double periods = seconds / kPeriodSeconds;
  limits.distance_end = kCreepDistance + std::max(1.0, periods / 2) / coarser;
  limits.angle_end = kCreepAngle + std::max(1.0, periods) / coarser / s.wheel_base;
  limits.blind = periods > 1.0;
  if (cycle.worst > kMuchLonger * seconds) limits.held = cycle.worst / seconds;
  return limits;
}

/// One wheel: its count, the part of a tick that its speed still owes, its stall.
struct Side {
  bool reversed = false;
  double ticks_per_metre = 0.0;
  std::int32_t count = 0;  ///< As read last.
  double carry = 0.0;
  int speed = 0;  ///< Ticks in a period, forward positive.
  int debt = 0;   ///< Ticks asked for, less four times those that came.
  int held = 0;   ///< Periods since the debt began.

  /// Metres since the last counts.
  double travel(std::int32_t reading, int periods) {
    const auto change =
        static_cast<std::int32_t>(static_cast<std::uint32_t>(reading) -
                                  static_cast<std::uint32_t>(std::exchange(count, reading)));
    const int ticks = reversed ? -change : change;
    const int came = speed < 0 ? -ticks : ticks;
    debt = std::clamp(debt + periods * std::abs(speed) - 4 * came, 0, 2 * kStallDebt);
    held = debt == 0 ? 0 : held + periods;
    return ticks / ticks_per_metre;
  }
  void ask(double metres_per_second) {
    const double exact = metres_per_second * ticks_per_metre * kPeriodSeconds + carry;
    speed = static_cast<int>(std::lround(std::clamp<double>(exact, -kTopTicks, kTopTicks)));
    carry = std::clamp(exact - speed, -0.5, 0.5);
  }
  void stand() {
    carry = 0.0;
    speed = 0;
    clear_stall();
  }
  void clear_stall() {
    debt = 0;
    held = 0;
  }
  [[nodiscard]] bool stalled() const { return debt >= kStallDebt && held >= kStallPeriods; }
  [[nodiscard]] int on_board() const { return reversed ? -speed : speed; }
};

/// What was driven between two counts.
struct Stretch {
  robot::PathStep path;
  double seconds = 0.0;
};

}  // namespace

struct HostDrive::Impl {
  explicit Impl(const HostDriveSettings& given)
      : settings(given),
        controller(limits_of(given, kPeriodSeconds, {})),
        timeout_periods(static_cast<int>(
            std::clamp(std::ceil(given.stall_timeout / kPeriodSeconds - 1e-9), 1.0, 1e9))) {
    left.reversed = given.left_reversed;
    right.reversed = given.right_reversed;
    left.ticks_per_metre = given.left_ticks_per_metre;
    right.ticks_per_metre = given.right_ticks_per_metre;
  }

  /// Where the next ramp starts: from what is commanded, or found when the program drove itself.
  [[nodiscard]] Twist present() const { return engaged ? controller.twist() : latest; }
  void engage() {
    engaged = true;
    left.clear_stall();
    right.clear_stall();
  }
  void stand() {
    left.stand();
    right.stand();
    rolling = {};
  }

  [[nodiscard]] double longest_step() const { return std::max(kLongestStep, cycle.usual); }
  void note_gap(double gap) {
    cycle.usual += (gap - cycle.usual) / kCycles;
    // What was late once may be so again for a while.
    const double forgotten = cycle.worst - (cycle.worst - gap) * std::min(1.0, gap / kMemory);
    cycle.worst = std::min(std::max(gap, forgotten), longest_step());
  }

  /// What the wheels did since the last counts goes into the odometry.
  robot::PathStep roll(const WheelCounts& counts, int periods) {
    const robot::WheelTravel wheels{left.travel(counts.left, periods),
                                    right.travel(counts.right, periods)};
    const robot::PathStep path = robot::path_of(wheels, settings.wheel_base);
    odometry.add(robot::arc_of(path));
    return path;
  }

  void measure(const WheelCounts& counts, double seconds, int periods) {
    const robot::PathStep path = roll(counts, periods);
    latest = {path.distance / seconds, path.angle / seconds};
    recent[next_recent] = {path, seconds};
    next_recent = (next_recent + 1) % recent.size();
    Stretch sum;
    for (const Stretch& one : recent) {
      sum.path.distance += one.path.distance;
      sum.path.angle += one.path.angle;
      sum.seconds += one.seconds;
    }
    measured = {sum.path.distance / sum.seconds, sum.path.angle / sum.seconds};
    if (!engaged) return;
    controller.advance(path);
    const bool given_up = (left.stalled() && left.held >= timeout_periods) ||
                          (right.stalled() && right.held >= timeout_periods);
    if (given_up && controller.state() == robot::DriveState::Driving) {
      failed_left = left.stalled();
      failed_right = right.stalled();
      controller.fail();
    }
  }

  /// For speeds that are sent `late` seconds after the counts, and hold for `seconds`.
  void command(double seconds, double late) {
    if (!engaged || controller.at_rest()) {
      stand();
      return;
    }
    controller.set_limits(limits_of(settings, seconds, cycle));
    // What was told before goes on until then.
    const double ahead = settings.motor_lag + late;
    const Twist twist = controller.next({rolling.linear * ahead, rolling.angular * ahead});
    // What the wheels are believed to do: a first-order lag after what is asked of them. The
    // counts themselves are too coarse for a speed from one period to the next.
    const double part = settings.motor_lag > seconds ? seconds / settings.motor_lag : 1.0;
    rolling.linear += part * (twist.linear - rolling.linear);
    rolling.angular += part * (twist.angular - rolling.angular);
    const double turning = twist.angular * settings.wheel_base / 2;
    left.ask(twist.linear - turning);
    right.ask(twist.linear + turning);
  }

  HostDriveSettings settings;
  robot::DriveController controller;
  robot::Odometry odometry;
  int timeout_periods;
  Side left;
  Side right;
  std::optional<Time> last;
  std::array<Stretch, kMeasured> recent{};
  std::size_t next_recent = 0;
  Cycle cycle;
  Twist measured;  ///< Over all of `recent`.
  Twist latest;    ///< Of the last one alone.
  Twist rolling;
  bool engaged = false;
  bool failed_left = false;  ///< Which wheels made the last goal fail.
  bool failed_right = false;
};

HostDrive::HostDrive(const HostDriveSettings& settings) : impl_(std::make_unique<Impl>(settings)) {}
HostDrive::~HostDrive() = default;

void HostDrive::set_speed(const Twist& twist) {
  const Twist present = impl_->present();
  impl_->engage();
  impl_->controller.set_speed(twist, present);
}

void HostDrive::start(const DriveGoal& goal) {
  const Twist present = impl_->present();
  impl_->engage();
  impl_->controller.start(goal, present);
}

void HostDrive::release() {
  halt();
  impl_->engaged = false;
}

bool HostDrive::engaged() const { return impl_->engaged; }

Result<WheelSpeeds> HostDrive::step(const WheelCounts& counts, Time counted, Time late) {
  Impl& self = *impl_;
  double seconds = kPeriodSeconds;
  if (self.last) {
    const Time gap = counted - *self.last;
    if (gap > kLongestGap) {
      const bool driving = self.controller.state() == robot::DriveState::Driving;
      const bool is_known = gap <= kLongestCount;
      if (is_known) (void)self.roll(counts, 1);
      restart();
      if (is_known) self.last = counted;
      self.failed_left = self.failed_right = false;
      if (driving) self.controller.fail();
      return fail(Errc::Timeout, "drive: the encoders were not read for " +
                                     std::to_string(std::llround(to_seconds(gap) * 1000)) + " ms" +
                                     (is_known ? "" : ": what was driven meanwhile is unknown"));
    }
    const int periods = static_cast<int>((gap + kPeriod / 2) / kPeriod);
    if (periods < 1) return WheelSpeeds{self.left.on_board(), self.right.on_board()};
    self.measure(counts, to_seconds(gap), periods);
    self.note_gap(to_seconds(gap));
    // The next gap is taken to be as long as this one, unless it was an exception.
    if (periods > 1) seconds = std::min(to_seconds(gap), self.longest_step());
  } else {
    self.left.count = counts.left;
    self.right.count = counts.right;
  }
  self.last = counted;
  self.command(seconds, to_seconds(late));
  return WheelSpeeds{self.left.on_board(), self.right.on_board()};
}

double HostDrive::cycle() const { return impl_->cycle.usual; }

void HostDrive::halt() {
  impl_->controller.stop();
  impl_->stand();
}

void HostDrive::restart() {
  halt();
  impl_->measured = impl_->latest = {};
  impl_->recent = {};
  impl_->last.reset();
}

DriveStatus HostDrive::status() const {
  const robot::DriveState state = impl_->controller.state();
  DriveStatus out;
  out.remaining = impl_->controller.remaining();
  if (state == robot::DriveState::Failed) {
    out.progress = DriveProgress::Failed;
    out.stalled_left = impl_->failed_left;
    out.stalled_right = impl_->failed_right;
    return out;
  }
  if (state == robot::DriveState::Driving) out.progress = DriveProgress::Driving;
  out.stalled_left = impl_->left.stalled();
  out.stalled_right = impl_->right.stalled();
  return out;
}

Twist HostDrive::measured_twist() const { return impl_->measured; }
Pose HostDrive::odometry() const { return impl_->odometry.pose(); }
void HostDrive::set_odometry(const Pose& pose) { impl_->odometry.set(pose); }

}  // namespace eyebridge::hal
