#include "pixels/pixel_decoder.hpp"

#include <algorithm>
#include <cstring>
#include <string>

#include <libyuv/convert_argb.h>
#include <libyuv/convert_from_argb.h>
#include <libyuv/scale_argb.h>

#include "eyebridge/camera/convert.hpp"

namespace eyebridge::camera {
namespace {

// Rows converted at once: two passes over so few stay in the first-level cache.
constexpr int kStripRows = 4;

/// Bytes of a row (of Y) without padding.
std::size_t row_bytes(RawFormat format, int width) {
  const auto pixels = static_cast<std::size_t>(width);
  switch (format) {
    case RawFormat::Yuyv:
      return (pixels + 1) / 2 * 4;
    case RawFormat::Rgb24:
      return 3 * pixels;
    case RawFormat::Nv12:
    case RawFormat::Grey:
    case RawFormat::Mjpeg:
      break;
  }
  return pixels;
}

/// The size that a picture of `from` is cut to before it is scaled to `to`, as in fit().
Size cut_size(Size from, Size to) {
  const auto cut = [](int side, int a, int b) {
    return std::max(1, static_cast<int>(static_cast<long long>(side) * a / b));
  };
  const bool is_wider = static_cast<long long>(from.width) * to.height >
                        static_cast<long long>(from.height) * to.width;
  return is_wider ? Size{cut(from.height, to.width, to.height), from.height}
                  : Size{from.width, cut(from.width, to.height, to.width)};
}

/// The least size of the whole picture at which the part that is left has `to` pixels.
Size least_size(Size from, Size to) {
  const Size cut = cut_size(from, to);
  const auto grown = [](int side, int part, int wanted) {
    return static_cast<int>((static_cast<long long>(side) * wanted + part - 1) / part);
  };
  return {grown(from.width, cut.width, to.width), grown(from.height, cut.height, to.height)};
}

}  // namespace

std::size_t raw_bytes(RawFormat format, Size size, std::size_t stride) {
  const auto rows = static_cast<std::size_t>(size.height);
  const std::size_t last = row_bytes(format, size.width);
  if (format != RawFormat::Nv12) return stride * (rows - 1) + last;
  const std::size_t chroma = (static_cast<std::size_t>(size.width) + 1) / 2 * 2;
  return stride * rows + stride * ((rows + 1) / 2 - 1) + chroma;
}

Result<Frame> PixelDecoder::decode(const RawPicture& picture, Size size) {
  if (picture.format == RawFormat::Mjpeg) {
    return decode_mjpeg(picture.bytes, picture.size, least_size(picture.size, size), pool_)
        .map([&](Frame&& frame) { return fit(std::move(frame), size.width, size.height); });
  }
  const std::size_t row = row_bytes(picture.format, picture.size.width);
  const std::size_t stride = picture.stride > 0 ? static_cast<std::size_t>(picture.stride) : row;
  const std::size_t least = raw_bytes(picture.format, picture.size, stride);
  if (stride < row || picture.bytes.size() < least) {
    return fail(Errc::Corrupt, "a frame of " + std::to_string(picture.bytes.size()) +
                                   " bytes, expected " + std::to_string(least));
  }
  const bool by_four = picture.format == RawFormat::Yuyv || picture.format == RawFormat::Grey;
  const bool is_half = picture.size == Size{2 * size.width, 2 * size.height};
  const Size made = by_four && is_half ? size : picture.size;
  Frame frame = pool_.make(made.width, made.height, PixelFormat::Rgb24);
  if (by_four) {
    strips_to_rgb(picture, stride, frame);
  } else {
    to_rgb(picture, stride, frame);
  }
  return fit(std::move(frame), size.width, size.height);
}

void PixelDecoder::to_rgb(const RawPicture& picture, std::size_t stride, Frame& frame) {
  const auto [width, height] = picture.size;
  const int in_stride = static_cast<int>(stride);
  const std::uint8_t* in = picture.bytes.data();
  std::uint8_t* out = frame.bytes.data();
  if (picture.format == RawFormat::Nv12) {
    libyuv::NV12ToRAW(in, in_stride, in + stride * static_cast<std::size_t>(height), in_stride, out,
                      frame.stride, width, height);
    return;
  }
  const auto out_stride = static_cast<std::size_t>(frame.stride);
  for (int y = 0; y < height; ++y, in += stride, out += out_stride) {
    std::memcpy(out, in, out_stride);
  }
}

// libyuv has no way from these to three bytes a pixel but by four.
void PixelDecoder::strips_to_rgb(const RawPicture& picture, std::size_t stride, Frame& frame) {
  const auto [width, height] = picture.size;
  const bool halved = frame.width != width;
  const int in_stride = static_cast<int>(stride);
  const int strip_stride = 4 * width;
  strip_.resize(static_cast<std::size_t>(strip_stride) * kStripRows);
  const auto to_bgra = picture.format == RawFormat::Yuyv ? libyuv::YUY2ToARGB : libyuv::J400ToARGB;
  const std::uint8_t* in = picture.bytes.data();
  std::uint8_t* out = frame.bytes.data();
  for (int y = 0; y < height; y += kStripRows) {
    int rows = std::min(kStripRows, height - y);
    to_bgra(in, in_stride, strip_.data(), strip_stride, width, rows);
    in += stride * static_cast<std::size_t>(rows);
    if (halved) {
      rows /= 2;
      half_strip_.resize(strip_.size() / 4);
      libyuv::ARGBScale(strip_.data(), strip_stride, width, 2 * rows, half_strip_.data(),
                        4 * frame.width, frame.width, rows, libyuv::kFilterBox);
    }
    const std::vector<std::uint8_t>& bgra = halved ? half_strip_ : strip_;
    libyuv::ARGBToRAW(bgra.data(), 4 * frame.width, out, frame.stride, frame.width, rows);
    out += static_cast<std::size_t>(frame.stride) * static_cast<std::size_t>(rows);
  }
}

}  // namespace eyebridge::camera
