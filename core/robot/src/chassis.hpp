#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "drive_faults.hpp"
#include "eyebridge/base/hash.hpp"
#include "eyebridge/robot/arc.hpp"
#include "eyebridge/robot/drive_controller.hpp"
#include "eyebridge/robot/robot_model.hpp"
#include "motor.hpp"

namespace eyebridge::robot {

/// A number for each wheel: travel of its rim in a step, metres, or its speed. 0 for those that a
/// drive does not have.
using Rims = std::array<double, kMostWheels>;

/// How one step of the ground differs from what wheels make of it.
struct Ground {
  double way = 1.0;     ///< Factor of the way.
  double turn = 1.0;    ///< Factor of the turn.
  double uneven = 0.0;  ///< By how much more, as a fraction, the right side rolls than the left.
};

/// A wheel of a chassis, its motor, if it has one of its own, and its encoder.
struct ChassisWheel {
  Wheel wheel;
  MotorModel motor;
  MotorCommand command;
  std::int64_t seen_ticks = 0;  ///< By odometry, where it sees whole ticks only.
  double side = 0.0;            ///< 1 left, -1 right, 0 on the middle line.
  double grip = 1.0;            ///< Of its travel, the share that the ground makes of it.
  bool rolls = true;            ///< The ground moves it, and what holds the robot holds it.
  bool is_apart = false;        ///< Its motor runs beside v-omega driving.
};

/// Wheels, motors and steering of a drive, and what they do to the robot. What a step asks of it,
/// and in which order, is in step.cpp.
///
/// Which wheel is which: DriveKind. Metres, radians, seconds.
class Chassis {
 public:
  /// All wheels alike, with `motor`.
  Chassis(const DriveModel& model, const MotorModel& motor);
  virtual ~Chassis() = default;
  Chassis(const Chassis&) = delete;
  Chassis& operator=(const Chassis&) = delete;

  /// Drives the motors for a step as `controller` wants, which asks for `twist` in this one; what
  /// the rims do then.
  virtual Rims follow(const DriveController& controller, const Twist& twist) = 0;
  /// Likewise by the commands that motors and steering have of their own.
  virtual Rims run();
  /// What the ground makes of the rims' travel.
  [[nodiscard]] virtual BodyStep ground(const Rims& travel, const Ground& ground) const;
  /// What odometry makes of it: `forward` and `angle` are what the controller counts.
  [[nodiscard]] virtual BodyStep seen(const Rims& travel) const = 0;
  /// What is left of the rims' travel where an obstacle lets the robot make only `progress` of its
  /// way, 0 … 1.
  [[nodiscard]] virtual Rims blocked(const Rims& travel, double progress) const;
  /// How fast the robot was in a step of `dt` seconds that it made `progress` of.
  [[nodiscard]] virtual HolonomicTwist speed(const BodyStep& step, double progress,
                                             double dt) const;
  /// Whether the body turns, too, where something is in its way.
  [[nodiscard]] virtual bool can_turn_on_spot() const { return true; }
  /// The step is over: so far the rims went; with `held` an obstacle stopped them.
  virtual void settle(const Rims& travel, const Ground& ground, bool held);
  /// True while the controller wants what this drive cannot do at all: a turn on the spot.
  [[nodiscard]] virtual bool is_stuck() const { return false; }
  /// True when nothing but motors and controller would go on by itself.
  [[nodiscard]] virtual bool is_settled() const { return true; }
  /// True when a step with the same commands to the same wheels does the same, for ever: nothing
  /// else of this drive is under way. Only then a Cruise can take over.
  [[nodiscard]] virtual bool repeats() const { return false; }

  /// Starts `goal` with `controller`, from the speed `present`.
  virtual void start(const DriveGoal& goal, const Twist& present, DriveController& controller);
  /// Asked after each step: goes on with what is left of a goal.
  virtual void go_on(DriveController& /*controller*/) {}
  /// Drives at `twist` with `controller`, from `present`, as nearly as such wheels can.
  virtual void set_twist(const HolonomicTwist& twist, const Twist& present,
                         DriveController& controller);
  /// Another command comes: what the last set_twist() or start() left here is void.
  virtual void release() {}
  /// Likewise, and at once.
  virtual void stop() { release(); }
  /// The wheels stand still at once; the running command goes on.
  virtual void halt();

  /// Turns the steering by hand from now on, clamped; does nothing where there is none.
  virtual void set_steering(double /*angle*/) {}
  /// Where the steered wheels point, radians from the robot's front.
  [[nodiscard]] virtual double steering() const { return 0.0; }

  /// How far what dives is above the floor, metres; others stay on it.
  [[nodiscard]] virtual double altitude() const { return 0.0; }
  /// Its altitude where it floats, metres.
  [[nodiscard]] virtual double highest() const { return 0.0; }
  /// Puts it there, clamped to the water, without vertical speed.
  virtual void set_altitude(double /*altitude*/) {}

  virtual void add_to(StateHash& hash) const;

  /// Of what the motors do now: how fast the robot goes …
  [[nodiscard]] Twist present() const;
  /// … and how far it rolls when they are told to stand still.
  [[nodiscard]] virtual PathStep rolling() const;
  /// True when a motor that moves it in the plane has a command to turn.
  [[nodiscard]] bool is_commanded() const;
  /// Drops the commands of these motors.
  void drop_commands();

  /// Throws std::out_of_range when there is no such motor, or encoder.
  ChassisWheel& motor(unsigned index);
  ChassisWheel& encoder(unsigned index);
  std::span<ChassisWheel> wheels() { return wheels_; }

 protected:
  /// What the rims do when the motors do that: the same, unless a gear is between.
  [[nodiscard]] virtual Rims rims_of(const Rims& motors) const { return motors; }
  /// Drives motor `index` by the command that it has of its own; its travel.
  double obey(std::size_t index);
  /// Drives motor `index` with PID, at `speed` of the rim; its travel.
  double drive(std::size_t index, double speed) {
    return wheels_[index].wheel.drive_controlled(speed, wheels_[index].motor);
  }

  void add_wheels_to(StateHash& hash) const;

  // At hand in one block: what a step touches.
  unsigned motor_count_;
  unsigned encoder_count_;
  double wheel_base_;
  std::span<ChassisWheel> wheels_;
  std::array<ChassisWheel, kMostWheels> storage_;  ///< Of `wheels_`.
};

/// Throws std::invalid_argument, which says `what`, unless the model is `good`.
void check_model(bool good, const char* what);
/// Throws std::invalid_argument when the axles have no distance. Written so that NaN fails, too.
inline void check_axles(const DriveModel& drive) {
  check_model(drive.axle_distance > 0.0, "robot: the distance between the axles must be positive");
}

/// DriveFacts::make_chassis.
using ChassisMaker = std::unique_ptr<Chassis>(const RobotModel& robot, const MotorModel& motor,
                                              double water);

}  // namespace eyebridge::robot
