#include "eyebridge/camera/shared_source.hpp"

#include <algorithm>
#include <utility>

#include <pthread.h>

#include "eyebridge/camera/convert.hpp"
#include "sources/frame_schedule.hpp"

namespace eyebridge::camera {
namespace {

// How long the thread waits for one frame: whoever waits for the program's deadline, or for the
// thread's end, waits this much longer at most.
constexpr Time kLook = std::chrono::milliseconds(100);

}  // namespace

SharedSource::SharedSource(std::unique_ptr<Source> inner, Clock& clock, FrameWatcher& watcher)
    : clock_(clock), watcher_(watcher), inner_(std::move(inner)), natural_(inner_->natural_size()) {
  if (clock_.is_virtual()) return;
  thread_ = std::thread([this] { run(); });
  // By this name robios knows that it is none of the program's own threads.
  pthread_setname_np(thread_.native_handle(), "eb:camera");
}

SharedSource::~SharedSource() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  if (thread_.joinable()) thread_.join();
}

void SharedSource::run() {
  for (;;) {
    {
      const std::lock_guard lock(mutex_);
      if (ending_) return;
    }
    const Time deadline = clock_.now() + kLook;
    // A camera that is gone may say so at once: not a reason to ask it a million times a second.
    if (!take(deadline)) clock_.wait_until(deadline);
  }
}

bool SharedSource::take(Time deadline) {
  const Result<FramePtr> frame = inner_->next(deadline);
  if (frame) {
    watcher_.frame(*frame);
  } else {
    watcher_.no_frame(frame.error());
  }
  {
    const std::lock_guard lock(mutex_);
    if (frame) newest_ = *frame;
    trouble_ = frame ? std::nullopt : std::optional(frame.error());
  }
  news_.notify_all();
  return frame.has_value();
}

void SharedSource::pull(Time deadline) {
  const std::lock_guard lock(pulling_);
  while (clock_.now() < deadline) {
    const Time look = std::min(deadline, clock_.now() + kLook);
    if (!take(deadline)) clock_.wait_until(look);  // a camera that is gone does not wait itself
  }
}

Result<void> SharedSource::set_size(int width, int height) {
  return FrameSchedule::check_size(width, height).map([&] {
    const std::lock_guard lock(mutex_);
    size_ = {width, height};
  });
}

Size SharedSource::natural_size() const { return natural_; }

bool SharedSource::is_answered(Time deadline) const {
  const std::lock_guard lock(mutex_);
  return answered(deadline);
}

bool SharedSource::answered(Time deadline) const {
  if (newest_) return true;
  return trouble_ && (trouble_->code != Errc::Timeout || clock_.now() >= deadline);
}

Result<FramePtr> SharedSource::next(Time deadline) {
  if (clock_.is_virtual()) {
    const std::lock_guard lock(pulling_);
    while (!is_answered(deadline)) take(deadline);
  }
  std::unique_lock lock(mutex_);
  // On other clocks the thread has something to say ten times a second at least.
  news_.wait(lock, [&] { return answered(deadline); });
  if (!newest_) return tl::unexpected(*trouble_);
  const FramePtr frame = std::exchange(newest_, nullptr);
  if (!first_) first_ = frame->sequence;
  const std::uint64_t first = *first_;
  const Size size = size_.value_or(Size{frame->width, frame->height});
  lock.unlock();
  if (first == 0 && size == Size{frame->width, frame->height}) return frame;
  Frame own = fit(*frame, size.width, size.height);
  own.sequence -= first;
  return std::make_shared<const Frame>(std::move(own));
}

}  // namespace eyebridge::camera
