// Raw bytes of cameras to R, G, B: exact where nothing is lost, and never a crash.
#include <algorithm>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"
#include "eyebridge/camera/convert.hpp"
#include "jpeg_pictures.hpp"
#include "pixels/pixel_decoder.hpp"
#include "reference_colours.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

Bytes noise(std::size_t size, std::uint64_t seed = 1) {
  Random random(seed);
  Bytes out(size);
  for (std::uint8_t& byte : out) byte = static_cast<std::uint8_t>(random.uniform() * 256.0);
  return out;
}

Frame decoded(RawFormat format, Size size, const Bytes& bytes, Size to, int stride = 0) {
  PixelDecoder decoder;
  Result<Frame> frame = decoder.decode({format, size, stride, bytes}, to);
  EXPECT_TRUE(frame) << frame.error().what;
  return frame ? *std::move(frame) : Frame{};
}

TEST(Pixels, EachColourOfYuyvIsThatOfTheReference) {
  PixelDecoder decoder;
  Bytes raw(4 * 128 * 256);
  for (int v = 0; v < 256; v += 3) {
    for (int u = 0; u < 256; ++u) {
      for (int y = 0; y < 256; y += 2) {
        std::uint8_t* two = raw.data() + static_cast<std::ptrdiff_t>(4 * (u * 128 + y / 2));
        two[0] = static_cast<std::uint8_t>(y);
        two[1] = static_cast<std::uint8_t>(u);
        two[2] = static_cast<std::uint8_t>(y + 1);
        two[3] = static_cast<std::uint8_t>(v);
      }
    }
    const Result<Frame> frame = decoder.decode({RawFormat::Yuyv, {256, 256}, 0, raw}, {256, 256});
    ASSERT_TRUE(frame);
    ASSERT_EQ(frame->bytes, reference_of_yuyv(raw)) << "v = " << v;
  }
}

TEST(Pixels, TheReferenceIsBt601) {
  double worst = 0.0;
  for (int y = 16; y <= 235; y += 3) {
    for (int u = 16; u <= 240; u += 8) {
      for (int v = 16; v <= 240; v += 8) {
        const Pixel ours = reference_rgb(y, u, v);
        const auto exact = true_rgb(y, u, v);
        for (std::size_t c = 0; c < 3; ++c) {
          worst = std::max(worst, std::abs(ours[c] - exact[c]));
        }
      }
    }
  }
  EXPECT_LE(worst, 3.0);  // blue, at the ends of U
}

TEST(Pixels, RowsOfOddWidthAndPaddingAreRead) {
  constexpr int kStride = 24;
  const Bytes raw = noise(kStride * 7);
  const Frame frame = decoded(RawFormat::Yuyv, {5, 7}, raw, {5, 7}, kStride);
  for (int y = 0; y < 7; ++y) {
    const std::uint8_t* row = raw.data() + kStride * y;
    for (int x = 0; x < 5; ++x) {
      const std::uint8_t* two = row + x / 2 * 4;
      const Pixel expected = reference_rgb(two[x % 2 * 2], two[1], two[3]);
      const auto got = frame.row(y).subspan(static_cast<std::size_t>(3 * x), 3);
      EXPECT_TRUE(std::ranges::equal(got, expected)) << x << ", " << y;
    }
  }
}

TEST(Pixels, Nv12IsReadWithTheColoursOfItsFours) {
  const Bytes raw = noise(32 * 12 * 3 / 2);
  const Frame frame = decoded(RawFormat::Nv12, {32, 12}, raw, {32, 12});
  for (int y = 0; y < 12; ++y) {
    for (int x = 0; x < 32; ++x) {
      const std::uint8_t* colour = raw.data() + 32 * 12 + y / 2 * 32 + x / 2 * 2;
      const Pixel expected =
          reference_rgb(raw[static_cast<std::size_t>(32 * y + x)], colour[0], colour[1]);
      const auto got = frame.row(y).subspan(static_cast<std::size_t>(3 * x), 3);
      ASSERT_TRUE(std::ranges::equal(got, expected)) << x << ", " << y;
    }
  }
}

TEST(Pixels, GreyAndRgbComeAsTheyAre) {
  const Bytes grey = noise(31 * 9);
  const Frame from_grey = decoded(RawFormat::Grey, {31, 9}, grey, {31, 9});
  for (std::size_t i = 0; i < grey.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(from_grey.bytes[3 * i + c], grey[i]);
  }
  const Bytes rgb = noise(3 * 31 * 9);
  EXPECT_EQ(decoded(RawFormat::Rgb24, {31, 9}, rgb, {31, 9}).bytes, rgb);
}

