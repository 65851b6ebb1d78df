#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// A frame of a series, without its picture.
struct SeriesEntry {
  Time due{0};               ///< When it is to be given out, from the start of the series.
  Time taken{0};             ///< Its own time, likewise.
  std::uint64_t number = 0;  ///< From 0; gaps are frames that were dropped when it was made.
};

/// Pictures with times, one after the other: a folder, a video or a recording, opened. What is done
/// at its end, and how its times meet the robot's clock, is the business of who reads it. One
/// thread at a time.
class FrameSeries {
 public:
  virtual ~FrameSeries() = default;

  /// Of its first picture.
  [[nodiscard]] virtual Size size() const = 0;
  /// From one frame to the next, where nothing better is known; > 0.
  [[nodiscard]] virtual Time period() const = 0;
  /// True when its times are those of a robot's clock; else they count from its first frame.
  [[nodiscard]] virtual bool is_on_robots_clock() const = 0;

  /// The frame that the series is at, or with `ahead` = 1 the one after it; none past the last. Due
  /// times do not decrease.
  virtual std::optional<SeriesEntry> entry(int ahead) = 0;
  /// The picture of entry(0), in any format. Fails with Corrupt. Not to be called past the last.
  virtual Result<Frame> picture() = 0;
  /// Goes to the next frame.
  virtual void advance() = 0;
  /// Goes back to the first.
  virtual void rewind() = 0;
};

// All throw ConfigError naming the file, or "--camera" where a library is missing.

/// The pictures of a folder (names that end in png, jpg, jpeg or bmp; other files are left out), in
/// the natural order of their names: frame2 comes before frame10; `rate` of them
/// a second, 0.01 … 1000. Those of another size than the first one that can be read, and those that
/// cannot be read, fail at their turn.
std::unique_ptr<FrameSeries> open_folder_series(const std::filesystem::path& folder, double rate);
/// The frames of a recording, at the times when they were given.
std::unique_ptr<FrameSeries> open_recorded_series(const std::filesystem::path& file);
/// A video file of any kind that OpenCV (FFmpeg) reads, at its own times; with a `rate` > 0, so
/// many frames a second: for files that have no times (has_no_times()).
std::unique_ptr<FrameSeries> open_video_series(const std::filesystem::path& file, double rate = 0);
/// Whether a file is frames alone, without a container that says when each is due: JPEGs one after
/// another, or H.264.
bool has_no_times(const std::filesystem::path& file);

/// The pictures of `folder` as open_folder_series() takes them. Throws ConfigError when there are
/// none, or the folder cannot be read.
std::vector<std::filesystem::path> pictures_in(const std::filesystem::path& folder);

/// Whether `a` comes before `b` when numbers within are compared as numbers; letters without regard
/// to their case, then by their bytes.
bool natural_less(const std::string& a, const std::string& b);

}  // namespace eyebridge::camera
