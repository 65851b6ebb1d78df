#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::camera {

/// Of a picture, pixels.
struct Size {
  int width = 0;
  int height = 0;

  friend bool operator==(const Size&, const Size&) = default;
};

/// How the bytes of a frame are to be read. All are row-major, top-left first.
enum class PixelFormat {
  Rgb24,   ///< R, G, B.
  Bgra32,  ///< B, G, R, A.
  Grey8,   ///< One byte a pixel.
};

constexpr int bytes_per_pixel(PixelFormat format) {
  switch (format) {
    case PixelFormat::Rgb24:
      return 3;
    case PixelFormat::Bgra32:
      return 4;
    case PixelFormat::Grey8:
      return 1;
  }
  return 0;
}

/// What was odd in a JPEG of which all rows were decoded. Webcams send such, and viewers show them.
struct Oddities {
  bool stray_bytes = false;     ///< Before its beginning, or between its parts.
  bool no_end = false;          ///< No end marker.
  bool no_tables = false;       ///< No Huffman tables: those of the standard were taken.
  bool trailing_bytes = false;  ///< After its end.

  [[nodiscard]] bool any() const { return stray_bytes || no_end || no_tables || trailing_bytes; }
  /// "without an end, with bytes after their end"
  [[nodiscard]] std::string text() const;

  friend bool operator==(const Oddities&, const Oddities&) = default;
};

/// One picture. Shared and never changed once it has left its source.
struct Frame {
  int width = 0;   ///< Pixels.
  int height = 0;  ///< Pixels.
  int stride = 0;  ///< Bytes from one row to the next.
  PixelFormat format = PixelFormat::Rgb24;
  Time time{0};                ///< When it was taken, on the robot's clock.
  std::uint64_t sequence = 0;  ///< 0 for a source's first frame; gaps are dropped frames.
  Oddities odd{};              ///< Of the file or stream that it was decoded from.
  std::vector<std::uint8_t> bytes;

  [[nodiscard]] std::span<const std::uint8_t> row(int y) const {
    return {bytes.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(stride),
            static_cast<std::size_t>(width * bytes_per_pixel(format))};
  }
};

using FramePtr = std::shared_ptr<const Frame>;

}  // namespace eyebridge::camera
