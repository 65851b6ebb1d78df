#include "loopback_writer.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace eyebridge::camera::testing {
namespace {

void must(bool worked, const char* what) {
  if (!worked) throw std::runtime_error(std::string(what) + ": " + std::strerror(errno));
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
  int type = V4L2_BUF_TYPE_VIDEO_OUTPUT;
  must(::ioctl(device_.get(), VIDIOC_STREAMON, &type) == 0, "STREAMON");
}

void LoopbackWriter::write(const std::vector<std::uint8_t>& frame) const {
  must(::write(device_.get(), frame.data(), frame.size()) == static_cast<ssize_t>(frame.size()),
       "write");
}

}  // namespace eyebridge::camera::testing
