#include "pixels/frame_pool.hpp"

#include <algorithm>
#include <utility>

namespace eyebridge::camera {
namespace {

// What a program, a recorder and a marker tracker have in their hands, and one that is made.
constexpr std::size_t kMostSpare = 4;

}  // namespace

Frame FramePool::make(int width, int height, PixelFormat format) {
  Frame frame;
  frame.width = width;
  frame.height = height;
  frame.format = format;
  frame.stride = width * bytes_per_pixel(format);
  frame.bytes =
      store_->take(static_cast<std::size_t>(frame.stride) * static_cast<std::size_t>(height));
  return frame;
}

FramePtr FramePool::share(Frame&& frame) {
  const auto back_to_store = [store = store_](Frame* old) {
    store->give_back(std::move(old->bytes));
    delete old;
  };
  return std::shared_ptr<Frame>(new Frame(std::move(frame)), back_to_store);
}

std::vector<std::uint8_t> FramePool::Store::take(std::size_t size) {
  {
    const std::lock_guard lock(mutex_);
    const auto found = std::ranges::find(spare_, size, &std::vector<std::uint8_t>::size);
    if (found != spare_.end()) {
      std::vector<std::uint8_t> bytes = std::move(*found);
      spare_.erase(found);
      return bytes;
    }
  }
  return std::vector<std::uint8_t>(size);
}

void FramePool::Store::give_back(std::vector<std::uint8_t>&& bytes) {
  const std::lock_guard lock(mutex_);
  // The oldest go first: after a change of size they are of no more use.
  if (spare_.size() == kMostSpare) spare_.erase(spare_.begin());
  spare_.push_back(std::move(bytes));
}

}  // namespace eyebridge::camera
