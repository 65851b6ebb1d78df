#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "statistics.hpp"

namespace eyebridge::robot {

using testing::chi_square_p_value;

/// Chi-square of `sample` in equal bins between its ends, the outer ones endless; `at_most` is what
/// is expected. Bins in which few are expected count as one; 0 where that has far too many.
inline double p_value(std::vector<double> sample, double low, double high,
                      const std::function<double(double)>& at_most) {
  constexpr int kBins = 60;
  constexpr double kFew = 8;
  const auto count = static_cast<double>(sample.size());
  std::sort(sample.begin(), sample.end());
  std::vector<double> observed;
  std::vector<double> expected;
  double observed_rest = 0.0;
  double expected_rest = 0.0;
  double below = -1e9;
  for (int i = 0; i <= kBins + 1; ++i) {
    const double end = i <= kBins ? low + (high - low) * i / kBins : 1e9;
    const double wanted = count * (at_most(end) - at_most(below));
    const auto up_to = [&](double x) { return std::upper_bound(sample.begin(), sample.end(), x); };
    const auto found = static_cast<double>(up_to(end) - up_to(below));
    below = end;
    if (wanted < kFew) {
      expected_rest += wanted;
      observed_rest += found;
      continue;
    }
    expected.push_back(wanted);
    observed.push_back(found);
  }
  if (expected_rest < kFew && observed_rest > 5 * kFew) return 0.0;
  expected.back() += expected_rest;
  observed.back() += observed_rest;
  return expected.size() == 1 ? 1.0 : chi_square_p_value(observed, expected);
}

}  // namespace eyebridge::robot
