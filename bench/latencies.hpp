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

/// Both, and ours as a multiple of the baseline, without a target.
inline void report_only(benchmark::State& state, Latencies& ours, Latencies& raw) {
  state.counters["median_us"] = ours.quantile(0.5);
  state.counters["p99_us"] = ours.quantile(0.99);
  state.counters["raw_median_us"] = raw.quantile(0.5);
  state.counters["raw_p99_us"] = raw.quantile(0.99);
  state.counters["x_raw_median"] = ours.quantile(0.5) / raw.quantile(0.5);
  state.counters["x_raw_p99"] = ours.quantile(0.99) / raw.quantile(0.99);
}

/// The same; ours should take at most 1.5 times as long.
inline void report(benchmark::State& state, Latencies& ours, Latencies& raw) {
  report_only(state, ours, raw);
  at_most(state, "x_raw_median", ours.quantile(0.5) / raw.quantile(0.5), 1.5);
  at_most(state, "x_raw_p99", ours.quantile(0.99) / raw.quantile(0.99), 1.5);
}

/// Says `what` is wrong unless `good`.
inline void need(bool good, const std::string& what) {
  if (!good) throw std::runtime_error("bench: " + what);
}

}  // namespace eyebridge::bench
