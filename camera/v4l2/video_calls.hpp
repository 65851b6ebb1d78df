#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::camera {

/// All that live cameras ask of the system: tests answer with cameras of their own, and faults.
///
/// Results are the kernel's: 0 or more, or -errno. Any thread, one at a time for a device.
class VideoCalls {
 public:
  virtual ~VideoCalls() = default;

  /// Opens the device `path` for reading and writing, never to block. With `converting`, libv4l
  /// offers RGB24 made of whatever the device gives; without, the device is seen as it is. The
  /// number of the device, lent until close().
  virtual int open(const std::string& path, bool converting) = 0;
  virtual void close(int device) = 0;
  /// ioctl(); what a signal interrupted is tried again.
  virtual int control(int device, unsigned long request, void* argument) = 0;
  /// The memory of a buffer; null when that fails.
  virtual std::uint8_t* map(int device, std::size_t length, std::int64_t offset) = 0;
  virtual void unmap(std::uint8_t* memory, std::size_t length) = 0;
  /// Waits until a frame may be taken (1), or for `timeout` of wall time (0); -EIO when the device
  /// has an error to tell at the next control(). `device` -1: only waits.
  virtual int wait(int device, Time timeout) = 0;
  /// CLOCK_MONOTONIC, by which the kernel stamps frames.
  [[nodiscard]] virtual Time monotonic() const = 0;
};

/// The calls of this machine, through libv4l2.
VideoCalls& system_video_calls();

}  // namespace eyebridge::camera
