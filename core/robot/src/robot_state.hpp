#pragma once

#include <array>
#include <memory>
#include <vector>

#include "drive_faults.hpp"
#include "errors.hpp"
#include "eyebridge/robot/drive_controller.hpp"
#include "eyebridge/robot/odometry.hpp"
#include "motor.hpp"
#include "sensing.hpp"

namespace eyebridge::robot {

/// What set_motor_duty() and set_motor_speed() want of a wheel.
struct MotorCommand {
  double speed = 0.0;       ///< Of the rim, metres per second.
  bool controlled = false;  ///< By PID; else as duty.
};

/// Everything about a robot that step() touches: one block of memory a robot.
struct RobotState {
  RobotState(const RobotModel& model, const SimulationSettings& settings, world::BodyId body_id,
             Random drive_noise, const DriveFaults& fault_noise);

  /// How fast the robot is meant to go now: where the next ramp starts.
  [[nodiscard]] Twist present() const;
  /// How far the robot still rolls when the motors are told to stand still.
  [[nodiscard]] PathStep rolling() const;
  /// Takes the robot out of v-omega control (or finds it there already).
  void use_motors();
  /// Gives the robot back to v-omega control, and forgets a stall: a new command came.
  void use_controller();
  void clear_stall();
  /// From now on the drive errs as `model` says; `fault_noise` is what its faults draw from.
  void set_error(const RobotModel& model, double dt, const DriveFaults& fault_noise);

  world::BodyId body;
  bool by_motors = false;
  unsigned stalled = kStallNone;
  std::uint32_t stalled_steps = 0;
  double wheel_base;
  MotorModel motor;
  DriveController controller;
  std::array<Wheel, 2> wheels;
  std::array<MotorCommand, 2> commands;
  Odometry odometry;
  std::array<std::int64_t, 2> seen_ticks{};  ///< By odometry, where it sees whole ticks only.
  Twist driven;
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

/// What is needed only when someone asks.
struct RobotDevices {
  RobotDevices(const RobotModel& robot_model, std::uint64_t seed, std::uint32_t robot);

  RobotModel model;
  std::vector<RayDevice> ranges;
  std::vector<RayDevice> proximities;
  std::vector<Random> bumpers;
  Random compass;
  Random lidar;
  ScanShape scan;
  std::vector<Vec2> scan_directions;
  std::array<double, kServoCount> servos;
};

}  // namespace eyebridge::robot
