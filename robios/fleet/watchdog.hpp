#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace eyebridge::robios {

/// Notices a program that computes on without any call: in virtual time all others wait for it.
/// Looked after every so often, by one thread.
class Watchdog {
 public:
  /// After this much processor time without progress it tells so.
  static constexpr double kPatience_s = 5.0;

  /// `progress` changes whenever something goes on; `tell` is called once for each hang,
  /// `interrupt` again and again after `limit_s` seconds of it.
  Watchdog(std::function<std::uint64_t()> progress, std::function<void()> tell,
           std::function<void()> interrupt, double limit_s)
      : progress_(std::move(progress)),
        tell_(std::move(tell)),
        interrupt_(std::move(interrupt)),
        limit_s_(limit_s) {}

  /// `processor_s`: processor time of the process so far, seconds.
  void look(double processor_s) {
    const std::uint64_t progress = progress_();
    if (progress != seen_) {
      seen_ = progress;
      since_s_ = processor_s;
      has_told_ = false;
      return;
    }
    const double stuck_s = processor_s - since_s_;
    if (stuck_s >= kPatience_s && !has_told_) {
      has_told_ = true;
      tell_();
    }
    if (stuck_s >= limit_s_) interrupt_();
  }

 private:
  const std::function<std::uint64_t()> progress_;
  const std::function<void()> tell_;
  const std::function<void()> interrupt_;
  const double limit_s_;
  std::uint64_t seen_ = 0;
  double since_s_ = 0.0;
  bool has_told_ = false;
};

}  // namespace eyebridge::robios
