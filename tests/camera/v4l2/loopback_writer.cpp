#include "loopback_writer.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace eyebridge::camera::testing {
namespace {

void must(bool worked, const char* what) {
  if (!worked) throw std::runtime_error(std::string(what) + ": " + std::strerror(errno));
}

v4l2_buffer buffer_of(std::uint32_t index) {
  v4l2_buffer buffer{};
  buffer.type = V4L2_BUF_TYPE_VIDEO_OUTPUT;
  buffer.memory = V4L2_MEMORY_MMAP;
  buffer.index = index;
  return buffer;
}

}  // namespace

LoopbackWriter::LoopbackWriter(const std::string& path, std::uint32_t fourcc, int width, int height,
                               int fps)
    : device_(::open(path.c_str(), O_RDWR | O_CLOEXEC)) {
  must(device_.valid(), path.c_str());
  v4l2_format format{};
  format.type = V4L2_BUF_TYPE_VIDEO_OUTPUT;
  format.fmt.pix.width = static_cast<std::uint32_t>(width);
  format.fmt.pix.height = static_cast<std::uint32_t>(height);
  format.fmt.pix.pixelformat = fourcc;
  format.fmt.pix.field = V4L2_FIELD_NONE;
  format.fmt.pix.sizeimage = static_cast<std::uint32_t>(width * height * 3);
  must(::ioctl(device_.get(), VIDIOC_S_FMT, &format) == 0, "S_FMT");
  v4l2_streamparm rate{};
  rate.type = V4L2_BUF_TYPE_VIDEO_OUTPUT;
  rate.parm.output.timeperframe = {1, static_cast<std::uint32_t>(fps)};
  must(::ioctl(device_.get(), VIDIOC_S_PARM, &rate) == 0, "S_PARM");
  v4l2_requestbuffers wanted{};
  wanted.type = V4L2_BUF_TYPE_VIDEO_OUTPUT;
  wanted.memory = V4L2_MEMORY_MMAP;
  wanted.count = 8;
  must(::ioctl(device_.get(), VIDIOC_REQBUFS, &wanted) == 0, "REQBUFS");
  for (std::uint32_t i = 0; i < wanted.count; ++i) {
    v4l2_buffer buffer = buffer_of(i);
    must(::ioctl(device_.get(), VIDIOC_QUERYBUF, &buffer) == 0, "QUERYBUF");
    void* const place = ::mmap(nullptr, buffer.length, PROT_READ | PROT_WRITE, MAP_SHARED,
                               device_.get(), buffer.m.offset);
    must(place != MAP_FAILED, "mmap");
    buffers_.emplace_back(static_cast<std::uint8_t*>(place), buffer.length);
  }
  int type = V4L2_BUF_TYPE_VIDEO_OUTPUT;
  must(::ioctl(device_.get(), VIDIOC_STREAMON, &type) == 0, "STREAMON");
}

LoopbackWriter::~LoopbackWriter() {
  for (const auto& buffer : buffers_) ::munmap(buffer.data(), buffer.size());
}

void LoopbackWriter::write(const std::vector<std::uint8_t>& frame) {
  v4l2_buffer buffer = buffer_of(written_);
  if (written_ < buffers_.size()) {
    ++written_;
  } else {
    must(::ioctl(device_.get(), VIDIOC_DQBUF, &buffer) == 0, "DQBUF");
  }
  const auto place = buffers_.at(buffer.index);
  must(frame.size() <= place.size(), "a frame larger than its buffer");
  std::ranges::copy(frame, place.begin());
  buffer.bytesused = static_cast<std::uint32_t>(frame.size());
  buffer.flags = 0;
  buffer.timestamp = {};
  must(::ioctl(device_.get(), VIDIOC_QBUF, &buffer) == 0, "QBUF");
}

}  // namespace eyebridge::camera::testing
