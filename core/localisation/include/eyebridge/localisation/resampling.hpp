#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace eyebridge::localisation {

/// Which particles survive: `count` indices in ascending order, each as often as `count` times its
/// weight, rounded up or down. One random number `start`, 0 <= start < 1, for all of them: the
/// low-variance sampler of S. Thrun, W. Burgard and D. Fox, "Probabilistic Robotics" (2005), table
/// 4.4. `weights` are >= 0, some > 0; they need not sum up to 1.
void low_variance_sample(std::span<const double> weights, std::size_t count, double start,
                         std::vector<std::size_t>& out);

/// How many particles bring the distribution of `bins` bins nearer than `error` (Kullback and
/// Leibler's divergence) to the true one, with the probability of which `quantile` is the normal
/// quantile: D. Fox, IJRR 22 (2003) 985, equation 7. `error` > 0. With one bin: 1.
double kld_sample_size(std::size_t bins, double error, double quantile);

}  // namespace eyebridge::localisation
