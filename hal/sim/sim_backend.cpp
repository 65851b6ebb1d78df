#include "sim/sim_backend.hpp"

#include <string>
#include <utility>

#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {
namespace {

template <class Type>
Device* one_of(std::map<int, Type>& devices, int id) {
  const auto found = devices.find(id);
  return found == devices.end() ? nullptr : &found->second;
}

/// One device for each of `models`, under the id that programs ask for.
template <class Device, class Model>
std::map<int, Device> make_devices(SimWorld& world, robot::RobotIndex robot,
                                   const std::vector<Model>& models) {
  std::map<int, Device> out;
  for (std::size_t i = 0; i < models.size(); ++i) out.try_emplace(models[i].id, world, robot, i);
  return out;
}

/// Devices 1 … `count`.
template <class Device>
std::map<int, Device> make_row_of(SimWorld& world, robot::RobotIndex robot, unsigned count) {
  std::map<int, Device> out;
  for (unsigned i = 0; i < count; ++i) {
    out.try_emplace(static_cast<int>(i) + 1, world, robot, i);
  }
  return out;
}

template <class Sensor>
std::vector<DeviceFacts> facts_about(const std::vector<Sensor>& sensors) {
  std::vector<DeviceFacts> out;
  for (const Sensor& sensor : sensors) out.push_back({sensor.id, sensor.name, sensor.semantics});
  return out;
}

/// Motors or encoders, as EyeSim's files call them.
std::vector<DeviceFacts> facts_about(const std::vector<robot::DrivePart>& parts,
                                     const std::string& prefix, double ticks_per_metre) {
  std::vector<DeviceFacts> out;
  for (const auto& part : parts) {
    out.push_back({static_cast<int>(out.size()) + 1, prefix + part.suffix, 0, ticks_per_metre});
  }
  return out;
}

}  // namespace

SimBackend::SimBackend(std::shared_ptr<SimWorld> world, std::shared_ptr<Clock> clock,
                       std::shared_ptr<Environment> environment, robot::RobotIndex robot,
                       double supply_voltage, AtEnd at_end, std::shared_ptr<SharedWorld> shared)
    : world_(std::move(world)),
      clock_(std::move(clock)),
      environment_(std::move(environment)),
      robot_(robot),
      at_end_(at_end),
      shared_(std::move(shared)),
      drive_(*world_, robot),
      compass_(*world_, robot),
      gyroscope_(*world_, robot),
      accelerometer_(*world_, robot),
      control_(*world_, robot),
      range_sensors_(
          make_devices<SimRangeSensor>(*world_, robot, world_->model(robot).range_sensors)),
      proximity_sensors_(
          make_devices<SimProximity>(*world_, robot, world_->model(robot).proximity_sensors)),
      bumpers_(make_devices<SimBumper>(*world_, robot, world_->model(robot).bumpers)),
      motors_(make_row_of<SimMotor>(*world_, robot, world_->model(robot).drive.motor_count())),
      encoders_(
          make_row_of<SimEncoder>(*world_, robot, world_->model(robot).drive.encoder_count())),
      digital_(*world_, robot),
      analog_(supply_voltage),
      range_matrices_(
          make_devices<SimRangeMatrix>(*world_, robot, world_->model(robot).range_matrices)) {
  if (world_->model(robot).lidar) lidar_.emplace(*world_, robot);
  if (world_->model(robot).camera) view_.emplace(*world_, robot);
  for (const unsigned servo : world_->model(robot).servo_indices()) {
    servos_.try_emplace(static_cast<int>(servo) + 1, *world_, robot, servo);
  }
}

Device* SimBackend::find(DeviceKind kind, int id) {
  switch (kind) {
    case DeviceKind::Drive:
      return &drive_;
    case DeviceKind::Motor:
      return one_of(motors_, id);
    case DeviceKind::Encoder:
      return one_of(encoders_, id);
    case DeviceKind::Servo:
      return one_of(servos_, id);
    case DeviceKind::Psd:
      return one_of(range_sensors_, id);
    case DeviceKind::Proximity:
      return one_of(proximity_sensors_, id);
    case DeviceKind::Bumper:
      return one_of(bumpers_, id);
    case DeviceKind::Lidar:
      return lidar_ ? &*lidar_ : nullptr;
    case DeviceKind::Tof:
      return one_of(range_matrices_, id);
    case DeviceKind::Compass:
      return &compass_;
    case DeviceKind::Gyroscope:
      return &gyroscope_;
    case DeviceKind::Accelerometer:
      return &accelerometer_;
    case DeviceKind::Digital:
      return &digital_;
    case DeviceKind::Analog:
      return &analog_;
    case DeviceKind::Board:
    case DeviceKind::Remote:
    case DeviceKind::Serial:
    case DeviceKind::Sound:
    case DeviceKind::Radio:
      break;
  }
  return nullptr;
}

RadioConditions SimBackend::radio_conditions() const {
  const robot::RadioError& error = world_->model(robot_).radio_error;
  return {error.loss, from_seconds(error.delay), from_seconds(error.jitter), error.corrupt,
          error.range};
}

std::vector<DeviceFacts> SimBackend::facts_of(std::string_view kind) {
  const robot::RobotModel& model = world_->model(robot_);
  if (kind == "psd") return facts_about(model.range_sensors);
  if (kind == "proximity") return facts_about(model.proximity_sensors);
  if (kind == "bumper") return facts_about(model.bumpers);
  if (kind == "tof") return facts_about(model.range_matrices);
  if (kind == "servo") {
    std::vector<DeviceFacts> out;
    for (const robot::ServoModel& servo : model.servos) {
      out.push_back({static_cast<int>(servo.servo) + 1, servo.name});
    }
    return out;
  }
  const robot::DriveFacts& drive = robot::facts_of(model.drive.kind);
  // Two motors need no names: programs know left and right.
  if (kind == "motor" && drive.motors.size() > 2) return facts_about(drive.motors, "MOTOR", 0.0);
  if (kind == "robot") return {{robot_id(), model.name}};
  if (kind != "encoder") return {};
  const double ticks_per_metre =
      model.drive.ticks_per_revolution / (kPi * model.drive.wheel_diameter);
  return facts_about(drive.encoders, "QUAD", ticks_per_metre);
}

Result<void> SimBackend::stop() noexcept {
  if (at_end_ == AtEnd::KeepDriving) return {};
  world_->locked([&](auto& sim) { sim.stop(robot_); });
  world_->end_report();
  return {};
}

std::string SimBackend::lost_results() {
  return at_end_ == AtEnd::KeepDriving ? "" : world_->lost_report();
}

}  // namespace eyebridge::hal
