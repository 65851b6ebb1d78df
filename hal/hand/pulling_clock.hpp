#pragma once

#include "eyebridge/base/clock.hpp"
#include "eyebridge/camera/shared_source.hpp"

namespace eyebridge::hal {

/// The virtual clock of a robot that a person carries: whoever lets time pass takes the camera's
/// frames on the way, each at its time, so that a run is the same every time. Any thread.
class PullingClock final : public Clock {
 public:
  /// `camera` lives on `inner`; both are lent.
  PullingClock(Clock& inner, camera::SharedSource& camera) : inner_(inner), camera_(camera) {}

  [[nodiscard]] Time now() const override { return inner_.now(); }
  void wait_until(Time deadline) override {
    if (deadline > now()) camera_.pull(deadline);
  }
  void spend(Time cost) override { wait_until(now() + cost); }
  [[nodiscard]] bool is_virtual() const override { return true; }

 private:
  Clock& inner_;
  camera::SharedSource& camera_;
};

}  // namespace eyebridge::hal