TEST(Pixels, OtherSizesAreCutAndScaledAsFitDoesIt) {
  const Bytes raw = noise(64 * 48 * 2);
  const Frame whole = decoded(RawFormat::Yuyv, {64, 48}, raw, {64, 48});
  for (const Size size : {Size{64, 20}, Size{20, 48}, Size{128, 96}, Size{7, 5}}) {
    EXPECT_EQ(decoded(RawFormat::Yuyv, {64, 48}, raw, size).bytes,
              fit(whole, size.width, size.height).bytes);
  }
}

// libyuv's means of four, which the processor has instructions for, round up twice.
TEST(Pixels, HalfTheSizeIsAsFitMakesItButForRounding) {
  for (const Size size : {Size{64, 48}, Size{60, 46}, Size{4, 2}}) {
    const Bytes raw = noise(static_cast<std::size_t>(size.width * size.height * 2));
    for (const RawFormat format : {RawFormat::Yuyv, RawFormat::Grey}) {
      const Frame expected = fit(decoded(format, size, raw, size), size.width / 2, size.height / 2);
      const Frame half = decoded(format, size, raw, {size.width / 2, size.height / 2});
      ASSERT_EQ(half.bytes.size(), expected.bytes.size());
      for (std::size_t i = 0; i < half.bytes.size(); ++i) {
        ASSERT_NEAR(half.bytes[i], expected.bytes[i], 1) << i << " of " << size.width;
      }
    }
  }
}

TEST(Pixels, TooFewBytesAreCorrupt) {
  PixelDecoder decoder;
  const Bytes raw = noise(64 * 48 * 2 - 1);
  const Result<Frame> frame = decoder.decode({RawFormat::Yuyv, {64, 48}, 0, raw}, {64, 48});
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().code, Errc::Corrupt);
  EXPECT_THAT(frame.error().what, HasSubstr("6143 bytes, expected 6144"));
  EXPECT_FALSE(decoder.decode({RawFormat::Grey, {64, 48}, 32, raw}, {64, 48})) << "a row overlaps";
}

TEST(Mjpeg, IsAsGoodAsItWasCompressed) {
  for (const int subsampling : {TJSAMP_444, TJSAMP_422, TJSAMP_420}) {
    const Bytes picture = smooth_picture(320, 240);
    const Bytes jpeg = jpeg_of(picture, 320, 240, 95, subsampling);
    EXPECT_GE(psnr(decoded(RawFormat::Mjpeg, {320, 240}, jpeg, {320, 240}).bytes, picture), 45.0);
  }
}

TEST(Mjpeg, IsDecodedSmallerWhereThatIsEnough) {
  const Bytes picture = smooth_picture(640, 480);
  const Bytes jpeg = jpeg_of(picture, 640, 480);
  Frame whole = make_frame(640, 480, PixelFormat::Rgb24);
  whole.bytes = picture;
  for (const Size size : {Size{320, 240}, Size{160, 120}, Size{200, 200}, Size{352, 288}}) {
    const Frame small = decoded(RawFormat::Mjpeg, {640, 480}, jpeg, size);
    EXPECT_EQ(small.width, size.width);
    EXPECT_EQ(small.height, size.height);
    EXPECT_GE(psnr(small.bytes, fit(whole, size.width, size.height).bytes), 40.0);
  }
  FramePool pool;
  EXPECT_EQ(decode_mjpeg(jpeg, {640, 480}, {300, 200}, pool)->width, 320);
  EXPECT_EQ(decode_mjpeg(jpeg, {640, 480}, {321, 200}, pool)->width, 400);
  EXPECT_EQ(decode_mjpeg(jpeg, {640, 480}, {2000, 2000}, pool)->width, 640);
}

TEST(Pixels, NothingOfAnEarlierFrameIsLeftInItsMemory) {
  const Size size{37, 23};  // odd: rows end within a pair of pixels, a block, a strip
  const Bytes picture = smooth_picture(size.width, size.height);
  const Bytes random = noise(4096, 7);
  for (const RawFormat format :
       {RawFormat::Yuyv, RawFormat::Nv12, RawFormat::Rgb24, RawFormat::Grey, RawFormat::Mjpeg}) {
    const Bytes raw =
        format == RawFormat::Mjpeg ? jpeg_of(picture, size.width, size.height) : random;
    PixelDecoder decoder;
    for (const int fill : {0x00, 0xFF}) {
      Frame earlier = *decoder.decode({format, size, 0, raw}, size);
      std::ranges::fill(earlier.bytes, static_cast<std::uint8_t>(fill));
      static_cast<void>(decoder.share(std::move(earlier)));
      EXPECT_EQ(decoder.decode({format, size, 0, raw}, size)->bytes,
                decoded(format, size, raw, size).bytes);
    }
  }
}

