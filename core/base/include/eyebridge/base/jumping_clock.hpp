#pragma once

#include <algorithm>

#include "eyebridge/base/clock.hpp"

namespace eyebridge {

/// Virtual time of one thread: waiting takes it there at once. Not for several threads.
class JumpingClock final : public Clock {
 public:
  [[nodiscard]] Time now() const override { return now_; }
  void wait_until(Time deadline) override { now_ = std::max(now_, deadline); }
  void spend(Time cost) override { now_ += cost; }
  [[nodiscard]] bool is_virtual() const override { return true; }

 private:
  Time now_{0};
};

}  // namespace eyebridge
