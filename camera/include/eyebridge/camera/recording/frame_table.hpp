#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "eyebridge/base/result.hpp"
#include "eyebridge/camera/recording/frame_codec.hpp"
#include "eyebridge/camera/recording/recording_file.hpp"

namespace eyebridge::camera {

/// Writes the table `frame` of a recording. Any thread.
class FrameWriter {
 public:
  /// `file` is lent. Throws std::runtime_error.
  FrameWriter(RecordingFile& file, FrameCodec codec);

  /// `now` is when the program was given the frame, on the robot's clock. Throws
  /// std::runtime_error when it cannot be packed, or the disk does not take it.
  void add(const Frame& frame, Time now);

 private:
  RecordingFile& file_;
  FrameCodec codec_;
  sqlite::Statement insert_;
};

/// A row of the table `frame`, without its pixels.
struct RecordedFrame {
  Time given{0};  ///< When the program was given it, on the robot's clock; never decreases.
  Time taken{0};  ///< Its own time, as in Frame.
  std::uint64_t sequence = 0;  ///< As in Frame; a camera that was opened again starts at 0 again.
  Size size;
  PixelFormat format = PixelFormat::Rgb24;
  FrameCodec codec = FrameCodec::Lossless;
  std::int64_t row = 0;    ///< Its key.
  std::int64_t bytes = 0;  ///< Of its packed pixels.
};

/// The frames of a recording. One thread at a time.
class FrameReader {
 public:
  /// Reads all but the pixels. A recording may have no frames. Throws ConfigError naming the file:
  /// it is missing, no recording, of another version, or damaged.
  explicit FrameReader(const std::filesystem::path& path);

  /// In the order in which they were given.
  [[nodiscard]] std::span<const RecordedFrame> frames() const { return frames_; }

  /// Frame `index` of frames(), with its time and sequence. Fails with Corrupt naming file and
  /// frame.
  Result<Frame> read(std::size_t index);

 private:
  void read_rows();

  std::filesystem::path path_;
  sqlite::Database database_;
  sqlite::Statement data_;
  std::vector<RecordedFrame> frames_;
};

}  // namespace eyebridge::camera
