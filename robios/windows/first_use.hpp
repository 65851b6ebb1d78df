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

  hal::Device* find(hal::DeviceKind kind, int id) override {
    hal::Device* const device = inner_->find(kind, id);
    return kind <= hal::DeviceKind::Accelerometer ? used(device) : device;
  }
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
