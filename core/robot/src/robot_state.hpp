#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "differential_chassis.hpp"
#include "drive_faults.hpp"
#include "errors.hpp"
#include "eyebridge/robot/drive_controller.hpp"
#include "eyebridge/robot/odometry.hpp"
#include "known_rays.hpp"
#include "motor.hpp"
#include "range_layout.hpp"
#include "sensing.hpp"

namespace eyebridge::robot {

/// What a step does.
struct StepPlan {
  Rims rims;             ///< Travel of the wheels; less where something was in the way.
  Ground ground;         ///< What they stand on.
  BodyStep step;         ///< What the ground makes of them, unless something is in the way.
  world::Arc arc;        ///< Of `step`.
  bool repeats = false;  ///< The next step will be like it, unless a command comes.
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
  /// `water`: how deep it is, metres; of submarines. Throws std::invalid_argument when the model
  /// cannot be.
  RobotState(const RobotModel& model, const SimulationSettings& settings, double water,
             Random drive_noise, const DriveFaults& fault_noise);

  /// How fast the robot is meant to go now: where the next ramp starts.
  [[nodiscard]] Twist present() const;
  /// Whether a command tells its motors to turn, or they still slow down.
  [[nodiscard]] bool is_told_to_move() const {
    return by_motors ? chassis->is_commanded() : !controller.at_rest();
  }
  /// Takes the robot out of v-omega control (or finds it there already).
  void use_motors();
  /// Gives the robot back to v-omega control, and forgets a stall: a new command came.
  void use_controller();
  void clear_stall();
  /// Nothing moves it any more, and nothing did.
  void stand();
  /// From now on the drive errs as `model` says; `fault_noise` is what its faults draw from.
  void set_error(const RobotModel& model, double dt, const DriveFaults& fault_noise);

  world::BodyId body = world::kNoBody;
  bool by_motors = false;  ///< Not by v-omega control.
  /// In the last step something held it from the start; the wheels stood at the start of this one.
  bool held_before = false;
  bool has_left = false;  ///< The world: it makes no steps.
  unsigned stalled = kStallNone;
  std::uint32_t stalled_steps = 0;
  StepPlan plan;  ///< Of the last step.
  std::unique_ptr<Chassis> chassis;
  DifferentialChassis* differential;  ///< `chassis`, if it is one.
  DriveController controller;
  Odometry odometry;
  KnownAngle odometry_angle;  ///< Of `odometry`.
  HolonomicTwist driven;
  HolonomicTwist driven_before;  ///< In the step before the last.
  Twist measured;
  DriveError error;
  Random noise;
  std::unique_ptr<DriveFaults> faults;  ///< Null unless there is slip or ticks are missed.
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
  KnownRays known_rays;  ///< Of the range sensors.
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
