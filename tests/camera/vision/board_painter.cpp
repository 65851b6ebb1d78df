#include "board_painter.hpp"

#include <algorithm>
#include <cmath>

#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/convert.hpp"
#include "optics/lens_distortion.hpp"

namespace eyebridge::camera::testing {
namespace {

constexpr int kSide = 2;  ///< Rays a pixel, squared.

double brightness(const Frame& page, double x, double y) {
  if (x < 0.0 || y < 0.0 || x >= page.width - 1.0 || y >= page.height - 1.0) return 200.0;
  const int left = static_cast<int>(x);
  const int top = static_cast<int>(y);
  const double u = x - left;
  const double v = y - top;
  const auto upper = page.row(top);
  const auto lower = page.row(top + 1);
  const auto at = static_cast<std::size_t>(left);
  return (1 - v) * ((1 - u) * upper[at] + u * upper[at + 1]) +
         v * ((1 - u) * lower[at] + u * lower[at + 1]);
}

}  // namespace

Frame look_at_page(const Frame& colour_page, double pixels_per_mm, const Calibration& lens,
                   const EyePose& eye) {
  const Frame page = to_grey8(colour_page);
  const SinCos h = sin_cos(eye.values[kHeading]);
  const SinCos p = sin_cos(eye.values[kPitch]);
  const SinCos r = sin_cos(eye.values[kRoll]);
  const Vec3 forward{h.cos * p.cos, h.sin * p.cos, p.sin};
  const Vec3 level_right{h.sin, -h.cos, 0.0};
  const Vec3 level_down{h.cos * p.sin, h.sin * p.sin, -p.cos};
  Frame frame = make_frame(lens.size.width, lens.size.height, PixelFormat::Grey8);
  std::size_t i = 0;
  for (int y = 0; y < lens.size.height; ++y) {
    for (int x = 0; x < lens.size.width; ++x) {
      double sum = 0.0;
      for (int ray = 0; ray < kSide * kSide; ++ray) {
        const int row = ray / kSide;
        const Vec2 pixel{x + (ray % kSide + 0.5) / kSide - 0.5, y + (row + 0.5) / kSide - 0.5};
        const Vec2 d = undistorted(lens, to_plane(lens, pixel));
        const double right = r.cos * d.x - r.sin * d.y;
        const double down = r.sin * d.x + r.cos * d.y;
        const Vec3 way{forward.x + right * level_right.x + down * level_down.x,
                       forward.y + right * level_right.y + down * level_down.y,
                       forward.z + right * level_right.z + down * level_down.z};
        const double t = -eye.values[kY] / way.y;
        if (!(t > 0.0)) {
          sum += 200.0;
          continue;
        }
        const double scale = m_to_mm(1.0) * pixels_per_mm;
        sum += brightness(page, 0.5 * page.width - 0.5 + scale * (eye.values[kX] + t * way.x),
                          0.5 * page.height - 0.5 - scale * (eye.values[kZ] + t * way.z));
      }
      frame.bytes[i++] = static_cast<std::uint8_t>(std::lround(sum / (kSide * kSide)));
    }
  }
  return frame;
}

}  // namespace eyebridge::camera::testing
