#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "eyebridge/mapping/beam_model.hpp"

namespace eyebridge::mapping {

/// Probability of a cell from `near` to `far`, metres from the place that was measured with the
/// standard deviation `sigma`, > 0, at even odds before: the mean over where the surface may be.
double blurred_probability(const BeamModel& model, double near, double far, double sigma);
/// That of a cell `depth` metres deep which is nearer than the least range, where a folded reading
/// may hide a surface anywhere.
double folded_probability(const BeamModel& model, double depth);
/// How a reading that may be folded mixes what it says with what it hides.
double mixed_probability(const BeamModel& model, double said, double hidden);

/// Less than any evidence: what a cell has that nothing was said of.
inline constexpr float kNoEvidence = -1e30F;

/// What the readings of one model add to the log-odds of cells of one size. Lengths are in cells,
/// along the axis that the beam follows.
class BeamTable {
 public:
  BeamTable(const BeamModel& model, double resolution);

  /// The evidence around a reading, by the offset of a cell's centre from it.
  struct Blur {
    static constexpr int kEntries = 80;
    double reach = 0.0;  ///< To either side; nearer cells were crossed, farther ones say nothing.
    double scale = 0.0;  ///< Entries a cell.
    std::int64_t step = 0;  ///< The same with 32 bits of fraction.
    int cells = 0;  ///< As many in a row begin before the one side and end beyond the other.
    /// From -reach to one cell beyond reach, where it is kNoEvidence.
    std::array<float, kEntries + 1> evidence{};

    /// `offset` is of one of `cells` cells, of which the first is the first within reach.
    [[nodiscard]] float at(double offset) const {
      // Rounding takes it less than an entry too low, where 0 is what a negative one is cut to, or
      // too high.
      const int i = static_cast<int>((offset + reach) * scale);
      return evidence[static_cast<std::size_t>(i)];
    }
  };

  /// Of a reading with this standard deviation.
  [[nodiscard]] const Blur& blur(double sigma) const {
    constexpr double kHalf = 0.5;  // rounds: nothing here is negative
    const auto i = static_cast<std::size_t>(sigma * levels_ + kHalf);
    return blurs_[i < blurs_.size() ? i : blurs_.size() - 1];
  }
  /// Blurs lie evenly by standard deviation: so many to a cell of it, up to highest_level().
  [[nodiscard]] double levels() const { return levels_; }
  [[nodiscard]] double highest_level() const { return static_cast<double>(blurs_.size() - 1); }
  [[nodiscard]] const Blur& blur_of_level(std::int32_t level) const {
    return blurs_[static_cast<std::size_t>(level)];
  }
  /// The `reach` of a level's blur.
  template <class Real>
  [[nodiscard]] Real reach_of(Real level) const {
    const Real width = level / static_cast<Real>(levels_);
    constexpr auto kLeast = static_cast<Real>(kLeastSigma);
    return static_cast<Real>(kBlurWidth) * (width > kLeast ? width : kLeast) +
           static_cast<Real>(kCellHalf);
  }
  /// Standard deviation of a reading within reach, cells.
  [[nodiscard]] double sigma(double range) const {
    if (simple_) return sigma_ + sigma_relative_ * range;
    const auto i = static_cast<std::size_t>(range * bins_);
    return sigmas_[i < sigmas_.size() ? i : sigmas_.size() - 1];
  }
  /// Whether it is sigma(0) and so much more for each metre.
  [[nodiscard]] bool is_simple() const { return simple_; }
  [[nodiscard]] double sigma_relative() const { return sigma_relative_; }

  float crossed = 0.0F;        ///< By a beam that met something beyond.
  float crossed_unmet = 0.0F;  ///< By a beam out of range.
  float crossed_near = 0.0F;   ///< Nearer than the least range.
  double max_reach = 0.0;      ///< Of any reading's evidence beyond it, cells.

  // What lies farther off than this many standard deviations is left to the cells beside it.
  static constexpr double kBlurWidth = 3.0;
  static constexpr double kCellHalf = 0.5;
  static constexpr double kLeastSigma = 0.01;  ///< Cells, as BeamModel::probability() has it.

 private:
  bool simple_ = true;
  double sigma_ = 0.0;
  double sigma_relative_ = 0.0;
  double bins_ = 0.0;
  double levels_ = 0.0;
  std::vector<double> sigmas_;
  std::vector<Blur> blurs_;
};

}  // namespace eyebridge::mapping
