#pragma once

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "targets.hpp"

namespace eyebridge::bench {

/// What single exchanges took, wall time: medians hide what a loaded machine does to the mean.
class Latencies {
 public:
  /// Times `exchange` once.
  template <class Exchange>
  void time(Exchange&& exchange) {
    const auto start = std::chrono::steady_clock::now();
    exchange();
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
    all_.push_back(took.count());
  }
  /// Microseconds that `share` (0 … 1) of them stayed below.
  [[nodiscard]] double quantile(double share) {
    if (all_.empty()) throw std::logic_error("quantile of nothing");
    const auto at = std::min(all_.size() - 1,
                             static_cast<std::size_t>(share * static_cast<double>(all_.size())));
    const auto place = all_.begin() + static_cast<std::ptrdiff_t>(at);
    std::nth_element(all_.begin(), place, all_.end());
    return *place;
  }

 private:
  std::vector<double> all_;
};

/// Both, and ours as a multiple of the baseline; `judged`: which should be at most 1.5.
inline void report(benchmark::State& state, Latencies& ours, Latencies& raw, bool judged = true) {
  const auto note = [&](const char* name, double times) {
    judged ? at_most(state, name, times, 1.5) : void(state.counters[name] = times);
  };
  state.counters["median_us"] = ours.quantile(0.5);
  state.counters["p99_us"] = ours.quantile(0.99);
  state.counters["raw_median_us"] = raw.quantile(0.5);
  state.counters["raw_p99_us"] = raw.quantile(0.99);
  note("x_raw_median", ours.quantile(0.5) / raw.quantile(0.5));
  note("x_raw_p99", ours.quantile(0.99) / raw.quantile(0.99));
}

/// Says `what` is wrong unless `good`.
inline void need(bool good, const std::string& what) {
  if (!good) throw std::runtime_error("bench: " + what);
}

}  // namespace eyebridge::bench
