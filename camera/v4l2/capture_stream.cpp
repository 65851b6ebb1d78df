#include "v4l2/capture_stream.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <linux/videodev2.h>

#include "v4l2/open_errors.hpp"

namespace eyebridge::camera {
namespace {

// Two for the driver to fill in turn, one that is read, one for a program that is late.
constexpr std::uint32_t kBuffers = 4;
constexpr std::uint32_t kFewestBuffers = 2;
constexpr std::int64_t kMicrosecond = 1000;

v4l2_buffer capture_buffer(std::uint32_t index = 0) {
  v4l2_buffer buffer{};
  buffer.index = index;
  buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  buffer.memory = V4L2_MEMORY_MMAP;
  return buffer;
}

bool is_gone(int number) { return number == ENODEV || number == ENXIO || number == EBADF; }

}  // namespace

CaptureStream::CaptureStream(VideoHandle handle, Mode mode)
    : handle_(std::move(handle)), mode_(mode) {
  try {
    map_buffers();
    if (const int result = start(); result < 0) {
      throw call_error(handle_.path(), "starting to stream", -result);
    }
  } catch (...) {
    unmap_buffers();
    throw;
  }
}

CaptureStream::~CaptureStream() {
  stop();
  unmap_buffers();
}

void CaptureStream::map_buffers() {
  v4l2_requestbuffers request{};
  request.count = kBuffers;
  request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  request.memory = V4L2_MEMORY_MMAP;
  if (const int result = handle_.control(VIDIOC_REQBUFS, request); result < 0) {
    throw call_error(handle_.path(), "asking for buffers", -result);
  }
  if (request.count < kFewestBuffers) {
    throw camera_error(handle_.path(),
                       "it has " + std::to_string(request.count) + " buffers, expected at least 2");
  }
  for (std::uint32_t index = 0; index < request.count; ++index) {
    v4l2_buffer buffer = capture_buffer(index);
    if (const int result = handle_.control(VIDIOC_QUERYBUF, buffer); result < 0) {
      throw call_error(handle_.path(), "asking for a buffer", -result);
    }
    std::uint8_t* memory = handle_.calls().map(handle_.device(), buffer.length, buffer.m.offset);
    if (memory == nullptr) throw call_error(handle_.path(), "mapping a buffer", errno);
    buffers_.push_back({memory, buffer.length});
  }
}

void CaptureStream::unmap_buffers() {
  for (const Buffer& buffer : buffers_) handle_.calls().unmap(buffer.memory, buffer.length);
  buffers_.clear();
}

int CaptureStream::queue(std::uint32_t index) {
  v4l2_buffer buffer = capture_buffer(index);
  const int result = handle_.control(VIDIOC_QBUF, buffer);
  if (result >= 0) ++queued_;
  return result;
}

int CaptureStream::start() {
  queued_ = 0;
  for (std::uint32_t index = 0; index < buffers_.size(); ++index) {
    if (const int result = queue(index); result < 0) return result;
  }
  started_ = handle_.calls().monotonic();
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  if (const int result = handle_.control(VIDIOC_STREAMON, type); result < 0) return result;
  // What is there already was taken before: v4l2loopback has such, and does not stamp it.
  for (std::size_t i = 0; i < buffers_.size(); ++i) {
    v4l2_buffer old = capture_buffer();
    if (handle_.control(VIDIOC_DQBUF, old) < 0) break;
    --queued_;
    static_cast<void>(queue(old.index));
  }
  return 0;
}

int CaptureStream::stop() {
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  queued_ = 0;
  return handle_.control(VIDIOC_STREAMOFF, type);
}

Result<void> CaptureStream::restart() {
  int result = stop();
  if (result >= 0) result = start();
  if (result >= 0) return {};
  return fail(is_gone(-result) ? Errc::Disconnected : Errc::Corrupt,
              std::string("streaming cannot be started again: ") + std::strerror(-result));
}

void CaptureStream::wait(Time timeout) {
  constexpr Time kMoment = std::chrono::milliseconds(1);
  VideoCalls& calls = handle_.calls();
  if (calls.wait(handle_.device(), timeout) < 0) calls.wait(-1, std::min(timeout, kMoment));
}

void CaptureStream::give_back(const RawFrame& frame) {
  // When this fails, so does the next take_newest(), which can tell.
  static_cast<void>(queue(frame.buffer));
}

Result<Taken> CaptureStream::take_newest() {
  std::optional<RawFrame> newest;
  const std::size_t had = queued_;
  std::size_t taken = 0;
  Time now{0};
  int result = 0;
  // Never more than there were: a fast camera must not hold us here.
  while (taken < had) {
    v4l2_buffer buffer = capture_buffer();
    result = handle_.control(VIDIOC_DQBUF, buffer);
    if (result < 0) break;
    --queued_;
    ++taken;
    if (newest) give_back(*newest);
    newest.reset();
    now = handle_.calls().monotonic();
    if (buffer.index < buffers_.size()) newest = frame_in(buffer, now);
    // Nothing newer can be there yet: a call saved for each frame.
    if (newest && newest->is_stamped && now - newest->taken < interval() / 2) break;
  }
  if (result < 0 && result != -EAGAIN) {
    if (newest) give_back(*newest);
    return fail(is_gone(-result) ? Errc::Disconnected : Errc::Corrupt,
                std::string("taking a frame failed: ") + std::strerror(-result));
  }
  if (had == 0) return fail(Errc::Corrupt, "the driver has no buffer left");
  if (newest && is_stale(*newest, taken, now)) {
    give_back(*newest);
    newest.reset();
  }
  return Taken{newest, taken > 0, now};
}

RawFrame CaptureStream::frame_in(const v4l2_buffer& buffer, Time now) const {
  const Buffer& memory = buffers_[buffer.index];
  RawFrame frame;
  frame.buffer = buffer.index;
  frame.bytes = {memory.memory, std::min<std::size_t>(buffer.bytesused, memory.length)};
  frame.sequence = buffer.sequence;
  frame.is_damaged = (buffer.flags & V4L2_BUF_FLAG_ERROR) != 0;
  frame.is_stamped =
      (buffer.flags & V4L2_BUF_FLAG_TIMESTAMP_MASK) == V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC;
  const Time stamp =
      std::chrono::seconds(buffer.timestamp.tv_sec) + Time(buffer.timestamp.tv_usec * kMicrosecond);
  frame.taken = frame.is_stamped ? std::min(stamp, now) : now;
  return frame;
}

Time CaptureStream::interval() const {
  constexpr Time kUsual = std::chrono::milliseconds(33);
  return mode_.fps > 0.0 ? from_seconds(1.0 / mode_.fps) : kUsual;
}

bool CaptureStream::is_stale(const RawFrame& frame, std::size_t taken, Time now) const {
  // Time stamps are in whole microseconds.
  if (frame.taken + Time(kMicrosecond) < started_) return true;
  if (taken < buffers_.size()) return false;
  return !frame.is_stamped || now - frame.taken > interval();
}

}  // namespace eyebridge::camera
