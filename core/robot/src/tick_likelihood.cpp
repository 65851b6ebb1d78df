#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "eyebridge/base/units.hpp"
#include "eyebridge/robot/sensor_likelihood.hpp"

namespace eyebridge::robot {
namespace {

constexpr double kNegligible = 1e-20;  // of the likeliest mass

/// Masses of the binomial distribution, each as a share of the likeliest one, from `first` on.
struct MissedTicks {
  std::int64_t first = 0;
  std::vector<double> masses;
};

/// How many of `count` events happen, each with `probability`, 0 < p < 1. From the likeliest number
/// outwards by the ratio of neighbours: no factorials, and + - * / alone.
MissedTicks missed_ticks(std::int64_t count, double probability) {
  const auto n = static_cast<double>(count);
  const double odds = probability / (1.0 - probability);
  const auto mode = std::min(count, static_cast<std::int64_t>(std::floor((n + 1.0) * probability)));
  std::vector<double> fewer;
  double mass = 1.0;
  for (std::int64_t k = mode; k > 0 && mass > kNegligible; --k) {
    const auto events = static_cast<double>(k);
    mass *= events / ((n - events + 1.0) * odds);
    fewer.push_back(mass);
  }
  MissedTicks out{mode - static_cast<std::int64_t>(fewer.size()), {fewer.rbegin(), fewer.rend()}};
  mass = 1.0;
  out.masses.push_back(mass);
  for (std::int64_t k = mode; k < count && mass > kNegligible; ++k) {
    const auto events = static_cast<double>(k);
    mass *= (n - events) * odds / (events + 1.0);
    out.masses.push_back(mass);
  }
  return out;
}

}  // namespace

TickReadings::TickReadings(const DriveError& error, double ticks_per_revolution, double angle)
    : counts_down_(angle < 0.0) {
  const double ticks = std::abs(angle) / (2 * kPi) * ticks_per_revolution;
  if (!(ticks_per_revolution > 0.0 && ticks <= kMostTicks)) {
    throw std::invalid_argument("encoder: at most 1e9 ticks, of more than 0 a turn");
  }
  passed_ = std::llround(ticks);
  const double miss = error.encoder_miss;
  if (miss <= 0.0 || miss >= 1.0 || passed_ == 0) {
    least_missed_ = miss >= 1.0 ? passed_ : 0;
    sums_ = {1.0};
    return;
  }
  MissedTicks missed = missed_ticks(passed_, miss);
  least_missed_ = missed.first;
  sums_ = std::move(missed.masses);
  std::partial_sum(sums_.begin(), sums_.end(), sums_.begin());
  const double all = sums_.back();
  for (double& sum : sums_) sum /= all;
}

/// Probability that no more than `count` ticks were missed.
double TickReadings::missed_at_most(std::int64_t count) const {
  if (count < least_missed_) return 0.0;
  const auto index = static_cast<std::uint64_t>(count - least_missed_);
  return index < sums_.size() ? sums_[index] : 1.0;
}

double TickReadings::mass(std::int64_t ticks) const {
  const std::int64_t counted = counts_down_ ? -ticks : ticks;
  const std::int64_t missed = passed_ - counted;
  return missed_at_most(missed) - missed_at_most(missed - 1);
}

double TickReadings::at_most(std::int64_t ticks) const {
  // Few counted forwards are many missed; on the way back, few missed are the lowest count.
  if (counts_down_) return missed_at_most(passed_ + ticks);
  return 1.0 - missed_at_most(passed_ - ticks - 1);
}

double TickReadings::probability(double ticks, double resolution) const {
  if (std::isnan(ticks) || std::isnan(resolution)) return 0.0;
  const auto up_to = [this](double reading) {
    const double most = 2 * kMostTicks;  // beyond there is nothing
    return at_most(static_cast<std::int64_t>(std::floor(std::clamp(reading, -most, most))));
  };
  return up_to(ticks + resolution / 2) - up_to(ticks - resolution / 2);
}

}  // namespace eyebridge::robot
