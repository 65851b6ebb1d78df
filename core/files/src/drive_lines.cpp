#include "drive_lines.hpp"

#include <string>
#include <vector>

#include "eyebridge/base/units.hpp"

namespace eyebridge::files {
namespace {

constexpr double kLargestRobot = 10000;  // millimetres: no robot is larger

std::string kind_names() {
  std::vector<std::string_view> names;
  for (const robot::DriveFacts& facts : robot::drive_kinds()) names.push_back(facts.keyword);
  return one_of(names);
}

}  // namespace

bool DriveLines::read(const Statement& s, bool new_dialect) {
  const std::string keyword = lower(s.text(0));
  if (keyword == "drive") {
    read_drive(s);
  } else if (keyword == "wheel") {
    read_wheel(s, new_dialect);
  } else if (keyword == "axel") {
    read_axel(s);
  } else if (keyword == "speed") {
    s.expect_arguments(1, "speed MM_PER_SECOND");
    speed_ = s.millimetres(1, "the speed", 1, 1e6);
  } else if (keyword == "turn") {
    s.expect_arguments(1, "turn DEG_PER_SECOND");
    turn_ = deg_to_rad(s.number(1, "the turning speed", 1, 1e6));
  } else if (keyword == "axles") {
    s.expect_arguments(1, "axles MM");
    axles_ = s.millimetres(1, "the distance between the axles", 1, kLargestRobot);
  } else if (keyword == "steering") {
    read_steering(s);
  } else if (keyword == "dive") {
    read_dive(s);
  } else {
    return false;
  }
  return true;
}

void DriveLines::read_drive(const Statement& s) {
  if (s.size() < 2) s.fail(1, "line ends: expected the kind of drive");
  const std::string name = lower(s.text(1));
  for (const robot::DriveFacts& facts : robot::drive_kinds()) {
    if (name != lower(facts.keyword)) continue;
    drive_.kind = facts.kind;
    line_ = s.line();
    return;
  }
  s.fail(1, "unknown drive " + in_quotes(s.text(1)) + ": expected " + kind_names());
}

void DriveLines::read_wheel(const Statement& s, bool new_dialect) {
  const bool named = s.size() > 1 && !s.is_number(1);
  if (named && lower(s.text(1)) != "drive" && lower(s.text(1)) != "turn") {
    s.fail(1, in_quotes(s.text(1)) + " found: expected 'drive', 'turn' or a diameter");
  }
  const std::size_t first = named ? 2 : 1;
  s.expect_arguments(first + 3, "wheel [drive|turn] diameter max_deg_per_second ticks distance");
  robot::DriveModel drive = drive_;
  drive.wheel_diameter = s.millimetres(first, "the diameter", 1, kLargestRobot);
  drive.max_wheel_speed = deg_to_rad(s.number(first + 1, "the wheel's speed", 1, 1e6));
  drive.ticks_per_revolution = s.number(first + 2, "ticks per revolution", 1, 1e7);
  drive.wheel_base = s.millimetres(first + 3, "the wheels' distance", 1, kLargestRobot);
  // EyeSim VR places the wheels this far to either side of the centre; its forerunners meant the
  // distance between them (S4: 45 in the one, 90 in the other).
  if (new_dialect) drive.wheel_base *= 2;
  if (named && lower(s.text(1)) == "turn") return;
  drive_ = drive;
  wheels_ = true;
}

void DriveLines::read_axel(const Statement& s) {
  s.expect_arguments(3, "axel drive|turn vertical horizontal");
  const std::string which = lower(s.text(1));
  if (which != "drive" && which != "turn") {
    s.fail(1, in_quotes(s.text(1)) + " found: expected 'drive' or 'turn'");
  }
  static_cast<void>(s.millimetres(2, "the vertical offset", -kLargestRobot, kLargestRobot));
  const double x = s.millimetres(3, "the horizontal offset", -kLargestRobot, kLargestRobot);
  (which == "drive" ? rear_ : front_) = Axle{s.where(3), x};
}

void DriveLines::read_steering(const Statement& s) {
  s.expect_arguments({1, 2, 3}, "steering max_deg [servo [deg_per_second]]");
  Steering steering;
  steering.where = s.where(0);
  steering.most = deg_to_rad(s.number(1, "the most that the wheels turn", 1, 80));
  if (s.size() > 2) {
    steering.servo = static_cast<unsigned>(s.integer(2, "the servo", 1, 16) - 1);
  }
  steering.servo_where = s.where(s.size() > 2 ? 2 : 0);
  if (s.size() > 3) {
    steering.speed = deg_to_rad(s.number(3, "the speed of the steering", 1, 1e6));
  }
  steering_ = steering;
}

void DriveLines::read_dive(const Statement& s) {
  s.expect_arguments(3, "dive mm_per_second rise_mm_per_second glide_seconds");
  Dive dive;
  dive.where = s.where(0);
  dive.vertical = s.millimetres(1, "the vertical speed", 1, 1e5);
  dive.rise = s.millimetres(2, "the speed of rising by itself", -1e5, 1e5);
  dive.glide = s.number(3, "the time constant of its drag in seconds", 0.01, 1000);
  dive_ = dive;
}

void DriveLines::finish_axles(robot::DriveModel& drive) const {
  if (axles_) drive.axle_distance = *axles_;
  const bool car = drive.facts().steers_front();
  if (car && rear_) drive.rear_axle = rear_->x;
  if (car && rear_ && front_) {
    if (front_->x <= rear_->x) {
      throw ConfigError(front_->where,
                        "the front axle is not before the rear one: expected 'axel turn' ahead of "
                        "'axel drive'");
    }
    if (!axles_) drive.axle_distance = front_->x - rear_->x;
  } else if (!axles_ && wheels_) {
    drive.axle_distance = drive.wheel_base;
    if (!car) return;
    warnings_.add(line_, 1,
                  "neither 'axel drive' and 'axel turn' nor 'axles' say how far apart the axles "
                  "are: it is as far as the wheels");
  }
}

void DriveLines::finish_steering(robot::RobotModel& model) const {
  if (!steering_) return;
  robot::DriveModel& drive = model.drive;
  if (!drive.facts().steers_front()) {
    throw ConfigError(steering_->where, "steering without front wheels: expected ACKERMANN_DRIVE");
  }
  drive.max_steering = steering_->most;
  drive.steering_servo = steering_->servo;
  drive.steering_speed = steering_->speed;
  if (model.kicker && model.kicker->servo == drive.steering_servo) {
    throw ConfigError(steering_->servo_where, "servo " + std::to_string(drive.steering_servo + 1) +
                                                  " kicks already: expected another one to steer");
  }
}

void DriveLines::finish_submarine(robot::DriveModel& drive) const {
  if (!drive.facts().dives) {
    if (!dive_) return;
    throw ConfigError(dive_->where, "dive without thrusters: expected SUBMARINE_DRIVE");
  }
  if (wheels_) warnings_.add(line_, 1, "a submarine has no wheels: its 'wheel' is not used");
  if (!speed_ || !turn_ || !dive_) {
    warnings_.add(
        line_, 1,
        "a submarine needs 'speed', 'turn' and 'dive': a missing line counts as 'speed 500', "
        "'turn 45' or 'dive 250 20 1'");
  }
  const Dive dive = dive_.value_or(Dive{});
  drive.max_linear = speed_.value_or(0.5);
  drive.max_angular = turn_.value_or(deg_to_rad(45));
  drive.max_vertical = dive.vertical;
  drive.rise_speed = dive.rise;
  drive.motor_time_constant = dive.glide;
  // So that both thrusters at full duty give these speeds.
  drive.wheel_diameter = robot::DriveModel{}.wheel_diameter;
  drive.max_wheel_speed = 2 * drive.max_linear / drive.wheel_diameter;
  drive.wheel_base = 2 * drive.max_linear / drive.max_angular;
}

void DriveLines::finish(robot::RobotModel& model) {
  // The acceleration comes from a line of both kinds of files.
  drive_.linear_acceleration = model.drive.linear_acceleration;
  drive_.angular_acceleration = model.drive.angular_acceleration;
  model.drive = drive_;
  robot::DriveModel& drive = model.drive;
  finish_axles(drive);
  finish_steering(model);
  finish_submarine(drive);
  if (drive.facts().dives) return;
  if (wheels_) drive.max_linear = drive.max_wheel_speed * drive.wheel_diameter / 2;
  if (speed_) drive.max_linear = *speed_;
  if (wheels_ && drive.turn_arm() > 0.0) {
    // As fast as the wheels can turn it.
    drive.max_angular = drive.max_wheel_speed * drive.wheel_diameter / 2 / drive.turn_arm();
  }
  if (drive.facts().steers_front()) {
    drive.max_angular = drive.max_linear * drive.max_curvature();
  }
  if (turn_) drive.max_angular = *turn_;
}

}  // namespace eyebridge::files
