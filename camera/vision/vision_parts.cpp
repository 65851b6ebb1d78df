#include "vision/vision_parts.hpp"

#include <opencv2/core.hpp>

#include "vision/aruco.hpp"
#include "vision/calibrator.hpp"
#include "vision/fiducial_detector.hpp"

namespace eyebridge::camera {
namespace {

class OpenCvVision final : public Vision {
 public:
  // Its pool of threads would take the cores of the other robots.
  OpenCvVision() { cv::setNumThreads(1); }

  [[nodiscard]] FiducialBits fiducial_bits(FiducialFamily family, int id) const override {
    return bits_of(family, id);
  }

  [[nodiscard]] std::vector<SeenFiducial> find_fiducials(const Frame& frame,
                                                         FiducialFamily family) const override {
    return camera::find_fiducials(frame, family);
  }

  [[nodiscard]] std::vector<SquarePose> square_poses(const Corners& corners,
                                                     double size) const override {
    return camera::square_poses(corners, size);
  }

  [[nodiscard]] std::unique_ptr<Calibrator> make_calibrator(const Board& board) const override {
    return make_opencv_calibrator(board);
  }
};

}  // namespace

const Vision& opencv_vision() {
  static const OpenCvVision kVision;
  return kVision;
}

}  // namespace eyebridge::camera
