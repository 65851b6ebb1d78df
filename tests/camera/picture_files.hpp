#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <turbojpeg.h>

#include "eyebridge/camera/convert.hpp"
#include "run_program.hpp"

namespace eyebridge::camera::testing {

using Bytes = std::vector<std::uint8_t>;

/// A folder of the test's own, removed at its end.
class Folder {
 public:
  [[nodiscard]] std::filesystem::path operator/(const char* name) const {
    return std::filesystem::path(str()) / name;
  }
  /// Makes a file of `bytes`.
  void write(const char* name, const Bytes& bytes) const {
    scratch_.write(name, {bytes.begin(), bytes.end()});
  }
  [[nodiscard]] const std::string& str() const { return scratch_.path(); }

 private:
  eyebridge::testing::ScratchFolder scratch_;
};

/// Red and blue halves, left and right.
inline Frame halves(int width, int height) {
  Frame frame = make_frame(width, height, PixelFormat::Rgb24);
  for (std::size_t i = 0; i < frame.bytes.size() / 3; ++i) {
    const bool left = i % static_cast<std::size_t>(width) < static_cast<std::size_t>(width) / 2;
    frame.bytes[3 * i + (left ? 0 : 2)] = 200;
  }
  return frame;
}

/// `frame` (Rgb24) as a JPEG of good quality; turbojpeg's subsampling and flags.
inline Bytes jpeg_of(const Frame& frame, int subsampling, int flags) {
  const std::unique_ptr<void, int (*)(void*)> encoder(tjInitCompress(), &tjDestroy);
  unsigned char* data = nullptr;
  unsigned long size = 0;
  EXPECT_EQ(tjCompress2(encoder.get(), frame.bytes.data(), frame.width, frame.stride, frame.height,
                        TJPF_RGB, &data, &size, subsampling, 95, flags),
            0);
  Bytes bytes(data, data + size);
  tjFree(data);
  return bytes;
}

}  // namespace eyebridge::camera::testing
