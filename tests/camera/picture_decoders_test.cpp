// Every format of pictures, decoded by us and by somebody else: OpenCV where ours is another
// decoder, libtiff's and libwebp's own programs where ours is OpenCV.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "eyebridge/camera/picture.hpp"
#include "eyebridge/files/map_files.hpp"
#include "run_program.hpp"

namespace eyebridge::camera {
namespace {

using ::testing::HasSubstr;

/// Smooth, so that lossy formats keep it, and another in each channel.
cv::Mat smooth(int type, int columns = 53, int rows = 31) {
  cv::Mat picture(rows, columns, type);
  const double most = picture.depth() == CV_8U ? 255 : 65535;
  const int channels = picture.channels();
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      for (int c = 0; c < channels; ++c) {
        const double share = c == 3 ? 1 : 0.5 + 0.45 * std::sin(0.07 * x + 0.11 * y + 1.7 * c);
        if (picture.depth() == CV_8U) {
          picture.ptr<std::uint8_t>(y)[x * channels + c] =
              static_cast<std::uint8_t>(std::lround(most * share));
        } else {
          picture.ptr<std::uint16_t>(y)[x * channels + c] =
              static_cast<std::uint16_t>(std::lround(most * share));
        }
      }
    }
  }
  return picture;
}

std::vector<std::uint8_t> encoded(const std::string& ending, const cv::Mat& picture,
                                  const std::vector<int>& options = {}) {
  std::vector<std::uint8_t> bytes;
  EXPECT_TRUE(cv::imencode(ending, picture, bytes, options)) << ending;
  return bytes;
}

/// The largest difference of a channel between what we make of `bytes` and `theirs`, B G R.
int largest_difference(const std::vector<std::uint8_t>& bytes, const cv::Mat& theirs) {
  const Frame ours = decode_picture(bytes);
  if (ours.width != theirs.cols || ours.height != theirs.rows) return 256;
  int largest = 0;
  for (int y = 0; y < ours.height; ++y) {
    for (int x = 0; x < ours.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        largest = std::max(largest, std::abs(ours.row(y)[static_cast<std::size_t>(3 * x + c)] -
                                             theirs.ptr<std::uint8_t>(y)[3 * x + 2 - c]));
      }
    }
  }
  return largest;
}

TEST(PictureDecoders, GiveWhatOpenCvGives) {
  struct Kind {
    const char* ending;
    int type;
    int most;  ///< Difference: chroma is interpolated in different ways.
    std::vector<int> options{};
  };
  for (const Kind& kind : std::vector<Kind>{
           {".png", CV_8UC3, 0},
           {".png", CV_8UC1, 0},
           {".png", CV_16UC3, 1},
           {".png", CV_16UC1, 1},
           {".png", CV_8UC4, 0},
           {".bmp", CV_8UC3, 0},
           {".bmp", CV_8UC1, 0},
           {".bmp", CV_8UC4, 0},
           {".ppm", CV_8UC3, 0},
           {".ppm", CV_16UC3, 1},
           {".ppm", CV_8UC3, 0, {cv::IMWRITE_PXM_BINARY, 0}},
           {".pgm", CV_8UC1, 0},
           {".pgm", CV_16UC1, 1},
           {".pbm", CV_8UC1, 0},
           {".jpg", CV_8UC3, 3},
           {".jpg", CV_8UC1, 1},
           {".jpg", CV_8UC3, 3, {cv::IMWRITE_JPEG_PROGRESSIVE, 1}},
       }) {
    const auto bytes = encoded(kind.ending, smooth(kind.type), kind.options);
    EXPECT_LE(largest_difference(bytes, cv::imdecode(bytes, cv::IMREAD_COLOR)), kind.most)
        << kind.ending << " of type " << kind.type;
  }
}

