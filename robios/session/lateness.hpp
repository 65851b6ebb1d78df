#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <chrono>
#include <cstddef>
#include <cstdint>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::robios {

/// How late a program's waits ended in real time, because the computer did something else. Any
/// thread; adding takes no lock.
class Lateness {
 public:
  void add(Time late) {
    const auto us =
        static_cast<std::uint64_t>(std::max(late, Time{0}) / std::chrono::microseconds(1));
    counts_[bucket(us)].fetch_add(1, std::memory_order_relaxed);
    std::uint64_t worst = worst_us_.load(std::memory_order_relaxed);
    while (us > worst && !worst_us_.compare_exchange_weak(worst, us, std::memory_order_relaxed)) {
    }
  }
  [[nodiscard]] std::uint64_t count() const {
    std::uint64_t all = 0;
    for (const auto& count : counts_) all += count.load(std::memory_order_relaxed);
    return all;
  }
  [[nodiscard]] Time worst() const { return std::chrono::microseconds(worst_us_.load()); }
  /// So late at most were 99 of 100 waits: true to a quarter, and never more than worst().
  [[nodiscard]] Time percentile99() const {
    const std::uint64_t all = count();
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      seen += counts_[i].load(std::memory_order_relaxed);
      if (100 * seen >= 99 * all) {
        return std::min<Time>(std::chrono::microseconds(upper_end(i)), worst());
      }
    }
    return worst();
  }

 private:
  // Four to a doubling: 0, 1, 2, 3 us, then 4 ... 5, 5 ... 6, 6 ... 7, 7 ... 8, 8 ... 10, and so
  // on.
  static std::size_t bucket(std::uint64_t us) {
    if (us < 4) return static_cast<std::size_t>(us);
    const auto doublings = static_cast<std::size_t>(std::bit_width(us)) - 3;
    return std::min<std::size_t>(4 * (doublings + 1) + ((us >> doublings) & 3U), kBuckets - 1);
  }
  static std::uint64_t upper_end(std::size_t bucket) {
    if (bucket < 4) return bucket;
    const std::size_t doublings = bucket / 4 - 1;
    return ((4 + bucket % 4 + 1) << doublings) - 1;
  }

  static constexpr std::size_t kBuckets = 128;  // up to an hour
  std::array<std::atomic<std::uint64_t>, kBuckets> counts_{};
  std::atomic<std::uint64_t> worst_us_ = 0;
};

}  // namespace eyebridge::robios
