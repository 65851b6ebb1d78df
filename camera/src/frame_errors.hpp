#pragma once

#include <vector>

#include "eyebridge/camera/frame.hpp"
#include "eyebridge/camera/view.hpp"

namespace eyebridge::camera {

/// Adds a camera's noise to pictures. The same seed and frame time give the same noise.
class NoiseMaker {
 public:
  /// Adds Gaussian noise to every channel of `frame` (Rgb24), then turns pixels black or white.
  void apply(const ImageNoise& noise, Frame& frame);

 private:
  /// Many draws of a normal distribution, with mean 0 and standard deviation 1 exactly: looking one
  /// up costs a tenth of computing one, and a VGA picture needs a million.
  std::vector<float> normal_;
};

}  // namespace eyebridge::camera
