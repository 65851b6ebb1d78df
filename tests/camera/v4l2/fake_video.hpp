#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <linux/videodev2.h>

#include "eyebridge/base/clock.hpp"
#include "run_program.hpp"
#include "v4l2/video_calls.hpp"

namespace eyebridge::camera::testing {

using Bytes = std::vector<std::uint8_t>;

/// What a made-up camera can send.
struct FakeFormat {
  std::uint32_t fourcc = V4L2_PIX_FMT_YUYV;
  std::vector<std::pair<int, int>> sizes = {{640, 480}, {320, 240}};
  std::vector<double> rates = {30.0, 15.0};
};

struct FakeControl {
  std::string name;
  std::uint32_t type = V4L2_CTRL_TYPE_INTEGER;
  std::int64_t least = 0;
  std::int64_t most = 255;
  std::uint32_t flags = 0;
  std::vector<std::string> items = {};
  std::int64_t value = 0;
};

/// A made-up /dev/video*, with its faults.
struct FakeCamera {
  std::string card = "Webcam";
  std::uint32_t can = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
  std::vector<FakeFormat> formats = {FakeFormat{}};
  std::vector<FakeFormat> converted = {};  ///< What libv4l makes of them.
  std::vector<FakeControl> controls = {};
  std::function<Bytes(std::uint32_t sequence)> picture;  ///< Default: bytes of the sequence.
  double fps = 30.0;
  bool counts = true;                       ///< Sequence and time stamps are set.
  std::map<unsigned long, int> fails = {};  ///< Controls that fail, and with which errno.
  int open_fails = 0;
  bool is_gone = false;       ///< Unplugged.
  bool is_silent = false;     ///< Streams but sends nothing.
  int restarts_to_speak = 0;  ///< Silent until streaming was started so often.
  bool marks_damaged = false;

  // What has been done to it.
  std::vector<std::string> set_controls = {};  ///< "exposure=5", in order.
  int starts = 0;
  v4l2_format format = {};
};

/// Cameras that are made up, on a clock of their own: time passes only while somebody waits.
class FakeVideo final : public VideoCalls, public Clock {
 public:
  /// A camera with a node in the folder that counts as "/".
  FakeCamera& add(const std::string& name, FakeCamera camera = {});
  void link(const std::string& by_id, const std::string& name) const;
  void unlink(const std::string& by_id) const;
  /// Its device in /sys; nodes of the same device are siblings.
  void add_sys(const std::string& name, const std::string& device) const;
  [[nodiscard]] const std::string& root() const { return folder_.path(); }

  void pass(Time time);
  /// Opened and not closed; mapped and not unmapped.
  [[nodiscard]] int open_devices() const;
  [[nodiscard]] int mappings() const { return mappings_; }

  // VideoCalls
  int open(const std::string& path, bool converting) override;
  void close(int device) override;
  int control(int device, unsigned long request, void* argument) override;
  std::uint8_t* map(int device, std::size_t length, std::int64_t offset) override;
  void unmap(std::uint8_t* memory, std::size_t length) override;
  int wait(int device, Time timeout) override;
  [[nodiscard]] Time monotonic() const override { return now_ + kAhead; }
  // Clock
  [[nodiscard]] Time now() const override { return now_; }
  [[nodiscard]] Time at(Time moment) const override { return moment - kAhead; }
  void wait_until(Time deadline) override { pass(deadline - now_); }
  void spend(Time) override {}
  [[nodiscard]] bool is_virtual() const override { return false; }

 private:
  static constexpr Time kAhead{7'000'000'000};

  struct Open {
    FakeCamera* camera = nullptr;
    bool converting = false;
    bool streaming = false;
    Time next{0};
    std::uint32_t sequence = 0;
    std::vector<Bytes> memory;
    std::deque<std::uint32_t> queued;
    std::deque<v4l2_buffer> done;
  };

  [[nodiscard]] static const std::vector<FakeFormat>& formats(const Open& open) {
    return open.converting ? open.camera->converted : open.camera->formats;
  }
  int answer(Open& open, unsigned long request, void* argument);
  int describe(Open& open, unsigned long request, void* argument);
  int stream(Open& open, unsigned long request, void* argument);
  void shoot(Open& open, Time at) const;

  eyebridge::testing::ScratchFolder folder_;
  std::map<std::string, FakeCamera> cameras_;
  std::map<int, Open> open_;
  int last_ = 10;
  int mappings_ = 0;
  Time now_{1'000'000'000};
};

}  // namespace eyebridge::camera::testing
