// A calibration as OpenCV itself writes it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "eyebridge/base/config_error.hpp"
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
  for (const std::string name : {"cam.yaml", "cam.xml"}) {
    cv::FileStorage file(name, cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
    file << "image_width" << lens.size.width << "image_height" << lens.size.height;
    file << "camera_matrix"
         << cv::Mat(cv::Matx33d(lens.fx, 0, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1));
    file << "distortion_coefficients" << cv::Mat(5, 1, CV_64F, lens.distortion.data());
    file << "avg_reprojection_error" << lens.error << "other"
         << "ignored";
    EXPECT_EQ(parse_calibration(file.releaseAndGetString(), name), lens) << name;
  }
}

TEST(OpencvCalibration, XmlThatIsNoneIsAnErrorThatSaysWhy) {
  const auto error = [](const std::string& text) -> std::string {
    try {
      parse_calibration("<?xml version=\"1.0\"?>\n" + text, "cam.xml");
    } catch (const ConfigError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_THAT(error("<opencv_storage>"), ::testing::HasSubstr("cam.xml:2: not well-formed XML"));
  EXPECT_THAT(error("<svg/>"), ::testing::HasSubstr("cam.xml:1:1: expected a calibration"));
  EXPECT_THAT(error("<opencv_storage><image_width>640</image_width></opencv_storage>"),
              ::testing::HasSubstr("has no 'image_height'"));
  EXPECT_THAT(error("<opencv_storage><image_width>wide</image_width></opencv_storage>"),
              ::testing::HasSubstr("found 'wide', expected a number in 'image_width'"));
}

}  // namespace
}  // namespace eyebridge::camera::testing
