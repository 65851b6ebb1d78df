#include "eyebridge/localisation/resampling.hpp"

#include <cmath>

namespace eyebridge::localisation {

void low_variance_sample(std::span<const double> weights, std::size_t count, double start,
                         std::vector<std::size_t>& out) {
  out.clear();
  if (count == 0) return;
  double total = 0.0;
  std::size_t last = 0;  // rounding must not choose one of no weight
  for (std::size_t i = 0; i < weights.size(); ++i) {
    total += weights[i];
    if (weights[i] > 0.0) last = i;
  }
  const double step = total / static_cast<double>(count);
  double reached = weights[0];
  std::size_t i = 0;
  for (std::size_t m = 0; m < count; ++m) {
    const double wanted = (static_cast<double>(m) + start) * step;
    while (reached <= wanted && i < last) reached += weights[++i];
    out.push_back(i);
  }
}

double kld_sample_size(std::size_t bins, double error, double quantile) {
  if (bins <= 1) return 1.0;
  // Wilson and Hilferty's approximation of the chi-square quantile.
  const auto degrees = static_cast<double>(bins - 1);
  const double spread = 2.0 / (9.0 * degrees);
  const double root = 1.0 - spread + std::sqrt(spread) * quantile;
  return degrees / (2.0 * error) * root * root * root;
}

}  // namespace eyebridge::localisation
