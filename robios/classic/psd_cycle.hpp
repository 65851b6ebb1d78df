#pragma once

#include <optional>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::robios::classic {

/// When distance sensors measure: at once where they were not started; after PSDStart() once, or
/// every kPeriod. One thread at a time.
class PsdCycle {
 public:
  static constexpr Time kPeriod = std::chrono::milliseconds(60);

  /// False while a single measurement is under way. Sensors that are added to a running cycle join it.
  bool start(int mask, bool again_and_again, Time now);
  void stop() { started_ = {}; }

  /// The mask of the sensors that were started, 0 for none.
  [[nodiscard]] int mask() const { return started_ ? started_->mask : 0; }
  /// The first measurement is done.
  [[nodiscard]] bool is_ready(Time now) const;
  /// Which measurement of the started ones a reading at `now` belongs to, from 1; 0 before the first
  /// is done.
  [[nodiscard]] long long number(Time now) const;
  /// When that measurement began; of what was not started, now.
  [[nodiscard]] Time began(Time now) const;

 private:
  struct Started {
    int mask = 0;
    bool again_and_again = false;
    Time at{0};
  };
  std::optional<Started> started_;
};

inline bool PsdCycle::start(int mask, bool again_and_again, Time now) {
  if (started_ && !started_->again_and_again && now - started_->at < kPeriod) return false;
  if (started_ && started_->again_and_again && again_and_again) {
    started_->mask |= mask;
  } else {
    started_ = Started{mask, again_and_again, now};
  }
  return true;
}

inline bool PsdCycle::is_ready(Time now) const { return number(now) > 0; }

inline long long PsdCycle::number(Time now) const {
  if (!started_) return 0;
  const long long done = (now - started_->at) / kPeriod;
  return started_->again_and_again || done < 1 ? done : 1;
}

inline Time PsdCycle::began(Time now) const {
  const long long last = number(now);
  return last == 0 ? now : Time(started_->at + (last - 1) * kPeriod);
}

}  // namespace eyebridge::robios::classic
