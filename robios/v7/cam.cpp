#include <array>
#include <cstring>

#include <fmt/format.h>

#include "camera_port.hpp"
#include "eyebot.h"
#include "eyebridge/camera/convert.hpp"
#include "globals.hpp"
#include "guarded.hpp"

int CAMWIDTH = 0;
int CAMHEIGHT = 0;
int CAMPIXELS = 0;
int CAMSIZE = 0;
int CAMMODE = 0;
int CAM_INITIAL = 0;

namespace {

using namespace eyebridge;
using robios::Session;

struct Size {
  int width;
  int height;
};

constexpr std::array<Size, 6> kCameraModes = {{{QQVGA_X, QQVGA_Y},
                                               {QVGA_X, QVGA_Y},
                                               {VGA_X, VGA_Y},
                                               {CAM1MP_X, CAM1MP_Y},
                                               {CAMHD_X, CAMHD_Y},
                                               {CAM5MP_X, CAM5MP_Y}}};

void publish(int mode, Size size) {
  EYEBRIDGE_VARIABLE(CAMMODE) = mode;
  EYEBRIDGE_VARIABLE(CAMWIDTH) = size.width;
  EYEBRIDGE_VARIABLE(CAMHEIGHT) = size.height;
  EYEBRIDGE_VARIABLE(CAMPIXELS) = size.width * size.height;
  EYEBRIDGE_VARIABLE(CAMSIZE) = 3 * size.width * size.height;
  EYEBRIDGE_VARIABLE(CAM_INITIAL) = 1;
}

}  // namespace

int CAMInit(int resolution) {
  return robios::guarded("CAMInit", CAM_FAILURE, [&](Session& session) -> Result<int> {
    if (resolution < 0 || static_cast<std::size_t>(resolution) >= kCameraModes.size()) {
      return fail(
          Errc::OutOfRange,
          fmt::format("{} is no camera mode; expected QQVGA (0) to CAM5MP (5)", resolution));
    }
    const Size size = kCameraModes[static_cast<std::size_t>(resolution)];
    return session.camera().init(size.width, size.height).map([&] {
      publish(resolution, size);
      robios::set_ip_size({size.width, size.height});
      session.lcd().follow_camera(size.width, size.height);
      robios::publish_image_window(session.lcd().image_window(), resolution);
      return CAM_SUCCESS;
    });
  });
}

int CAMRelease(void) {
  return robios::guarded("CAMRelease", CAM_FAILURE, [](Session& session) -> Result<int> {
    session.camera().release();
    CAM_INITIAL = 0;
    return CAM_SUCCESS;
  });
}

int CAMGet(BYTE* buf) {
  return robios::guarded("CAMGet", CAM_FAILURE, [&](Session& session) -> Result<int> {
    if (buf == nullptr) return robios::null_pointer();
    return session.camera().next().map([&](const camera::FramePtr& frame) {
      for (int y = 0; y < frame->height; ++y) {
        const auto row = frame->row(y);
        std::memcpy(buf + static_cast<std::size_t>(y) * row.size(), row.data(), row.size());
      }
      return CAM_SUCCESS;
    });
  });
}

int CAMGetGray(BYTE* buf) {
  return robios::guarded("CAMGetGray", CAM_FAILURE, [&](Session& session) -> Result<int> {
    if (buf == nullptr) return robios::null_pointer();
    return session.camera().next().map([&](const camera::FramePtr& frame) {
      const camera::Frame grey = camera::to_grey8(*frame);
      for (int y = 0; y < grey.height; ++y) {
        const auto row = grey.row(y);
        std::memcpy(buf + static_cast<std::size_t>(y) * row.size(), row.data(), row.size());
      }
      return CAM_SUCCESS;
    });
  });
}
