#pragma once

#include <algorithm>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::bridges {

/// Whether a line spoils bytes at present: it does from the second fault within a memory's length
/// on, until it had none for as long. One alone is a hiccup of the board or of this computer. And
/// whether replies come too late, as on a busy computer: who then waits less makes it worse.
class LineQuality {
 public:
  static constexpr Time kMemory = std::chrono::seconds(5);

  void note_fault(Time now) {
    if (any_ && now - last_ < kMemory) noisy_until_ = now + kMemory;
    last_ = now;
    any_ = true;
  }
  /// A reply took longer than the usual wait: `took` from the question on.
  void note_late(Time now, Time took) {
    lateness_ = late(now) ? std::max(lateness_, took) : took;
    late_until_ = now + kMemory;
  }
  [[nodiscard]] bool late(Time now) const { return now < late_until_; }
  /// The longest time that such a reply took; 0 when none was late.
  [[nodiscard]] Time lateness(Time now) const { return late(now) ? lateness_ : Time{0}; }
  [[nodiscard]] bool noisy(Time now) const { return now < noisy_until_; }

 private:
  bool any_ = false;
  Time last_{0};
  Time noisy_until_ = Time::min();
  Time late_until_ = Time::min();
  Time lateness_{0};
};

}  // namespace eyebridge::bridges
