#include "vision/vision_parts.hpp"

#include <opencv2/core.hpp>

#include "vision/dictionary.hpp"

namespace eyebridge::camera {
namespace {

class OpenCvVision final : public Vision {
 public:
  // Its pool of threads would take the cores of the other robots.
  OpenCvVision() { cv::setNumThreads(1); }

  [[nodiscard]] FiducialBits fiducial_bits(int id) const override { return bits_of(id); }
};

}  // namespace

const Vision& opencv_vision() {
  static const OpenCvVision kVision;
  return kVision;
}

}  // namespace eyebridge::camera
