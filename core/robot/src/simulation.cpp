#include "eyebridge/robot/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "eyebridge/robot/body_colours.hpp"
#include "eyebridge/robot/error_presets.hpp"
#include "simulation_impl.hpp"

namespace eyebridge::robot {
namespace {

void check_servos(const RobotModel& model) {
  for (const ServoModel& servo : model.servos) {
    check_model(servo.servo >= 2 && servo.servo < kServoCount,
                "robot: servos of its own have the indices 2 to 15");
    check_model(servo.wheel == ServoModel::Wheel::None || model.drive.facts().has_two_wheels,
                "robot: servos turn the wheels of a differential drive only");
  }
}

/// What robots of all drives need; chassis check what is theirs.
void check(const RobotModel& model) {
  const DriveModel& drive = model.drive;
  // Written so that NaN fails, too.
  check_model(model.diameter > 0.0, "robot: the diameter must be positive");
  check_model(model.contact_friction >= 0.0 && std::isfinite(model.contact_friction),
              "robot: the friction against what it meets must be finite and not negative");
  check_model(drive.wheel_base > 0.0, "robot: the distance between the wheels must be positive");
  check_model(drive.wheel_diameter > 0.0, "robot: the wheel diameter must be positive");
  check_model(drive.ticks_per_revolution > 0.0, "robot: the encoder needs ticks");
  check_model(drive.max_wheel_speed > 0.0, "robot: the top wheel speed must be positive");
  check_model(drive.max_linear >= 0.0 && drive.max_angular >= 0.0,
              "robot: the top speeds must not be negative");
  check_model(drive.linear_acceleration >= 0.0 && drive.angular_acceleration >= 0.0,
              "robot: the accelerations must not be negative");
  check_model(!model.kicker || (model.kicker->speed >= 0.0 && model.kicker->servo < kServoCount),
              "robot: a kicker needs a servo and a speed that is not negative");
  check_servos(model);
  check_model(drive.motor_time_constant >= 0.0,
              "robot: the motor time constant must not be negative");
  std::for_each(model.range_sensors.begin(), model.range_sensors.end(), check_range_sensor);
  check_model(drive.steering_speed >= 0.0, "robot: the speed of the steering must not be negative");
  check_model(drive.max_vertical >= 0.0 && std::isfinite(drive.max_vertical) &&
                  std::isfinite(drive.rise_speed),
              "robot: vertical speeds must be finite, that of the thrusters not negative");
}

/// In whole steps, at least one; a time-out beyond what can be counted never comes.
std::uint32_t timeout_steps(const SimulationSettings& settings) {
  check_model(settings.step > 0.0 && std::isfinite(settings.step),
              "simulation: the step must be positive and finite");
  check_model(settings.stall_timeout >= 0.0, "simulation: the stall time-out must not be negative");
  const double steps = std::ceil(settings.stall_timeout / settings.step - 1e-9);
  return static_cast<std::uint32_t>(
      std::clamp(steps, 1.0, double{std::numeric_limits<std::uint32_t>::max()}));
}

}  // namespace

Simulation::Impl::Impl(std::shared_ptr<const world::WorldModel> model,
                       const SimulationSettings& given)
    : settings(given),
      world(std::move(model), given.seed),
      stall_timeout_steps(timeout_steps(given)) {}

Simulation::Simulation(std::shared_ptr<const world::WorldModel> model,
                       const SimulationSettings& settings)
    : impl_(std::make_unique<Impl>(std::move(model), settings)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

RobotIndex Simulation::add_robot(const RobotModel& model, const Pose& pose) {
  check(model);
  const double water = impl_->world.model().water_depth();
  const auto robot = static_cast<RobotIndex>(robot_count());
  const std::uint64_t seed = impl_->settings.seed;
  RobotState state(model, impl_->settings, water, noise_stream(seed, robot, NoiseSource::Drive, 0),
                   DriveFaults(seed, robot));
  const Rgb colour = body_colour(robot);
  const world::BodyId body = impl_->world.add_robot(pose, model.radius(), model.height, colour);
  state.body = body;
  Cruise& cruise = impl_->cruises.emplace_back();
  cruise.body = body;
  cruise.contact = {impl_->settings.slides, state.chassis->can_turn_on_spot(),
                    model.contact_friction};
  impl_->states.push_back(std::move(state));
  impl_->asked.push_back(Impl::kNothing);
  const std::shared_ptr<const RangeLayout> last =
      impl_->eyes.empty() ? nullptr : impl_->eyes.back().layout;
  const bool like_last = last && last->fits(model.range_sensors);
  impl_->eyes.push_back(
      {like_last ? last : std::make_shared<const RangeLayout>(model.range_sensors), body,
       all_perfect(model.range_sensors)});
  impl_->devices.emplace_back(model, seed, robot);
  impl_->devices.back().gyroscope_strayed = impl_->steps;
  return robot;
}

void Simulation::remove_robot(RobotIndex robot) {
  RobotState& state = impl_->command(robot);
  stop(robot);
  state.stand();
  state.has_left = true;
  impl_->world.remove(state.body);
}

bool Simulation::is_there(RobotIndex robot) const { return !impl_->at(robot).has_left; }

std::size_t Simulation::robot_count() const { return impl_->states.size(); }
const RobotModel& Simulation::model(RobotIndex robot) const {
  return impl_->devices_of(robot).model;
}

void Simulation::set_errors(RobotIndex robot, const RobotModel& like) {
  RobotDevices& devices = impl_->devices_of(robot);
  impl_->stray_gyroscope(robot);
  copy_errors(like, devices.model);
  impl_->eyes[robot].perfect = all_perfect(devices.model.range_sensors);
  const SimulationSettings& settings = impl_->settings;
  impl_->command(robot).set_error(devices.model, settings.step, DriveFaults(settings.seed, robot));
}

world::BodyId Simulation::body(RobotIndex robot) const { return impl_->body_of(robot); }

void Simulation::step() {
  const auto count = static_cast<RobotIndex>(robot_count());
  for (RobotIndex robot = 0; robot < count; ++robot) impl_->step_robot(robot);
  impl_->world.step_objects(impl_->settings.step);
  ++impl_->steps;
  if (!impl_->world.bumps().empty()) impl_->report_collisions();
}

double Simulation::time() const { return static_cast<double>(impl_->steps) * impl_->settings.step; }
const SimulationSettings& Simulation::settings() const { return impl_->settings; }

Pose Simulation::pose(RobotIndex robot) const { return impl_->world.pose(body(robot)); }

void Simulation::set_pose(RobotIndex robot, const Pose& pose) {
  RobotState& state = impl_->command(robot);
  if (state.has_left) return;
  impl_->world.set_pose(state.body, pose);
  state.stand();
  state.controller.hold({}, false);
  state.clear_stall();
}

Twist Simulation::twist(RobotIndex robot) const {
  const HolonomicTwist& driven = impl_->at(robot).driven;
  return {driven.linear, driven.angular};
}

void Simulation::set_speed(RobotIndex robot, const Twist& twist) {
  if (impl_->asked.at(robot) == twist) {
    // The same again changes nothing but that a stall is forgotten until the next step.
    const Cruise& cruise = impl_->cruises[robot];
    if (cruise.mode == Cruise::Mode::Pressed) impl_->at(robot).clear_stall();
    if (cruise.mode != Cruise::Mode::Off) return;
  }
  RobotState& state = impl_->command(robot);
  const Twist present = state.present();
  state.use_controller();
  state.controller.set_speed(twist, present);
  impl_->asked[robot] = twist;
}

void Simulation::drive(RobotIndex robot, const DriveGoal& goal) {
  RobotState& state = impl_->command(robot);
  const Twist present = state.present();
  state.use_controller();
  state.chassis->start(goal, present, state.controller);
}

DriveState Simulation::drive_state(RobotIndex robot) const {
  return impl_->at(robot).controller.state();
}
double Simulation::remaining(RobotIndex robot) const {
  return impl_->at(robot).controller.remaining();
}
unsigned Simulation::stalled(RobotIndex robot) const { return impl_->at(robot).stalled; }

bool Simulation::is_told_to_move(RobotIndex robot) const {
  return impl_->at(robot).is_told_to_move();
}

void Simulation::stop(RobotIndex robot) {
  RobotState& state = impl_->command(robot);
  state.use_controller();
  state.chassis->stop();
  state.controller.stop();
}

Pose Simulation::odometry(RobotIndex robot) const {
  const Odometry& odometry = impl_->at(robot).odometry;
  const Vec2 position = odometry.position();
  return {position.x, position.y, impl_->states[robot].odometry_angle.of(odometry.heading())};
}
void Simulation::set_odometry(RobotIndex robot, const Pose& pose) {
  impl_->command(robot).odometry.set(pose);
}
Twist Simulation::measured_twist(RobotIndex robot) const { return impl_->at(robot).measured; }

std::uint64_t Simulation::camera_noise_seed(RobotIndex robot) const {
  return noise_stream(impl_->settings.seed, robot, NoiseSource::Camera, 0).bits();
}

const world::World& Simulation::world() const { return impl_->world; }
world::World& Simulation::world() { return impl_->world; }

std::uint64_t Simulation::state_hash() const {
  StateHash hash;
  hash.add(impl_->steps);
  impl_->world.add_to(hash);
  for (RobotIndex robot = 0; robot < robot_count(); ++robot) {
    const RobotState& state = impl_->at(robot);
    const Twist command = state.controller.twist();
    for (const double value : {state.odometry.position().x, state.odometry.position().y,
                               state.odometry.heading().cos, state.odometry.heading().sin,
                               command.linear, command.angular, state.controller.remaining()}) {
      hash.add(value);
    }
    state.chassis->add_to(hash);
    hash.add(static_cast<std::uint64_t>(state.controller.state()));
    hash.add(std::uint64_t{state.stalled});
  }
  for (const RobotDevices& devices : impl_->devices) {
    for (const double position : devices.servos) hash.add(position);
  }
  return hash.value();
}

}  // namespace eyebridge::robot
