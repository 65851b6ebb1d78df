#pragma once

#include <string>

#include "eyebridge/camera/convert.hpp"
#include "eyebridge/camera/png.hpp"
#include "eyebridge/camera/recording/frame_table.hpp"
#include "picture_files.hpp"

namespace eyebridge::camera::testing {

/// A small picture that shows its number: the red of all its pixels.
inline Frame numbered(int number, int width = 8, int height = 6) {
  Frame frame = make_frame(width, height, PixelFormat::Rgb24);
  for (std::size_t i = 0; i < frame.bytes.size(); i += 3) {
    frame.bytes[i] = static_cast<std::uint8_t>(number);
  }
  frame.sequence = static_cast<std::uint64_t>(number);
  frame.time = Time(static_cast<Time::rep>(number) * 1'000'000'000 / 30);
  return frame;
}

/// What numbered() shows; -1 where a picture shows no one number.
inline int number_of(const Frame& frame) {
  for (std::size_t i = 0; i < frame.bytes.size(); i += 3) {
    if (frame.bytes[i] != frame.bytes[0] || frame.bytes[i + 1] != 0) return -1;
  }
  return frame.bytes[0];
}

/// Files with numbered pictures, 30 a second; gone at the end.
class FrameFiles {
 public:
  /// A folder of `count` pictures: "frame 0.png" …, so that frame 10 comes after frame 9 only in
  /// natural order.
  [[nodiscard]] std::string folder(int count) const {
    std::filesystem::create_directory(path("pictures"));
    for (int i = 0; i < count; ++i) put(i, "pictures/frame " + std::to_string(i) + ".png");
    return path("pictures");
  }
  /// A recording of `count` frames, given when they were taken.
  [[nodiscard]] std::string recording(int count, FrameCodec codec = FrameCodec::Lossless) const {
    RecordingFile file(path("frames.ebrec"), {});
    FrameWriter writer(file, codec);
    for (int i = 0; i < count; ++i) writer.add(numbered(i), numbered(i).time);
    return path("frames.ebrec");
  }
  void put(int number, const std::string& name, int width = 8, int height = 6) const {
    write_png(numbered(number, width, height), path(name));
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_ / name.c_str(); }

 private:
  Folder folder_;
};

}  // namespace eyebridge::camera::testing
