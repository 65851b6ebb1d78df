// PNM pictures that another program has written: OpenCV's, in all six forms.
#include "eyebridge/base/pnm.hpp"

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

namespace eyebridge {
namespace {

std::string written(const cv::Mat& picture, const std::string& form, bool binary) {
  std::vector<unsigned char> bytes;
  EXPECT_TRUE(cv::imencode(form, picture, bytes, {cv::IMWRITE_PXM_BINARY, binary ? 1 : 0}));
  return {bytes.begin(), bytes.end()};
}

cv::Mat random_picture(int columns, int rows, int type) {
  cv::Mat picture(rows, columns, type);
  cv::RNG random(7);
  random.fill(picture, cv::RNG::UNIFORM, 0, picture.depth() == CV_8U ? 256 : 65536);
  return picture;
}

/// Of one channel or three; OpenCV has blue first.
std::vector<std::uint8_t> values_of(const cv::Mat& picture) {
  std::vector<std::uint8_t> values;
  const int channels = picture.channels();
  for (int row = 0; row < picture.rows; ++row) {
    for (int i = 0; i < picture.cols * channels; ++i) {
      const int at = channels == 3 ? i / 3 * 3 + 2 - i % 3 : i;
      values.push_back(picture.ptr<std::uint8_t>(row)[at]);
    }
  }
  return values;
}

TEST(PnmOfOpenCv, GreysAndColoursAreReadAsTheyWereWritten) {
  for (const bool binary : {false, true}) {
    for (const int columns : {1, 7, 8, 17}) {
      const cv::Mat grey = random_picture(columns, 5, CV_8UC1);
      EXPECT_EQ(read_pnm(written(grey, ".pgm", binary), "cv.pgm"),
                (PnmPicture{PnmKind::Grey, columns, 5, values_of(grey)}));
      const cv::Mat colour = random_picture(columns, 5, CV_8UC3);
      EXPECT_EQ(read_pnm(written(colour, ".ppm", binary), "cv.ppm"),
                (PnmPicture{PnmKind::Colour, columns, 5, values_of(colour)}));
    }
  }
}

TEST(PnmOfOpenCv, BitmapsAreReadAsTheyWereWritten) {
  for (const bool binary : {false, true}) {
    for (const int columns : {1, 7, 8, 17}) {
      const cv::Mat white = random_picture(columns, 5, CV_8UC1) > 127;
      std::vector<std::uint8_t> black = values_of(white);
      for (std::uint8_t& value : black) value = value == 0 ? 1 : 0;
      EXPECT_EQ(read_pnm(written(white, ".pbm", binary), "cv.pbm"),
                (PnmPicture{PnmKind::Bitmap, columns, 5, black}));
    }
  }
}

TEST(PnmOfOpenCv, ValuesOfSixteenBitsAreScaled) {
  const cv::Mat deep = random_picture(9, 4, CV_16UC1);
  const PnmPicture read = read_pnm(written(deep, ".pgm", true), "cv.pgm");
  ASSERT_EQ(read.bytes.size(), 36U);
  for (std::size_t i = 0; i < read.bytes.size(); ++i) {
    const double value = deep.ptr<std::uint16_t>(static_cast<int>(i / 9))[i % 9];
    EXPECT_NEAR(read.bytes[i], value * 255 / 65535, 0.5 + 1e-9) << i;
  }
}

}  // namespace
}  // namespace eyebridge