TEST(FramePool, UsesTheMemoryOfFramesThatNobodyHas) {
  FramePool pool;
  Frame first = pool.make(8, 4, PixelFormat::Rgb24);
  std::ranges::fill(first.bytes, std::uint8_t{7});
  FramePtr held = pool.share(std::move(first));
  const std::uint8_t* const memory = held->bytes.data();
  EXPECT_NE(pool.make(8, 4, PixelFormat::Rgb24).bytes.data(), memory) << "somebody has it";
  held.reset();
  const Frame smaller = pool.make(8, 2, PixelFormat::Rgb24);
  EXPECT_EQ(smaller.bytes.size(), 48U);
  EXPECT_NE(smaller.bytes.data(), memory);
  const Frame again = pool.make(8, 4, PixelFormat::Rgb24);
  EXPECT_EQ(again.bytes.data(), memory);
  // The heap may give out the same place again, but cleared.
  EXPECT_THAT(again.bytes, ::testing::Each(7));
  EXPECT_EQ(again.stride, 24);
}

TEST(FramePool, FramesMayOutliveIt) {
  FramePtr frame;
  {
    FramePool pool;
    frame = pool.share(pool.make(8, 4, PixelFormat::Grey8));
  }
  EXPECT_EQ(frame->bytes.size(), 32U);
}

TEST(Mjpeg, AFrameWithoutHuffmanTablesIsRead) {
  const Bytes picture = smooth_picture(64, 48);
  const Bytes jpeg = without_tables(jpeg_of(picture, 64, 48));
  EXPECT_GE(psnr(decoded(RawFormat::Mjpeg, {64, 48}, jpeg, {64, 48}).bytes, picture), 40.0);
}

TEST(Mjpeg, WhatWebcamsAddAndLeaveOutIsReadAndNamed) {
  const Bytes picture = smooth_picture(64, 48);
  const Bytes jpeg = jpeg_of(picture, 64, 48);
  const Bytes plain = decoded(RawFormat::Mjpeg, {64, 48}, jpeg, {64, 48}).bytes;
  const auto read = [&](const Bytes& bytes) {
    PixelDecoder decoder;
    const auto frame = decoder.decode({RawFormat::Mjpeg, {64, 48}, 0, bytes}, {64, 48});
    EXPECT_TRUE(frame) << frame.error().what;
    if (!frame) return Oddities{};
    EXPECT_EQ(frame->bytes, plain);
    return frame->odd;
  };
  EXPECT_FALSE(read(jpeg).any());
  Bytes padded = jpeg;
  padded.resize(jpeg.size() + 100);
  EXPECT_FALSE(read(padded).any()) << "buffers are filled up with zeros";
  Bytes trailing = jpeg;
  trailing.insert(trailing.end(), {1, 2, 3});
  EXPECT_TRUE(read(trailing).trailing_bytes);
  const Bytes no_end(jpeg.begin(), jpeg.end() - 2);
  EXPECT_EQ(read(no_end).text(), "without an end");
  Bytes before = jpeg;
  before.insert(before.begin(), {0x00, 0x12, 0xFF});
  EXPECT_TRUE(read(before).stray_bytes);
  Bytes between = jpeg;
  between.insert(between.begin() + 2, {0x00, 0x12, 0x34});
  EXPECT_TRUE(read(between).stray_bytes);
  Bytes late = jpeg;
  late.insert(late.end() - 2, {0x12, 0x34});
  read(late);  // the decoder has taken them with the picture's last bits
}

TEST(Mjpeg, CutAnywhereItIsCorruptAndTheNextOneIsFine) {
  const Bytes jpeg = jpeg_of(smooth_picture(64, 48), 64, 48);
  PixelDecoder decoder;
  for (std::size_t size = 0; size + 2 < jpeg.size(); ++size) {  // FF D9 alone is not missed
    const Result<Frame> cut =
        decoder.decode({RawFormat::Mjpeg, {64, 48}, 0, {jpeg.data(), size}}, {64, 48});
    ASSERT_FALSE(cut) << size << " of " << jpeg.size();
    ASSERT_EQ(cut.error().code, Errc::Corrupt);
    ASSERT_TRUE(decoder.decode({RawFormat::Mjpeg, {64, 48}, 0, jpeg}, {64, 48}));
  }
}

TEST(Mjpeg, OfAnotherSizeThanTheStreamIsCorrupt) {
  const Bytes jpeg = jpeg_of(smooth_picture(64, 48), 64, 48);
  PixelDecoder decoder;
  const auto frame = decoder.decode({RawFormat::Mjpeg, {320, 240}, 0, jpeg}, {64, 48});
  ASSERT_FALSE(frame);
  EXPECT_THAT(frame.error().what, HasSubstr("64x48 in a stream of 320x240"));
}

}  // namespace
}  // namespace eyebridge::camera::testing
