#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <linux/videodev2.h>

#include "pixels/raw_picture.hpp"

namespace eyebridge::camera {

/// A format that is read here, by the names it goes by.
struct RawFormatName {
  std::string_view name;     ///< In URLs and messages.
  std::uint32_t fourcc = 0;  ///< V4L2's.
  RawFormat format{};
};

/// In order of preference: what loses nothing and costs least first; last what has no colour.
inline constexpr std::array<RawFormatName, 6> kRawFormats{{
    {"YUYV", V4L2_PIX_FMT_YUYV, RawFormat::Yuyv},
    {"NV12", V4L2_PIX_FMT_NV12, RawFormat::Nv12},
    {"RGB24", V4L2_PIX_FMT_RGB24, RawFormat::Rgb24},
    {"MJPEG", V4L2_PIX_FMT_MJPEG, RawFormat::Mjpeg},
    {"MJPEG", V4L2_PIX_FMT_JPEG, RawFormat::Mjpeg},
    {"GREY", V4L2_PIX_FMT_GREY, RawFormat::Grey},
}};
inline constexpr const char* kRawFormatNames = "one of YUYV, NV12, RGB24, MJPEG, GREY";

inline std::optional<RawFormat> raw_format_named(std::string_view name) {
  const auto found = std::ranges::find(kRawFormats, name, &RawFormatName::name);
  return found == kRawFormats.end() ? std::nullopt : std::optional(found->format);
}

inline const RawFormatName* raw_format_of(std::uint32_t fourcc) {
  const auto found = std::ranges::find(kRawFormats, fourcc, &RawFormatName::fourcc);
  return found == kRawFormats.end() ? nullptr : &*found;
}

/// "YUYV"; for formats that are not read here the four letters of V4L2.
inline std::string format_name(std::uint32_t fourcc) {
  if (const RawFormatName* known = raw_format_of(fourcc)) return std::string(known->name);
  std::string out;
  for (int shift = 0; shift < 32; shift += 8) {
    const auto letter = static_cast<char>(fourcc >> shift & 0x7FU);
    out += letter >= ' ' ? letter : '?';
  }
  return out;
}

}  // namespace eyebridge::camera
