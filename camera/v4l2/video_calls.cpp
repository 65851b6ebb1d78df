#include "v4l2/video_calls.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <ctime>

#include <fcntl.h>
#include <libv4l2.h>
#include <linux/videodev2.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace eyebridge::camera {
namespace {

constexpr std::int64_t kNanoseconds = 1'000'000'000;

class SystemVideoCalls final : public VideoCalls {
 public:
  SystemVideoCalls() {
    // libv4l writes its own lines to standard error; what fails is told by our errors. Not to
    // /dev/null: it would note and flush every single call there.
    v4l2_log_file = ::fopencookie(nullptr, "w", {});
  }

  int open(const std::string& path, bool converting) override {
    const int file = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) return -errno;
    // The calls of files that it has not opened pass through to the kernel: at less cost where
    // nothing is converted, and with better errors where it refuses: what does not capture.
    v4l2_capability capability{};
    if (converting && ::ioctl(file, VIDIOC_QUERYCAP, &capability) == 0) {
      static_cast<void>(v4l2_fd_open(file, 0));
    }
    return file;
  }

  void close(int device) override { v4l2_close(device); }

  int control(int device, unsigned long request, void* argument) override {
    int result = 0;
    do {
      result = v4l2_ioctl(device, request, argument);
    } while (result < 0 && errno == EINTR);
    return result < 0 ? -errno : result;
  }

  std::uint8_t* map(int device, std::size_t length, std::int64_t offset) override {
    void* memory = v4l2_mmap(nullptr, length, PROT_READ | PROT_WRITE, MAP_SHARED, device, offset);
    return memory == MAP_FAILED ? nullptr : static_cast<std::uint8_t*>(memory);
  }

  void unmap(std::uint8_t* memory, std::size_t length) override { v4l2_munmap(memory, length); }

  int wait(int device, Time timeout) override {
    const std::int64_t wall = std::max<std::int64_t>(0, timeout.count());
    const timespec limit{wall / kNanoseconds, wall % kNanoseconds};
    pollfd file{device, POLLIN, 0};
    const int ready = ::ppoll(&file, 1, &limit, nullptr);
    if (ready < 0) return errno == EINTR ? 0 : -errno;
    if (ready == 0) return 0;
    return (file.revents & POLLIN) != 0 ? 1 : -EIO;
  }

  [[nodiscard]] Time monotonic() const override {
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    return Time(now.tv_sec * kNanoseconds + now.tv_nsec);
  }
};

}  // namespace

VideoCalls& system_video_calls() {
  static SystemVideoCalls calls;
  return calls;
}

}  // namespace eyebridge::camera
