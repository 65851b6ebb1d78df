#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "chassis.hpp"
#include "drive_faults.hpp"
#include "errors.hpp"
#include "eyebridge/robot/drive_controller.hpp"
#include "eyebridge/robot/odometry.hpp"
#include "motor.hpp"
#include "range_layout.hpp"
#include "sensing.hpp"

namespace eyebridge::robot {

/// What a step wants to do, before the world says how much of it is possible.
struct StepPlan {
  WheelTravel wheels;
  PathStep path;   ///< What the ground makes of them.
  world::Arc arc;  ///< Of `path`.
};

/// The angle of a heading that is asked for again and again, and mostly has not changed.
class KnownAngle {
 public:
  double of(Heading heading) {
    if (!(heading == heading_)) {
      heading_ = heading;
      angle_ = heading.angle();
    }
    return angle_;
  }

 private:
  Heading heading_;
  double angle_ = 0.0;
};

/// Everything about a robot that step() touches: one block of memory a robot.
struct RobotState {
  /// `water`: how deep it is, metres; of submarines.
  RobotState(const RobotModel& model, const SimulationSettings& settings, double water,
             world::BodyId body_id, Random drive_noise, const DriveFaults& fault_noise);

  /// How fast the robot is meant to go now: where the next ramp starts.
  [[nodiscard]] Twist present() const;
  /// How far the robot still rolls when the motors are told to stand still.
  [[nodiscard]] PathStep rolling() const;
  /// Takes the robot out of v-omega control (or finds it there already).
  void use_motors();
  /// Gives the robot back to v-omega control, and forgets a stall: a new command came.
  void use_controller();
  void clear_stall();
  /// The wheels stand still at once.
  void halt();
  /// From now on the drive errs as `model` says; `fault_noise` is what its faults draw from.
  void set_error(const RobotModel& model, double dt, const DriveFaults& fault_noise);
  /// True when the next step, unless a command comes or something is in the way, makes the same
  /// plan again and changes nothing by making it. `speeds` are the wheels' before the last plan.
  [[nodiscard]] bool repeats(const std::array<double, 2>& speeds) const;

  /// True when, beyond that, odometry sees what the ground does, so that a Cruise can take over.
  [[nodiscard]] bool cruises(const PathStep& seen) const {
    return steady && !by_motors && !error.counts_ticks() && seen == plan.path;
  }

  /// True when a step that ended as this one, held from the start, is followed by just such steps.
  [[nodiscard]] bool presses() const {
    return held_before && controller.state() != DriveState::Driving && !error.moves_by_chance();
  }

  world::BodyId body;
  bool steady = false;  ///< `plan` holds for the next step, too.
  bool held_before =
      false;  ///< In the last step, from its start; the wheels stood at the start of this one.
  bool by_motors = false;
  bool has_left = false;  ///< The world: it makes no steps.
  world::ContactLaw contact;
  unsigned stalled = kStallNone;
  std::uint32_t stalled_steps = 0;
  StepPlan plan;  ///< Of the last step.
  double wheel_base;
  MotorModel motor;
  DriveController controller;
  std::array<Wheel, 2> wheels;
  std::array<MotorCommand, 2> commands;
  Odometry odometry;
  KnownAngle odometry_angle;                 ///< Of `odometry`.
  std::array<std::int64_t, 2> seen_ticks{};  ///< By odometry, where it sees whole ticks only.
  Twist driven;
  Twist driven_before;  ///< In the step before the last.
  Twist measured;
  DriveError error;
  Random noise;
  std::unique_ptr<DriveFaults> faults;  ///< Null unless there is slip or ticks are missed.
  /// What all but differential drives have instead of `wheels`, `commands` and `plan`; null of
  /// differential ones, which are most and have the short way.
  std::unique_ptr<Chassis> chassis;
  double driven_left = 0.0;  ///< Sideways, beside `driven`; of a chassis only.
  double driven_left_before = 0.0;
};

/// A range sensor or proximity switch with its ray and its noise.
struct RayDevice {
  Sight sight;
  Random noise;
};

/// True when none of the sensors has an error.
[[nodiscard]] inline bool all_perfect(const std::vector<RangeSensorModel>& sensors) {
  return std::all_of(sensors.begin(), sensors.end(),
                     [](const RangeSensorModel& sensor) { return sensor.error.perfect(); });
}

/// What reading all range sensors of a robot needs: half a cache line instead of three.
struct Eyes {
  std::shared_ptr<const RangeLayout> layout;  ///< Fits the model's range sensors.
  world::BodyId body = world::kNoBody;
  bool perfect = true;  ///< all_perfect() of the range sensors.
};

/// What is needed only when someone asks.
struct RobotDevices {
  RobotDevices(const RobotModel& robot_model, std::uint64_t seed, std::uint32_t robot);

  RobotModel model;
  std::vector<RayDevice> ranges;
  std::vector<RayDevice> proximities;
  std::vector<Random> bumpers;
  Random compass;
  Random lidar;
  std::vector<Random> range_matrices;
  Random gyroscope;
  Random accelerometer;
  double gyroscope_stray = 0.0;         ///< Of its bias, radians per second,
  std::uint64_t gyroscope_strayed = 0;  ///< after so many steps of the simulation.
  std::array<double, kServoCount> servos;
};

}  // namespace eyebridge::robot
