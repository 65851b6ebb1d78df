#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>

namespace eyebridge::robios {

/// Notices a program that goes on without any call: in virtual time all others wait for it.
/// Looked after every so often, by one thread.
class Watchdog {
 public:
  /// `progress` changes whenever something goes on; `tell` is called once for each hang, after five
  /// seconds without it (or half of `limit_s`), `interrupt` again and again after
  /// `limit_s` seconds.
  Watchdog(std::function<std::uint64_t()> progress, std::function<void(double)> tell,
           std::function<void()> interrupt, double limit_s)
      : progress_(std::move(progress)),
        tell_(std::move(tell)),
        interrupt_(std::move(interrupt)),
        limit_s_(limit_s),
        patience_s_(std::min(5.0, limit_s / 2)) {}

  /// `spent_s`: what the program has spent so far, seconds, of the processor's time or, where that
  /// holds up others, of waiting (HoldUp).
  void look(double spent_s) {
    const std::uint64_t progress = progress_();
    if (progress != seen_) {
      seen_ = progress;
      since_s_ = spent_s;
      has_told_ = false;
      return;
    }
    const double stuck_s = spent_s - since_s_;
    if (stuck_s >= patience_s_ && !has_told_) {
      has_told_ = true;
      tell_(patience_s_);
    }
    if (stuck_s >= limit_s_) interrupt_();
  }

 private:
  const std::function<std::uint64_t()> progress_;
  const std::function<void(double)> tell_;
  const std::function<void()> interrupt_;
  const double limit_s_;
  const double patience_s_;
  std::uint64_t seen_ = 0;
  double since_s_ = 0.0;
  bool has_told_ = false;
};

}  // namespace eyebridge::robios