TEST(PictureDecoders, GiveWhatTheLibrariesOfTheirFormatsGive) {
  const eyebridge::testing::ScratchFolder folder;
  const std::string at = folder.path() + "/";
  const auto check = [&](const std::string& ending, const cv::Mat& picture,
                         const std::string& decode, const std::vector<int>& options = {}) {
    const auto bytes = encoded(ending, picture, options);
    std::ofstream(at + "p", std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    ASSERT_EQ(std::system((decode + " 2>/dev/null").c_str()), 0) << "see cmake/packages.txt";
    EXPECT_LE(largest_difference(bytes, cv::imread(at + "p.ppm", cv::IMREAD_COLOR)), 2) << ending;
  };
  const std::string tiff = "tifftopnm " + at + "p > " + at + "p.ppm";
  check(".tiff", smooth(CV_8UC3), tiff);
  check(".tiff", smooth(CV_8UC1), tiff);
  check(".tiff", smooth(CV_16UC3), tiff);
  check(".tiff", smooth(CV_8UC3), tiff, {cv::IMWRITE_TIFF_COMPRESSION, 1});
  const std::string webp = "dwebp -quiet -ppm " + at + "p -o " + at + "p.ppm";
  check(".webp", smooth(CV_8UC3), webp, {cv::IMWRITE_WEBP_QUALITY, 90});
  check(".webp", smooth(CV_8UC3), webp, {cv::IMWRITE_WEBP_QUALITY, 101});  // without loss
}

// Maps of ROS are read by another decoder, stb_image, and by their own rule: the mean of the
// colours.
TEST(PictureDecoders, PicturesOfMapsAreGreyAsOpenCvHasThem) {
  struct Kind {
    const char* ending;
    int type;
  };
  for (const Kind& kind : {Kind{".png", CV_8UC3}, Kind{".png", CV_8UC1}, Kind{".png", CV_16UC1},
                           Kind{".png", CV_16UC3}, Kind{".png", CV_8UC4}, Kind{".bmp", CV_8UC3},
                           Kind{".bmp", CV_8UC1}, Kind{".bmp", CV_8UC4}, Kind{".pgm", CV_8UC1},
                           Kind{".pgm", CV_16UC1}, Kind{".ppm", CV_8UC3}}) {
    const auto bytes = encoded(kind.ending, smooth(kind.type));
    const auto ours =
        files::read_map_picture({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, "map");
    const cv::Mat theirs = cv::imdecode(bytes, cv::IMREAD_COLOR);
    ASSERT_EQ(ours.columns, theirs.cols);
    ASSERT_EQ(ours.rows, theirs.rows);
    int largest = 0;
    for (int y = 0; y < ours.rows; ++y) {
      for (int x = 0; x < ours.columns; ++x) {
        const std::uint8_t* bgr = theirs.ptr<std::uint8_t>(y) + std::ptrdiff_t{3} * x;
        const int mean = (bgr[0] + bgr[1] + bgr[2]) / 3;
        largest = std::max(
            largest, std::abs(ours.greys[static_cast<std::size_t>(y * ours.columns + x)] - mean));
      }
    }
    EXPECT_LE(largest, 1) << kind.ending << " of type " << kind.type;
  }
}

TEST(PictureDecoders, SizesAreKnownBeforeDecoding) {
  const eyebridge::testing::ScratchFolder folder;
  for (const char* ending : {".png", ".bmp", ".jpg", ".ppm", ".tiff", ".webp"}) {
    const auto bytes = encoded(ending, smooth(CV_8UC3));
    const std::string file = folder.path() + "/p";
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    EXPECT_EQ(picture_size(file), (Size{53, 31})) << ending;
  }
}

TEST(PictureDecoders, WhatIsCutOrTooLargeIsAnErrorThatSaysWhich) {
  for (const char* ending : {".tiff", ".webp", ".ppm"}) {
    const auto whole = encoded(ending, smooth(CV_8UC3));
    for (const std::size_t size : {std::size_t{4}, std::size_t{20}, whole.size() / 3}) {
      try {
        decode_picture({whole.data(), size});
        ADD_FAILURE() << ending << " of " << size << " bytes was read";
      } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(),
                    ::testing::AnyOf(HasSubstr("TIFF: "), HasSubstr("WebP: "), HasSubstr("PNM: ")));
      }
    }
    try {
      decode_picture(whole, 1000);
      ADD_FAILURE() << ending << " was read";
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr("1000")) << ending;
    }
  }
}

}  // namespace
}  // namespace eyebridge::camera
