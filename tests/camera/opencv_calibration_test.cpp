// A calibration as OpenCV itself writes it.
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "eyebridge/camera/calibration.hpp"

namespace eyebridge::camera::testing {
namespace {

TEST(OpencvCalibration, IsRead) {
  Calibration lens;
  lens.size = {640, 480};
  lens.fx = 543.25;
  lens.fy = 541.0 + 1.0 / 3.0;
  lens.cx = 321.5;
  lens.cy = 238.125;
  lens.distortion = {-0.28, 0.07, 0.0008, -0.0012, 0.01};
  lens.error = 0.25;
  cv::FileStorage file("cam.yaml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  file << "image_width" << lens.size.width << "image_height" << lens.size.height;
  file << "camera_matrix"
       << cv::Mat(cv::Matx33d(lens.fx, 0, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1));
  file << "distortion_coefficients" << cv::Mat(5, 1, CV_64F, lens.distortion.data());
  file << "avg_reprojection_error" << lens.error << "other"
       << "ignored";
  EXPECT_EQ(parse_calibration(file.releaseAndGetString(), "cam.yaml"), lens);
}

}  // namespace
}  // namespace eyebridge::camera::testing
