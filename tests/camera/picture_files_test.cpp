// What decode_picture() makes of JPEG and BMP files; picture_test.cpp has PNG.
#include "picture_files.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"
#include "eyebridge/camera/picture.hpp"
#include "pictures/turn.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Le;

std::string decode_error(const Bytes& bytes, std::uint64_t most_pixels = kMostPicturePixels) {
  try {
    decode_picture(bytes, most_pixels);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

/// Of each byte of two pictures of one size.
std::vector<int> differences(const Frame& a, const Frame& b) {
  std::vector<int> out;
  for (std::size_t i = 0; i < a.bytes.size(); ++i) {
    out.push_back(std::abs(a.bytes[i] - b.bytes.at(i)));
  }
  return out;
}

TEST(Jpeg, ColourPicturesComeBackNearlyAsTheyWere) {
  const Frame frame = halves(48, 33);
  for (const int flags : {0, TJFLAG_PROGRESSIVE}) {
    const Frame back = decode_picture(jpeg_of(frame, TJSAMP_444, flags));
    ASSERT_EQ(back.width, 48);
    ASSERT_EQ(back.height, 33);
    EXPECT_EQ(back.format, PixelFormat::Rgb24);
    EXPECT_THAT(differences(frame, back), Each(Le(6)));
  }
}

TEST(Jpeg, GreyPicturesComeAsRgb) {
  Frame frame = make_frame(17, 9, PixelFormat::Rgb24);
  std::fill(frame.bytes.begin(), frame.bytes.end(), std::uint8_t{90});
  const Frame back = decode_picture(jpeg_of(frame, TJSAMP_GRAY, 0));
  EXPECT_THAT(differences(frame, back), Each(Le(1)));
}

TEST(Png, SixteenBitsAreAsBrightAsOtherDecodersMakeThem) {
  const Frame frame = read_picture(EYEBRIDGE_SHARED_DIR "/cases/pictures/16-bit.png");
  double red = 0.0;
  for (std::size_t i = 0; i < frame.bytes.size(); i += 3) red += frame.bytes[i];
  EXPECT_NEAR(red / static_cast<double>(frame.bytes.size() / 3), 125.0, 1.0);
}

TEST(Jpeg, ACutOrDamagedFileIsAnError) {
  const Bytes whole = jpeg_of(halves(64, 64), TJSAMP_420, 0);
  for (std::size_t size = 3; size + 2 < whole.size(); size += 7) {
    EXPECT_THAT(decode_error(Bytes(whole.begin(), whole.begin() + static_cast<long>(size))),
                HasSubstr("JPEG"))
        << size;
  }
  EXPECT_EQ(decode_error(whole), "");
}

TEST(Jpeg, WithoutItsEndIsThePicture) {
  const Frame frame = read_picture(EYEBRIDGE_SHARED_DIR "/cases/pictures/noeoi.jpg");
  EXPECT_GT(frame.width, 0);
}

TEST(Jpeg, LiesAsExifSays) {
  const std::string turned = EYEBRIDGE_SHARED_DIR "/cases/pictures/exif-turned.jpg";
  const Frame frame = read_picture(turned);
  EXPECT_GT(frame.height, frame.width) << "orientation 6: it stands";
  EXPECT_EQ(picture_size(turned), (Size{frame.width, frame.height}));
  // The eight ways: the same picture again when it is turned back.
  const Frame small = halves(5, 3);
  constexpr int kBack[] = {0, 1, 2, 3, 4, 5, 8, 7, 6};
  for (int way = 1; way <= 8; ++way) {
    EXPECT_EQ(upright(upright(small, way), kBack[way]).bytes, small.bytes) << way;
  }
  // 6: what was the first row is the right column.
  const Frame right = upright(small, 6);
  for (int x = 0; x < 5; ++x) {
    const auto from = small.row(0).subspan(static_cast<std::size_t>(3 * x), 3);
    const auto to = right.row(x).subspan(6, 3);
    EXPECT_TRUE(std::ranges::equal(from, to)) << x;
  }
}

TEST(Jpeg, MorePixelsThanAllowedAreRefused) {
  const Bytes bytes = jpeg_of(halves(64, 64), TJSAMP_420, 0);
  EXPECT_EQ(decode_error(bytes, 64 * 64), "");
  EXPECT_THAT(decode_error(bytes, 64 * 64 - 1), HasSubstr("64 x 64 pixels, expected 1 ... 4095"));
}

/// The bytes of a BMP, little-endian.
class BmpWriter {
 public:
  BmpWriter& u8(std::initializer_list<int> values) {
    for (const int value : values) bytes_.push_back(static_cast<std::uint8_t>(value));
    return *this;
  }
  BmpWriter& u16(int value) { return u8({value & 255, value >> 8 & 255}); }
  BmpWriter& i32(std::int32_t value) { return u16(value).u16(value >> 16); }
  /// The file header, for pixels that start at `pixels`.
  BmpWriter& file(int pixels) { return u8({'B', 'M'}).i32(0).i32(0).i32(pixels); }
  /// Windows' header of 40 bytes.
  BmpWriter& info(std::int32_t width, std::int32_t height, int bits, int compression = 0,
                  int colours = 0) {
    i32(40).i32(width).i32(height).u16(1).u16(bits).i32(compression);
    return i32(0).i32(0).i32(0).i32(colours).i32(0);
  }
  operator const Bytes&() const { return bytes_; }

 private:
  Bytes bytes_;
};

/// Two rows of 24 bits, padded to 8 bytes: the first in the file is `first`, 1 … 6.
BmpWriter two_rows(std::int32_t height) {
  BmpWriter bmp;
  bmp.file(54).info(2, height, 24);
  bmp.u8({1, 2, 3, 4, 5, 6, 0, 0}).u8({11, 12, 13, 14, 15, 16, 0, 0});
  return bmp;
}

Bytes pixels_of(const Bytes& file) { return decode_picture(file).bytes; }

TEST(Bmp, RowsGoUpwardsUnlessTheHeightIsNegative) {
  EXPECT_THAT(pixels_of(two_rows(2)), ElementsAre(13, 12, 11, 16, 15, 14, 3, 2, 1, 6, 5, 4));
  EXPECT_THAT(pixels_of(two_rows(-2)), ElementsAre(3, 2, 1, 6, 5, 4, 13, 12, 11, 16, 15, 14));
}

TEST(Bmp, EightBitsAreLookedUpInThePalette) {
  BmpWriter bmp;
  bmp.file(54 + 8).info(3, 1, 8, 0, 2).u8({10, 20, 30, 0, 40, 50, 60, 0}).u8({1, 0, 1, 0});
  EXPECT_THAT(pixels_of(bmp), ElementsAre(60, 50, 40, 30, 20, 10, 60, 50, 40));
}

TEST(Bmp, TheHeaderMayBeThatOfOs2) {
  BmpWriter bmp;
  bmp.file(26).i32(12).u16(1).u16(1).u16(1).u16(24).u8({7, 8, 9, 0});
  EXPECT_THAT(pixels_of(bmp), ElementsAre(9, 8, 7));
}

TEST(Bmp, WhatItCannotBeIsAnErrorThatSaysWhy) {
  const auto error = [](const BmpWriter& bmp) { return decode_error(bmp); };
  const auto header = [](std::int32_t width, std::int32_t height, int bits, int compression = 0,
                         int colours = 0) {
    return BmpWriter().file(54).info(width, height, bits, compression, colours).u8({0, 0, 0, 0});
  };
  EXPECT_EQ(error(header(1, 1, 24)), "");
  EXPECT_THAT(error(header(1, 1, 24, 1)), HasSubstr("compressed"));
  EXPECT_THAT(error(header(1, 1, 16)), HasSubstr("16 bits a pixel, expected 8, 24 or 32"));
  EXPECT_THAT(error(header(0, 1, 24)), HasSubstr("a width of 0"));
  EXPECT_THAT(error(header(-1, 1, 24)), HasSubstr("a width of -1"));
  EXPECT_THAT(error(header(1, 0, 24)), HasSubstr("1 x 0 pixels"));
  EXPECT_THAT(error(header(1, 2, 24)), HasSubstr("the file is cut"));
  EXPECT_THAT(error(header(INT32_MAX, INT32_MIN, 24)), HasSubstr("the file is cut"));
  EXPECT_THAT(error(header(1, 1, 8)), HasSubstr("the file is cut")) << "no room for a palette";
  EXPECT_THAT(error(header(1, 1, 8, 0, 257)), HasSubstr("257 colours"));
  EXPECT_THAT(error(BmpWriter().file(54).i32(13)), HasSubstr("a header of 13 bytes"));
  EXPECT_THAT(error(BmpWriter().u8({'B', 'M'})), HasSubstr("the file is cut"));

  BmpWriter beyond;
  beyond.file(54 + 4).info(1, 1, 8, 0, 1).u8({10, 20, 30, 0}).u8({1, 0, 0, 0});
  EXPECT_THAT(error(beyond), HasSubstr("a colour that its palette lacks"));
}

TEST(Picture, DamagedFilesNeverCrashTheReader) {
  const Bytes files[] = {jpeg_of(halves(24, 16), TJSAMP_420, TJFLAG_PROGRESSIVE), two_rows(2)};
  Random random(7);
  int refused = 0;
  for (const Bytes& whole : files) {
    for (int i = 0; i < 500; ++i) {
      Bytes bytes = whole;
      bytes[random.bits() % bytes.size()] = static_cast<std::uint8_t>(random.bits());
      refused += decode_error(bytes, 1'000'000).empty() ? 0 : 1;
    }
  }
  EXPECT_GT(refused, 50);
  EXPECT_LT(refused, 950);
}

TEST(Picture, WhatIsNoPictureIsAnErrorThatNamesTheFile) {
  EXPECT_EQ(decode_error({}), "no picture: expected PNG, JPEG, BMP, PGM, PPM, TIFF or WebP");
  const Folder folder;
  folder.write("floor.gif", {'G', 'I', 'F'});
  for (const char* name : {"floor.gif", "missing.bmp", "."}) {
    try {
      read_picture(folder / name);
      ADD_FAILURE() << name << " was read";
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr((folder / name).string()));
    }
  }
}

}  // namespace
}  // namespace eyebridge::camera::testing
