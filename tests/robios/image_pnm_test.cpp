#include <fstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "pnm.hpp"

namespace eyebridge::robios {
namespace {

using Image = std::vector<std::uint8_t>;

/// As the bytes of a file.
std::string text_of(const PnmPicture& picture) {
  const Image bytes = write_pnm(picture);
  return {bytes.begin(), bytes.end()};
}

TEST(WritePnm, WhatIsWrittenIsReadBack) {
  for (const PnmKind kind : {PnmKind::Bitmap, PnmKind::Grey, PnmKind::Colour}) {
    for (const int width : {1, 7, 8, 9, 17}) {
      PnmPicture image{kind, width, 3, {}};
      for (std::size_t i = 0; i < 3 * static_cast<std::size_t>(width) * pnm_channels(kind); ++i) {
        image.bytes.push_back(
            static_cast<std::uint8_t>(kind == PnmKind::Bitmap ? i % 3 == 0 : i * 37));
      }
      EXPECT_EQ(read_pnm(text_of(image), "round trip"), image);
    }
  }
}

TEST(PnmFile, IsWrittenAndReadAndMissedByName) {
  const auto path = std::filesystem::path(testing::TempDir()) / "eyebridge_image_test.pgm";
  const PnmPicture image{PnmKind::Grey, 2, 2, {1, 2, 3, 4}};
  ASSERT_TRUE(write_pnm_file(image, path));
  EXPECT_EQ(read_pnm_file(path).value(), image);
  std::filesystem::remove(path);

  const auto missing = read_pnm_file(path);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().what, path.string() + ": no such file");
  const auto nowhere = write_pnm_file(image, "/nonexistent/folder/x.pgm");
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().what,
            "/nonexistent/folder/x.pgm: cannot be written: No such file or directory");
  EXPECT_FALSE(read_pnm_file(testing::TempDir()));
}

TEST(Fit, FillsUpSmallImagesAndCutsLargeOnes) {
  const PnmPicture image{PnmKind::Grey, 2, 2, {1, 2, 3, 4}};
  Image out(9, 99);
  fit(image, {3, 3}, out);
  EXPECT_EQ(out, (Image{1, 2, 0, 3, 4, 0, 0, 0, 0}));
  Image one(1, 99);
  fit(image, {1, 1}, one);
  EXPECT_EQ(one, (Image{1}));
}

TEST(Fit, KeepsColourPixelsWhole) {
  const PnmPicture image{PnmKind::Colour, 2, 1, {1, 2, 3, 4, 5, 6}};
  Image out(6, 99);
  fit(image, {1, 2}, out);
  EXPECT_EQ(out, (Image{1, 2, 3, 0, 0, 0}));
}

}  // namespace
}  // namespace eyebridge::robios
