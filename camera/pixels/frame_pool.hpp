#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// Frames whose memory is used again. New memory of a megabyte costs more than filling it: each of
/// its pages is cleared by the kernel, and then by the vector. Frames may outlive their pool, and
/// be let go in any thread; the rest is for one thread.
class FramePool {
 public:
  /// As make_frame(), but the bytes are those of some earlier frame: all must be written.
  [[nodiscard]] Frame make(int width, int height, PixelFormat format);
  /// `frame`, whose memory comes back here when nobody has it any more.
  [[nodiscard]] FramePtr share(Frame&& frame);

 private:
  class Store {
   public:
    /// Spare memory of `size` bytes; none when there is none.
    std::vector<std::uint8_t> take(std::size_t size);
    void give_back(std::vector<std::uint8_t>&& bytes);

   private:
    std::mutex mutex_;
    std::vector<std::vector<std::uint8_t>> spare_;
  };
  std::shared_ptr<Store> store_ = std::make_shared<Store>();
};

}  // namespace eyebridge::camera
