#include "source_clock.hpp"

#include "clock/real_time_clock.hpp"
#include "eyebridge/base/jumping_clock.hpp"

namespace eyebridge::apps {
std::unique_ptr<Clock> clock_for(const std::string& url) {
  if (!url.starts_with("v4l2")) return std::make_unique<JumpingClock>();
  return std::make_unique<hal::RealTimeClock>(Time(10'000'000), 1.0, [] {});
}

}  // namespace eyebridge::apps
