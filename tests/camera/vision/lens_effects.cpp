#include "lens_effects.hpp"

#include <algorithm>
#include <cmath>

#include "optics/lens_distortion.hpp"

namespace eyebridge::camera::testing {
namespace {

/// Quarters of a pixel.
constexpr Vec2 kAside[4] = {{-1.5, -0.5}, {0.5, -1.5}, {-0.5, 1.5}, {1.5, 0.5}};

/// Gaussian blur of a picture, in place, rows then columns.
void blur(std::vector<float>& picture, int width, int height, double sigma) {
  if (sigma <= 0.0) return;
  const int reach = static_cast<int>(std::ceil(3.0 * sigma));
  std::vector<float> kernel;
  float sum = 0.0F;
  for (int i = -reach; i <= reach; ++i) {
    kernel.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma))));
    sum += kernel.back();
  }
  for (float& value : kernel) value /= sum;
  std::vector<float> out(picture.size());
  // A whole row or column at a time, so that the compiler can do several pixels at once.
  const auto pass = [&](int step_x, int step_y) {
    std::fill(out.begin(), out.end(), 0.0F);
    for (int i = -reach; i <= reach; ++i) {
      const float weight = kernel[static_cast<std::size_t>(i + reach)];
      for (int y = 0; y < height; ++y) {
        const int at_y = std::clamp(y + i * step_y, 0, height - 1);
        const float* from = &picture[static_cast<std::size_t>(at_y * width)];
        float* to = &out[static_cast<std::size_t>(y * width)];
        const int first = std::max(0, -i * step_x);
        const int last = std::min(width, width - i * step_x);
        for (int x = 0; x < first; ++x) to[x] += weight * from[0];
        for (int x = first; x < last; ++x) to[x] += weight * from[x + i * step_x];
        for (int x = last; x < width; ++x) to[x] += weight * from[width - 1];
      }
    }
    picture.swap(out);
  };
  pass(1, 0);
  pass(0, 1);
}

/// Bilinear.
float sample(const std::vector<float>& fine, const Size& size, Vec2 at) {
  const double x = std::clamp(at.x, 0.0, size.width - 2.001);
  const double y = std::clamp(at.y, 0.0, size.height - 2.001);
  const int left = static_cast<int>(x);
  const int top = static_cast<int>(y);
  const auto u = static_cast<float>(x - left);
  const auto v = static_cast<float>(y - top);
  const float* upper = &fine[static_cast<std::size_t>(top * size.width + left)];
  const float* lower = upper + size.width;
  return (1 - v) * ((1 - u) * upper[0] + u * upper[1]) + v * ((1 - u) * lower[0] + u * lower[1]);
}

}  // namespace

LensCamera::LensCamera(const WallPainter& painter, const Calibration& lens)
    : painter_(painter), lens_(lens), fine_(lens) {
  const bool straight = lens.distortion == std::array<double, 5>{};
  const double margin = straight ? 0.0 : 0.15;  // what a barrel squeezes in from outside
  fine_.distortion = {};
  const double scale = straight ? 1.0 : 1.25;
  fine_.fx *= scale;
  fine_.fy *= scale;
  fine_.size.width = static_cast<int>(scale * lens.size.width * (1.0 + 2.0 * margin));
  fine_.size.height = static_cast<int>(scale * lens.size.height * (1.0 + 2.0 * margin));
  fine_.cx = scale * (lens.cx + margin * lens.size.width);
  fine_.cy = scale * (lens.cy + margin * lens.size.height);
  for (int y = 0; y < lens.size.height; ++y) {
    for (int x = 0; x < lens.size.width; ++x) {
      const Vec2 pixel{static_cast<double>(x), static_cast<double>(y)};
      looks_.push_back(to_pixel(fine_, undistorted(lens, to_plane(lens, pixel))));
    }
  }
}

Frame LensCamera::take(const EyePose& from, const EyePose& to, const Effects& effects,
                       Random& random, const std::vector<char>& hidden) const {
  const Vector<6> way = difference(to, from);
  std::vector<float> fine;
  for (int i = 0; i < effects.exposures; ++i) {
    Vector<6> step = way;
    for (double& value : step) value *= (i + 0.5) / effects.exposures;
    // Each a part of a pixel off: their mean has smooth edges.
    Calibration aside = fine_;
    aside.cx += 0.25 * kAside[i % 4].x;
    aside.cy += 0.25 * kAside[i % 4].y;
    const auto picture = painter_.paint(moved(from, step), aside, hidden);
    if (fine.empty()) fine.resize(picture.size());
    for (std::size_t k = 0; k < fine.size(); ++k) {
      fine[k] += picture[k] / static_cast<float>(effects.exposures);
    }
  }
  const auto [width, height] = lens_.size;
  std::vector<float> picture(looks_.size());
  for (std::size_t i = 0; i < looks_.size(); ++i) picture[i] = sample(fine, fine_.size, looks_[i]);
  blur(picture, width, height, effects.blur);
  Frame frame;
  frame.width = frame.stride = width;
  frame.height = height;
  frame.format = PixelFormat::Grey8;
  frame.bytes.resize(picture.size());
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const double across = static_cast<double>(i % static_cast<std::size_t>(width)) / width - 0.5;
    const double light = effects.light * (1.0 + effects.gradient * across);
    const double value =
        static_cast<double>(picture[i]) * light + effects.noise * random.gaussian();
    frame.bytes[i] = static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
  }
  return frame;
}

}  // namespace eyebridge::camera::testing
