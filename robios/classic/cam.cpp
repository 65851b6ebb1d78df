#include <algorithm>
#include <cstdarg>
#include <cstring>
#include <limits>
#include <mutex>

#include <fmt/format.h>

#include "call.hpp"
#include "camera_port.hpp"
#include "eyebot.h"
#include "eyebridge/camera/convert.hpp"

namespace {

using namespace eyebridge;
using robios::Session;
using robios::classic::call;
using robios::classic::doing;

// EyeCam-1: the camera whose full resolution is that of an image, so that programs of all later
// ones find room in their buffers, too.
constexpr int kVersion = 17;
constexpr CAMHandle kHandle = 1;

/// How often the camera gives a frame.
struct Pace {
  std::mutex mutex;
  int frame_rate = FPS7_5;
  Time next_frame{0};
};

/// 1/60 s, twice that …
Time frame_period(int rate) {
  return std::chrono::duration_cast<Time>(std::chrono::duration<double>((1 << rate) / 60.0));
}

bool is_name(long mode) {
  return mode < std::numeric_limits<int>::min() || mode > std::numeric_limits<int>::max();
}

/// Waits until the camera's rate allows another frame, and gets the newest one then.
Result<camera::FramePtr> next_at_rate(Session& session) {
  if (!session.camera().is_open()) {
    return fail(Errc::Unsupported, "the camera is not initialised: call CAMInit first");
  }
  Time due{0};
  {
    auto& pace = session.own<Pace>();
    const std::lock_guard lock(pace.mutex);
    due = std::max(pace.next_frame, session.clock().now());
    pace.next_frame = due + frame_period(pace.frame_rate);
  }
  if (due > session.clock().now()) robios::classic::wait_until(due);
  return session.camera().next();
}

Result<void> copy(const Result<camera::FramePtr>& frame, bool grey, void* out) {
  if (!frame) return tl::unexpected(frame.error());
  const camera::Frame picture = grey ? camera::to_grey8(**frame) : **frame;
  auto* to = static_cast<std::uint8_t*>(out);
  for (int y = 0; y < picture.height; ++y) {
    const auto row = picture.row(y);
    std::memcpy(to, row.data(), row.size());
    to += row.size();
  }
  return {};
}

int get_frame(const robios::Call& name, bool grey, void* out) {
  return doing(name, 1, [&](Session& session) -> Result<void> {
    if (out == nullptr) return robios::null_pointer();
    return copy(next_at_rate(session), grey, out);
  });
}

}  // namespace

int CAMInit(long mode) {
  const int good = is_name(mode) ? kHandle : kVersion;
  const int none = is_name(mode) ? 0 : NOCAM;
  return call("CAMInit", none, [&](Session& session) -> Result<int> {
    return session.camera().init(imagecolumns, imagerows).map([&] {
      auto& pace = session.own<Pace>();
      const std::lock_guard lock(pace.mutex);
      pace.frame_rate = FPS7_5;
      pace.next_frame = session.clock().now();
      return good;
    });
  });
}

int CAMRelease() {
  return doing("CAMRelease", -1, [](Session& session) -> Result<void> {
    if (!session.camera().is_open()) {
      return fail(Errc::Unsupported, "the camera is not initialised: call CAMInit first");
    }
    session.camera().release();
    return {};
  });
}

int CAMGetFrame(image* buf) { return get_frame("CAMGetFrame", true, buf); }

int CAMGetColFrame(colimage* buf, int convert) {
  return get_frame("CAMGetColFrame", convert != 0, buf);
}

int CAMGetFrameMono(BYTE* buf) { return get_frame("CAMGetFrameMono", true, buf); }

int CAMGetFrameRGB(void* buf, ...) {
  void* out = buf;
  // The M6 gives a handle first.
  // NOLINTNEXTLINE(performance-no-int-to-ptr)
  if (buf == reinterpret_cast<void*>(std::intptr_t{kHandle})) {
    va_list arguments;
    va_start(arguments, buf);
    out = va_arg(arguments, void*);
    va_end(arguments);
  }
  return get_frame("CAMGetFrameRGB", false, out);
}

int CAMGetFrameBayer(BYTE* buf) {
  return doing("CAMGetFrameBayer", 1, [&](Session& session) -> Result<void> {
    if (buf == nullptr) return robios::null_pointer();
    return next_at_rate(session).map([&](const camera::FramePtr& frame) {
      std::size_t i = 0;
      for (int y = 0; y < frame->height; ++y) {
        const auto row = frame->row(y);
        for (int x = 0; x < frame->width; ++x) {
          // Red and green in even rows, green and blue in odd ones.
          const int channel = (y & 1) + (x & 1);
          buf[i++] = row[static_cast<std::size_t>(3 * x + channel)];
        }
      }
    });
  });
}

int CAMSet(int p1, int, int) {
  return doing("CAMSet", 1, [&](Session& session) -> Result<void> {
    if (p1 < FPS15 || p1 > FPS0_46875) {
      return fail(Errc::OutOfRange, fmt::format("frame rate {}, expected FPS15 ({}) to FPS0_46875 "
                                                "({})",
                                                p1, FPS15, FPS0_46875));
    }
    auto& pace = session.own<Pace>();
    const std::lock_guard lock(pace.mutex);
    pace.frame_rate = p1;
    return {};
  });
}

int CAMGet(int* p1, int* p2, int* p3) {
  return doing("CAMGet", 1, [&](Session& session) -> Result<void> {
    auto& pace = session.own<Pace>();
    const std::lock_guard lock(pace.mutex);
    if (p1 != nullptr) *p1 = pace.frame_rate;
    if (p2 != nullptr) *p2 = imagecolumns;
    if (p3 != nullptr) *p3 = imagerows;
    return {};
  });
}

int CAMMode(int mode) {
  return doing("CAMMode", 1, [&](Session&) -> Result<void> {
    if (mode == AUTOBRIGHTNESS || mode == NOAUTOBRIGHTNESS) return {};
    return fail(Errc::OutOfRange, fmt::format("camera mode {}", mode));
  });
}
