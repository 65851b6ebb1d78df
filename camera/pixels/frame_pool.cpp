#include "pixels/frame_pool.hpp"

#include <algorithm>
#include <utility>

#include "eyebridge/camera/convert.hpp"

namespace eyebridge::camera {
namespace {

// What a program, a recorder and a marker tracker have in their hands, and one that is made.
constexpr std::size_t kMostSpare = 4;

}  // namespace

Frame FramePool::make(int width, int height, PixelFormat format) {
  const auto row = static_cast<std::size_t>(width * bytes_per_pixel(format));
  return make_frame(width, height, format, store_->take(row * static_cast<std::size_t>(height)));
}

FramePtr FramePool::share(Frame&& frame) {
  const auto back_to_store = [store = store_](Frame* old) {
    store->give_back(std::move(old->bytes));
    delete old;
  };
  return std::shared_ptr<Frame>(new Frame(std::move(frame)), back_to_store);
}

std::vector<std::uint8_t> FramePool::Store::take(std::size_t size) {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find(spare_, size, &std::vector<std::uint8_t>::size);
  if (found == spare_.end()) return {};
  std::vector<std::uint8_t> bytes = std::move(*found);
  spare_.erase(found);
  return bytes;
}

void FramePool::Store::give_back(std::vector<std::uint8_t>&& bytes) {
  const std::lock_guard lock(mutex_);
  // The oldest go first: after a change of size they are of no more use.
  if (spare_.size() == kMostSpare) spare_.erase(spare_.begin());
  spare_.push_back(std::move(bytes));
}

}  // namespace eyebridge::camera
