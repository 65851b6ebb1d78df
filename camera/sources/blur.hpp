#pragma once

#include <cstdint>
#include <vector>

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// A lens that is out of focus: a Gaussian, rows first, then columns, with whole-number weights, so
/// that the bytes are the same on every machine. Keeps its weights and memory for the next picture.
class Blur {
 public:
  /// Blurs `frame`, Rgb24 without padding, by a standard deviation of `sigma` pixels, > 0; what is
  /// beyond an edge looks like the edge.
  void apply(double sigma, Frame& frame);

 private:
  void set_sigma(double sigma);

  double sigma_ = 0.0;
  std::vector<std::uint32_t> weights_;  ///< Of the pixel itself and its neighbours to one side.
  std::vector<std::uint16_t> rows_;     ///< Blurred along the rows, 8 bits of fraction.
  std::vector<std::uint32_t> sums_;     ///< Of one row.
};

}  // namespace eyebridge::camera
