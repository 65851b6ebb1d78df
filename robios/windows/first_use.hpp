#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <utility>

#include "eyebridge/hal/passing_backend.hpp"

namespace eyebridge::robios {

/// A backend that tells when its program first asks for something that drives or senses.
class FirstUse final : public hal::PassingBackend {
 public:
  using PassingBackend::PassingBackend;

  /// Before the program's first call. `tell` is called once, in the thread that asks.
  void on_first_use(std::function<void()> tell) { tell_ = std::move(tell); }

  hal::Drive* drive() override { return used(inner_->drive()); }
  hal::RangeSensor* range_sensor(int id) override { return used(inner_->range_sensor(id)); }
  hal::SwitchSensor* proximity(int id) override { return used(inner_->proximity(id)); }
  hal::SwitchSensor* bumper(int id) override { return used(inner_->bumper(id)); }
  hal::Lidar* lidar() override { return used(inner_->lidar()); }
  hal::Compass* compass() override { return used(inner_->compass()); }
  hal::Gyroscope* gyroscope() override { return used(inner_->gyroscope()); }
  hal::Accelerometer* accelerometer() override { return used(inner_->accelerometer()); }
  hal::Motor* motor(int id) override { return used(inner_->motor(id)); }
  hal::Encoder* encoder(int id) override { return used(inner_->encoder(id)); }
  hal::Servo* servo(int id) override { return used(inner_->servo(id)); }
  hal::WorldControl* world() override { return used(inner_->world()); }

 private:
  template <class Device>
  Device* used(Device* device) {
    if (tell_) std::call_once(once_, tell_);
    return device;
  }

  std::function<void()> tell_;
  std::once_flag once_;
};

}  // namespace eyebridge::robios
