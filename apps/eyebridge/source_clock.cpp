#include "source_clock.hpp"

#include <algorithm>

#include "clock/real_time_clock.hpp"

namespace eyebridge::apps {
namespace {

/// One thread's virtual time.
class JumpingClock final : public Clock {
 public:
  [[nodiscard]] Time now() const override { return now_; }
  void wait_until(Time deadline) override { now_ = std::max(now_, deadline); }
  void spend(Time cost) override { now_ += cost; }
  [[nodiscard]] bool is_virtual() const override { return true; }

 private:
  Time now_{0};
};

}  // namespace

std::unique_ptr<Clock> clock_for(const std::string& url) {
  if (!url.starts_with("v4l2")) return std::make_unique<JumpingClock>();
  return std::make_unique<hal::RealTimeClock>(Time(10'000'000), 1.0, [] {});
}

}  // namespace eyebridge::apps
