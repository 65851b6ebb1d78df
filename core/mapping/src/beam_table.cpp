#include "beam_table.hpp"

#include <algorithm>
#include <cstddef>

#include "eyebridge/mapping/occupancy_grid.hpp"

namespace eyebridge::mapping {
namespace {

constexpr std::size_t kSigmas = 64;      // by standard deviation
constexpr std::size_t kRangeBins = 512;  // of a sensor with a table

constexpr double kOne = 4294967296.0;  // of numbers with 32 bits of fraction
constexpr double kWidest = 1 << 24;    // cells

}  // namespace

BeamTable::BeamTable(const BeamModel& model, double resolution)
    : crossed(static_cast<float>(log_odds_of(mixed_probability(model, model.crossed, 0.5)))),
      crossed_unmet(static_cast<float>(log_odds_of(model.probability_out_of_range()))),
      crossed_near(static_cast<float>(log_odds_of(
          mixed_probability(model, model.crossed, folded_probability(model, resolution))))),
      simple_(model.levels.empty() && model.sigma_quadratic == 0.0),
      sigma_(model.sigma / resolution),
      sigma_relative_(model.sigma_relative / resolution) {
  double largest = 0.0;
  if (simple_) {
    largest = sigma(model.max_range);
  } else {
    bins_ = static_cast<double>(kRangeBins) / model.max_range;
    for (std::size_t i = 0; i <= kRangeBins; ++i) {
      sigmas_.push_back(model.sigma_at((static_cast<double>(i) + 0.5) / bins_) / resolution);
      largest = std::max(largest, sigmas_.back());
    }
  }
  largest = std::max(largest, kLeastSigma);
  levels_ = static_cast<double>(kSigmas - 1) / largest;
  blurs_.resize(kSigmas);
  for (std::size_t level = 0; level < kSigmas; ++level) {
    const double width = std::max(static_cast<double>(level) / levels_, kLeastSigma);
    Blur& blur = blurs_[level];
    blur.reach = reach_of(static_cast<double>(level));
    // What is wider than any grid is refused by who asks for max_reach.
    blur.cells = static_cast<int>(2.0 * std::min(blur.reach, kWidest)) + 1;
    blur.scale = Blur::kEntries / (2.0 * blur.reach + 1.0);
    blur.step = static_cast<std::int64_t>(blur.scale * kOne);
    for (int i = 0; i <= Blur::kEntries; ++i) {
      const double offset = (i + 0.5) / blur.scale - blur.reach;
      const double said =
          blurred_probability(model, (offset - kCellHalf) * resolution,
                              (offset + kCellHalf) * resolution, width * resolution);
      blur.evidence[static_cast<std::size_t>(i)] =
          offset < blur.reach ? static_cast<float>(log_odds_of(mixed_probability(model, said, 0.5)))
                              : kNoEvidence;
    }
    max_reach = std::max(max_reach, blur.reach);
  }
}

}  // namespace eyebridge::mapping
