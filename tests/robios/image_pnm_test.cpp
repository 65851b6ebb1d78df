#include <fstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "pnm.hpp"

namespace eyebridge::robios {
namespace {

using Image = std::vector<std::uint8_t>;

Result<PnmImage> read(std::string_view text) {
  const Image bytes(text.begin(), text.end());
  return read_pnm(bytes, "test.pnm");
}

TEST(ReadPnm, ReadsTextBitmapsWithAndWithoutBlanks) {
  const PnmImage expected{PnmKind::Bitmap, {3, 2}, {1, 0, 1, 0, 1, 0}};
  EXPECT_EQ(read("P1 3 2\n1 0 1\n0 1 0\n").value(), expected);
  EXPECT_EQ(read("P1\n3 2\n101010").value(), expected);
}

TEST(ReadPnm, ReadsTextGreyAndScalesIt) {
  EXPECT_EQ(read("P2 3 1 10 0 5 10").value(),
            (PnmImage{PnmKind::Grey, {3, 1}, {0, 128, 255}}));  // 127.5 rounds up
}

TEST(ReadPnm, ReadsTextColour) {
  EXPECT_EQ(read("P3 1 2 255 1 2 3 4 5 6").value(),
            (PnmImage{PnmKind::Colour, {1, 2}, {1, 2, 3, 4, 5, 6}}));
}

TEST(ReadPnm, ReadsBinaryBitmapsWithPaddedRows) {
  const PnmImage image = read("P4\n9 2\n\x80\x80\x01\x7F").value();
  EXPECT_EQ(image.size, (ImageSize{9, 2}));
  EXPECT_EQ(image.bytes, (Image{1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0}));
}

TEST(ReadPnm, ReadsBinaryGreyAndColour) {
  EXPECT_EQ(read(std::string_view("P5 2 1 255\n\x00\xFF", 13)).value().bytes, (Image{0, 255}));
  EXPECT_EQ(read("P6 1 1 255\nabc").value().bytes, (Image{'a', 'b', 'c'}));
}

TEST(ReadPnm, ReadsSixteenBitValues) {
  EXPECT_EQ(read(std::string_view("P5 2 1 65535\n\x80\x00\xFF\xFF", 17)).value().bytes,
            (Image{128, 255}));
}

TEST(ReadPnm, SkipsComments) {
  EXPECT_EQ(read("P2 # made by hand\n# 7 7\n2 1\n#x\n255 # max\n3 #\n 4").value().bytes,
            (Image{3, 4}));
}

TEST(ReadPnm, ABinaryPixelMayLookLikeABlankOrAComment) {
  EXPECT_EQ(read("P5 2 1 255\n #").value().bytes, (Image{' ', '#'}));
}

TEST(ReadPnm, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(read("").error().what, "test.pnm: at byte 0: found the end, expected P1 to P6");
  EXPECT_EQ(read("P7 1 1").error().what, "test.pnm: at byte 0: found byte 80, expected P1 to P6");
  EXPECT_EQ(read("P2 x").error().what,
            "test.pnm: at byte 3: found byte 120, expected width and height, 1 to 65535 each");
  EXPECT_EQ(read("P2 2 1 9 1 12").error().what,
            "test.pnm: at byte 13: found the end, expected a value of 0 to 9");
  EXPECT_EQ(read("P5 1 1 255\n").error().what,
            "test.pnm: at byte 11: found the end, expected 1 bytes of pixels");
}

TEST(ReadPnm, RefusesHostileFiles) {
  for (const std::string_view text :
       {"P", "P1", "P2 0 5 255 ", "P2 -1 5 255 ", "P2 99999999999999999999 1 255 1",
        "P5 65535 65535 255\nx", "P6 65535 65535 65535\n", "P4 65535 65535\n", "P1 65535 65535 1",
        "P2 1 1 0 0", "P2 1 1 65536 0", "P2 2 1 255 1", "P1 1 1 2", "P3 1 1 255 1 2", "P5 1 1",
        "P5 1 1 255", "P5 1 1 255#x\n1", "P2 1 1 255 #no end"}) {
    const auto image = read(text);
    ASSERT_FALSE(image) << text;
    EXPECT_EQ(image.error().code, Errc::Corrupt) << text;
  }
}

TEST(ReadPnm, EveryCutOfAFileIsRefused) {
  const Image whole = write_pnm({PnmKind::Colour, {3, 2}, Image(18, 'x')});
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_FALSE(read_pnm(ConstBytes(whole).first(length), "cut")) << length;
  }
  EXPECT_TRUE(read_pnm(whole, "whole"));
}

TEST(WritePnm, WhatIsWrittenIsReadBack) {
  for (const PnmKind kind : {PnmKind::Bitmap, PnmKind::Grey, PnmKind::Colour}) {
    for (const int width : {1, 7, 8, 9, 17}) {
      PnmImage image{kind, {width, 3}, {}};
      for (std::size_t i = 0; i < image.size.pixels() * pnm_channels(kind); ++i) {
        image.bytes.push_back(
            static_cast<std::uint8_t>(kind == PnmKind::Bitmap ? i % 3 == 0 : i * 37));
      }
      EXPECT_EQ(read_pnm(write_pnm(image), "round trip").value(), image);
    }
  }
}

TEST(PnmFile, IsWrittenAndReadAndMissedByName) {
  const auto path = std::filesystem::path(testing::TempDir()) / "eyebridge_image_test.pgm";
  const PnmImage image{PnmKind::Grey, {2, 2}, {1, 2, 3, 4}};
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
  const PnmImage image{PnmKind::Grey, {2, 2}, {1, 2, 3, 4}};
  Image out(9, 99);
  fit(image, {3, 3}, out);
  EXPECT_EQ(out, (Image{1, 2, 0, 3, 4, 0, 0, 0, 0}));
  Image one(1, 99);
  fit(image, {1, 1}, one);
  EXPECT_EQ(one, (Image{1}));
}

TEST(Fit, KeepsColourPixelsWhole) {
  const PnmImage image{PnmKind::Colour, {2, 1}, {1, 2, 3, 4, 5, 6}};
  Image out(6, 99);
  fit(image, {1, 2}, out);
  EXPECT_EQ(out, (Image{1, 2, 3, 0, 0, 0}));
}

}  // namespace
}  // namespace eyebridge::robios
