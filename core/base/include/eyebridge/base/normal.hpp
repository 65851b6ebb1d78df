#pragma once

namespace eyebridge {

// The standard normal distribution (mean 0, standard deviation 1) with the same bits on every CPU,
// as math.hpp has the elementary functions. Any thread.

/// Its density at `x`: exp(-x^2 / 2) / sqrt(2 pi); 0 far out. NaN for NaN.
double normal_density(double x);

/// Its distribution function: the probability of less than `x`. Relative error below 1e-12 down to
/// -37, where it is 1e-300; 0 and 1 for infinite `x`. NaN for NaN.
///
/// Near 0 by the series of Abramowitz and Stegun 26.2.11, in the tails by Laplace's continued
/// fraction, 26.2.14.
double normal_below(double x);

}  // namespace eyebridge
