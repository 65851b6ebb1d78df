#pragma once

#include <map>
#include <memory>
#include <optional>

#include "eyebridge/hal/backend.hpp"
#include "eyebridge/hal/environment.hpp"
#include "sim/sim_actuators.hpp"
#include "sim/sim_camera_view.hpp"
#include "sim/sim_digital.hpp"
#include "sim/sim_drive.hpp"
#include "sim/sim_lidar.hpp"
#include "sim/sim_sensors.hpp"
#include "sim/sim_world.hpp"
#include "sim/sim_world_control.hpp"

namespace eyebridge::hal {

/// What a simulated robot does when its program has ended.
enum class AtEnd {
  Stop,         ///< As a real one.
  KeepDriving,  ///< As in EyeSim: it keeps its last command; others may be following it.
};

/// One robot of a simulated world.
class SimBackend final : public Backend {
 public:
  /// `clock` steps `world`. The robot has the devices of its model, a compass, a gyroscope, an
  /// accelerometer, the motors and encoders of its kind of drive (differential: 1 left, 2 right;
  /// the others as DriveKind has them, from 1), the servos of RobotModel::servo_indices(),
  /// digital lines, and analog inputs with a battery of `supply_voltage` volts. It has no I/O board
  /// and nothing of a computer. World, clock and environment may be shared with other robots;
  /// `shared`, when not null, lets more of them join.
  SimBackend(std::shared_ptr<SimWorld> world, std::shared_ptr<Clock> clock,
             std::shared_ptr<Environment> environment, robot::RobotIndex robot,
             double supply_voltage, AtEnd at_end = AtEnd::Stop,
             std::shared_ptr<SharedWorld> shared = nullptr);

  Clock& clock() override { return *clock_; }
  [[nodiscard]] int robot_id() const override { return static_cast<int>(robot_) + 1; }
  Device* find(DeviceKind kind, int id) override;
  [[nodiscard]] RadioConditions radio_conditions() const override;
  WorldControl* world() override { return &control_; }
  Environment* environment() override { return environment_.get(); }
  std::shared_ptr<SharedWorld> shared_world() override { return shared_; }
  std::string lost_results() override;
  camera::View* camera_view() override { return view_ ? &*view_ : nullptr; }
  camera::Source* camera_source() override { return nullptr; }
  std::vector<DeviceFacts> facts_of(std::string_view kind) override;
  void trace_to(TraceSink* sink) override { world_->trace_to(sink, robot_); }
  Result<void> stop() noexcept override;

 private:
  std::shared_ptr<SimWorld> world_;
  std::shared_ptr<Clock> clock_;  ///< After the world that it steps: it must end first.
  std::shared_ptr<Environment> environment_;
  const robot::RobotIndex robot_;
  const AtEnd at_end_;
  const std::shared_ptr<SharedWorld> shared_;
  SimDrive drive_;
  SimCompass compass_;
  SimGyroscope gyroscope_;
  SimAccelerometer accelerometer_;
  SimWorldControl control_;
  std::map<int, SimRangeSensor> range_sensors_;
  std::map<int, SimProximity> proximity_sensors_;
  std::map<int, SimBumper> bumpers_;
  std::map<int, SimMotor> motors_;
  std::map<int, SimEncoder> encoders_;
  std::map<int, SimServo> servos_;
  SimDigital digital_;
  SimAnalog analog_;
  std::optional<SimLidar> lidar_;
  std::map<int, SimRangeMatrix> range_matrices_;
  std::optional<SimCameraView> view_;
};

}  // namespace eyebridge::hal
