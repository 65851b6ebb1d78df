#include "robot_state.hpp"

#include <limits>
#include <utility>

namespace eyebridge::robot {
namespace {

// A goal counts as reached this near. Without lag only rounding is left; with it the last bit of
// the way is an ever slower creep that no robot drives.
constexpr double kExact = 1e-10;         // metres, radians
constexpr double kCreepDistance = 1e-4;  // metres
constexpr double kCreepAngle = 1e-3;     // radians
// What a car's heading lacks at the end of its way it cannot mend there.
constexpr double kCarAngle = deg_to_rad(1);

MotorModel motor_of(const DriveModel& drive, double dt) {
  MotorModel motor;
  motor.dt = dt;
  motor.top = drive.max_wheel_speed * drive.wheel_diameter / 2;
  motor.time_constant = drive.motor_time_constant;
  if (drive.motor_time_constant > 0.0) {
    motor.decay = decay_of(dt / drive.motor_time_constant);
    motor.lag = drive.motor_time_constant * (1.0 - motor.decay);
  }
  motor.ticks_per_metre = drive.ticks_per_revolution / (kPi * drive.wheel_diameter);
  return motor;
}

double speed_step(double acceleration, double dt) {
  return acceleration > 0.0 ? acceleration * dt : std::numeric_limits<double>::infinity();
}

DriveLimits limits_of(const RobotModel& model, double dt) {
  const DriveModel& drive = model.drive;
  DriveLimits limits;
  limits.dt = dt;
  limits.linear = drive.max_linear;
  limits.angular = drive.max_angular;
  limits.linear_step = speed_step(drive.linear_acceleration, dt);
  limits.angular_step = speed_step(drive.angular_acceleration, dt);
  limits.wheel = drive.max_wheel_speed * drive.wheel_diameter / 2;
  limits.half_base = drive.turn_arm();
  const bool lags = drive.motor_time_constant > 0.0;
  limits.distance_end = lags ? kCreepDistance : kExact;
  limits.angle_end = lags ? kCreepAngle : kExact;
  if (model.drive_error.counts_ticks()) {
    // A goal between two ticks is reached at either of them.
    const double tick = kPi * drive.wheel_diameter / drive.ticks_per_revolution;
    limits.distance_end += tick;
    const bool steered = drive.facts().steering == Steering::AllWheels;
    limits.angle_end += tick / (steered ? drive.wheel_diameter / 2 : drive.wheel_base);
  }
  const bool steers_late = drive.steering_speed > 0.0 || lags || model.drive_error.counts_ticks();
  if (drive.facts().steers_front() && steers_late) limits.angle_end += kCarAngle;
  return limits;
}

std::vector<RayDevice> ray_devices(const auto& models, std::uint64_t seed, std::uint32_t robot,
                                   NoiseSource source) {
  std::vector<RayDevice> devices;
  for (const auto& model : models) {
    devices.push_back(
        {Sight(model.pose_in_robot), noise_stream(seed, robot, source, devices.size())});
  }
  return devices;
}

}  // namespace

RobotState::RobotState(const RobotModel& model, const SimulationSettings& settings, double water,
                       Random drive_noise, const DriveFaults& fault_noise)
    : chassis(model.drive.facts().make_chassis(model, motor_of(model.drive, settings.step), water)),
      differential(dynamic_cast<DifferentialChassis*>(chassis.get())),
      controller(limits_of(model, settings.step)),
      noise(drive_noise) {
  set_error(model, settings.step, fault_noise);
}

Twist RobotState::present() const { return by_motors ? chassis->present() : controller.twist(); }

void RobotState::use_motors() {
  clear_stall();
  if (by_motors) return;
  controller.stop();
  by_motors = true;
  chassis->release();
  chassis->drop_commands();
}

void RobotState::use_controller() {
  clear_stall();
  by_motors = false;
  chassis->release();
}

void RobotState::set_error(const RobotModel& model, double dt, const DriveFaults& fault_noise) {
  const DriveError& wanted = model.drive_error;
  if (wanted.counts_ticks() && !error.counts_ticks()) {
    // Odometry goes on from here; what the encoders counted before is not travel of the next step.
    for (ChassisWheel& w : chassis->wheels()) w.seen_ticks = w.wheel.raw_ticks(w.motor);
  }
  const bool has_faults = wanted.slip > 0.0 || wanted.encoder_miss > 0.0;
  if (has_faults && !faults) faults = std::make_unique<DriveFaults>(fault_noise);
  error = wanted;
  plan.ground = {.uneven = error.right_scale - error.left_scale};
  for (ChassisWheel& w : chassis->wheels()) {
    if (!w.rolls) continue;
    w.grip = 1.0 + (error.left_scale * (1.0 + w.side) + error.right_scale * (1.0 - w.side)) / 2;
  }
  controller.set_limits(limits_of(model, dt));
}

void RobotState::stand() {
  chassis->halt();
  driven = driven_before = {};
  measured = {};
}

void RobotState::clear_stall() {
  stalled = kStallNone;
  stalled_steps = 0;
}

RobotDevices::RobotDevices(const RobotModel& robot_model, std::uint64_t seed, std::uint32_t robot)
    : model(robot_model),
      ranges(ray_devices(robot_model.range_sensors, seed, robot, NoiseSource::Range)),
      proximities(ray_devices(robot_model.proximity_sensors, seed, robot, NoiseSource::Proximity)),
      compass(noise_stream(seed, robot, NoiseSource::Compass, 0)),
      lidar(noise_stream(seed, robot, NoiseSource::Lidar, 0)),
      gyroscope(noise_stream(seed, robot, NoiseSource::Gyroscope, 0)),
      accelerometer(noise_stream(seed, robot, NoiseSource::Accelerometer, 0)) {
  for (std::size_t i = 0; i < model.bumpers.size(); ++i) {
    bumpers.push_back(noise_stream(seed, robot, NoiseSource::Bumper, i));
  }
  for (std::size_t i = 0; i < model.range_matrices.size(); ++i) {
    range_matrices.push_back(noise_stream(seed, robot, NoiseSource::RangeMatrix, i));
  }
  servos.fill(0.5);
}

}  // namespace eyebridge::robot
