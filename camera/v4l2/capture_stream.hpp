#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "eyebridge/base/result.hpp"
#include "v4l2/mode.hpp"
#include "v4l2/video_handle.hpp"

namespace eyebridge::camera {

/// A frame as it lies in a buffer of the driver's; lent until give_back().
struct RawFrame {
  std::uint32_t buffer = 0;
  std::span<const std::uint8_t> bytes;
  std::uint32_t sequence = 0;  ///< The driver's; starts anew with streaming.
  Time taken{0};               ///< On CLOCK_MONOTONIC.
  bool is_stamped = false;     ///< Else `taken` is when it was dequeued.
  bool is_damaged = false;     ///< The driver says so.
};

/// What a look at the buffers found.
struct Taken {
  std::optional<RawFrame> newest;
  bool any = false;  ///< Frames came, though perhaps only such as were passed over.
  Time now{0};       ///< CLOCK_MONOTONIC of this look, where frames came.
};

/// A camera that streams into mapped buffers. One thread.
class CaptureStream {
 public:
  /// Maps the buffers and starts streaming. Throws ConfigError.
  CaptureStream(VideoHandle handle, Mode mode);
  ~CaptureStream();
  CaptureStream(const CaptureStream&) = delete;
  CaptureStream& operator=(const CaptureStream&) = delete;

  /// The newest frame that has come, if any; those before it go back at once. A frame is passed
  /// over when it may be older than it looks: it was taken before streaming started, or all buffers
  /// were full, so that the driver had to leave out newer ones. Fails with Disconnected when the
  /// device is gone, with Corrupt when the driver must be started again.
  Result<Taken> take_newest();
  void give_back(const RawFrame& frame);

  /// Waits for a frame or `timeout` of wall time, but only a moment when the driver has an error to
  /// tell.
  void wait(Time timeout);
  /// Stops and starts streaming; buffers come back empty. Fails with Disconnected.
  Result<void> restart();

  [[nodiscard]] const Mode& mode() const { return mode_; }

 private:
  struct Buffer {
    std::uint8_t* memory = nullptr;
    std::size_t length = 0;
  };

  void map_buffers();
  void unmap_buffers();
  int queue(std::uint32_t index);
  int start();
  int stop();
  [[nodiscard]] RawFrame frame_in(const struct v4l2_buffer& buffer, Time now) const;
  [[nodiscard]] bool is_stale(const RawFrame& frame, std::size_t taken, Time now) const;
  [[nodiscard]] Time interval() const;

  VideoHandle handle_;
  Mode mode_;
  std::vector<Buffer> buffers_;
  std::size_t queued_ = 0;  ///< Buffers that the driver has.
  Time started_{0};         ///< CLOCK_MONOTONIC.
};

}  // namespace eyebridge::camera
