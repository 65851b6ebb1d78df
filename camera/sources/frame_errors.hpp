#pragma once

#include <cstdint>
#include <vector>

#include "eyebridge/camera/frame.hpp"
#include "eyebridge/camera/view.hpp"
#include "sources/blur.hpp"

namespace eyebridge::camera {

/// Gives pictures the errors of a camera: a function of the picture, the errors, their seed and
/// `moment`, which tells the pictures of one camera apart (a frame's time or sequence). Each kind
/// of error draws from a stream of its own.
class FrameErrors {
 public:
  /// Changes `frame`, an Rgb24 picture without padding: blur, exposure, Gaussian noise, black and
  /// white pixels, then coloured ones.
  void apply(const ImageNoise& noise, std::uint64_t moment, Frame& frame);

 private:
  /// Many draws of a normal distribution, with mean 0 and standard deviation 1 exactly: looking one
  /// up costs a tenth of computing one, and a VGA picture needs a million.
  std::vector<float> normal_;
  Blur blur_;
};

}  // namespace eyebridge::camera
