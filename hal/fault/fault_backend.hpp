#pragma once

#include <map>
#include <memory>
#include <mutex>

#include "fault/faulty_devices.hpp"

namespace eyebridge::hal {

/// Another backend whose devices fail as a script says. The world, the camera's view and stop() are
/// not touched: motors stop whatever is broken.
class FaultBackend final : public Backend {
 public:
  FaultBackend(std::unique_ptr<Backend> inner, FaultScript script, std::uint64_t seed);

  Clock& clock() override { return inner_->clock(); }
  [[nodiscard]] int robot_id() const override { return inner_->robot_id(); }

  Drive* drive() override;
  RangeSensor* range_sensor(int id) override;
  SwitchSensor* proximity(int id) override;
  SwitchSensor* bumper(int id) override;
  Lidar* lidar() override;
  Compass* compass() override;
  Motor* motor(int id) override;
  Encoder* encoder(int id) override;
  Servo* servo(int id) override;

  WorldControl* world() override { return inner_->world(); }
  camera::View* camera_view() override { return inner_->camera_view(); }
  void trace_to(TraceSink* sink) override { inner_->trace_to(sink); }
  void stop() noexcept override { inner_->stop(); }

 private:
  template <class Faulty>
  struct Slot {
    Slot(FaultBackend& owner, const char* kind, int id, auto& device)
        : gate(kind, id, owner.clock(), owner.script_, owner.seed_), faulty(device, gate) {}
    FaultGate gate;
    Faulty faulty;
  };
  /// Devices of one kind, made when they are first asked for.
  template <class Faulty>
  using Slots = std::map<int, Slot<Faulty>>;

  template <class Faulty, class Device>
  Faulty* wrap(Slots<Faulty>& slots, const char* kind, int id, Device* device);

  std::unique_ptr<Backend> inner_;
  const FaultScript script_;
  const std::uint64_t seed_;
  std::mutex mutex_;
  Slots<FaultyDrive> drives_;
  Slots<FaultyRangeSensor> range_sensors_;
  Slots<FaultySwitchSensor> proximity_sensors_;
  Slots<FaultySwitchSensor> bumpers_;
  Slots<FaultyLidar> lidars_;
  Slots<FaultyCompass> compasses_;
  Slots<FaultyMotor> motors_;
  Slots<FaultyEncoder> encoders_;
  Slots<FaultyServo> servos_;
};

}  // namespace eyebridge::hal
