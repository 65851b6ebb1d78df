#include "wall_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eyebridge::camera::testing {
namespace {

Vec3 cross_product(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The camera's axes in the world.
struct Axes {
  Vec3 right, down, forward;

  explicit Axes(const EyePose& eye) {
    const auto [hs, hc] = sin_cos(eye.values[kHeading]);
    const auto [ps, pc] = sin_cos(eye.values[kPitch]);
    const auto [rs, rc] = sin_cos(eye.values[kRoll]);
    forward = {hc * pc, hs * pc, ps};
    const Vec3 r{hs, -hc, 0.0};
    const Vec3 d{hc * ps, hs * ps, -pc};
    right = {rc * r.x + rs * d.x, rc * r.y + rs * d.y, rs * d.z};
    down = {rc * d.x - rs * r.x, rc * d.y - rs * r.y, rc * d.z};
  }
  [[nodiscard]] Vec3 in_camera(Vec3 v) const {
    return {dot(right, v), dot(down, v), dot(forward, v)};
  }
};

/// Pixels from the first to the last.
struct Reach {
  int left, right, top, bottom;
};

/// Where a panel can be seen at all: the box about what of it lies in front of the camera.
Reach reach_of(Vec3 o, Vec3 a, Vec3 b, const Calibration& lens) {
  constexpr double kNear = 0.01;
  const auto plus = [](Vec3 p, Vec3 q) { return Vec3{p.x + q.x, p.y + q.y, p.z + q.z}; };
  const Vec3 corners[4] = {o, plus(o, a), plus(plus(o, a), b), plus(o, b)};
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
  const auto add = [&](Vec3 c) {
    const double u = lens.cx + lens.fx * c.x / c.z;
    const double v = lens.cy + lens.fy * c.y / c.z;
    left = std::min(left, u), right = std::max(right, u);
    top = std::min(top, v), bottom = std::max(bottom, v);
  };
  for (int i = 0; i < 4; ++i) {
    const Vec3 p = corners[i];
    const Vec3 q = corners[(i + 1) % 4];
    if (p.z >= kNear) add(p);
    if ((p.z < kNear) == (q.z < kNear)) continue;
    const double part = (kNear - p.z) / (q.z - p.z);
    add({p.x + part * (q.x - p.x), p.y + part * (q.y - p.y), kNear});
  }
  const auto within = [](double value, double most) { return std::clamp(value, -1.0, most); };
  return {static_cast<int>(std::ceil(std::max(within(left, 1e5), 0.0))),
          static_cast<int>(std::floor(within(right, lens.size.width - 1.0))),
          static_cast<int>(std::ceil(std::max(within(top, 1e5), 0.0))),
          static_cast<int>(std::floor(within(bottom, lens.size.height - 1.0)))};
}

}  // namespace

WallPainter::WallPainter(const world::WorldModel& model, const std::vector<Fiducial>& fiducials) {
  for (const world::Wall& wall : model.walls) {
    const Vec2 along = wall.b - wall.a;
    const Vec2 half = (0.5 * wall.thickness / norm(along)) * Vec2{-along.y, along.x};
    for (const double side : {1.0, -1.0}) {
      const Vec2 from = wall.a + side * half;
      panels_.push_back({{from.x, from.y, 0.0}, {along.x, along.y, 0.0}, {0.0, 0.0, wall.height}});
      if (wall.thickness == 0.0) break;
    }
  }
  if (!fiducials.empty()) cells_ = cells_of(fiducials.front().family);
  for (std::size_t i = 0; i < fiducials.size(); ++i) {
    const Fiducial& f = fiducials[i];
    bits_.push_back(fiducial_bits(f.family, f.id));
    const Vec2 normal = Heading::from_angle(f.facing).forward();
    const double edge = with_margin(f);
    // A hair off the wall; as one faces it, across is to the right, and v goes down from the top.
    const Vec2 across = edge * Vec2{-normal.y, normal.x};
    const Vec2 left = f.centre + 1e-5 * normal - 0.5 * across;
    panels_.push_back({{left.x, left.y, f.z + 0.5 * edge},
                       {across.x, across.y, 0.0},
                       {0.0, 0.0, -edge},
                       static_cast<int>(i)});
  }
}

std::vector<float> WallPainter::paint(const EyePose& eye, const Calibration& lens,
                                      const std::vector<char>& hidden) const {
  const int width = lens.size.width;
  const int height = lens.size.height;
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<float> picture(pixels, static_cast<float>(kFloor));
  std::vector<float> nearness(pixels, 0.0F);  // 1 / distance along the axis
  const Axes axes(eye);
  for (const Panel& panel : panels_) {
    const bool is_wall = panel.fiducial < 0;
    if (!is_wall && !hidden.empty() && hidden[static_cast<std::size_t>(panel.fiducial)] != 0)
      continue;
    const Vec3 at = eye.position();
    const Vec3 o =
        axes.in_camera({panel.origin.x - at.x, panel.origin.y - at.y, panel.origin.z - at.z});
    const Vec3 a = axes.in_camera(panel.across);
    const Vec3 b = axes.in_camera(panel.up);
    const Vec3 normal = cross_product(a, b);
    // Paper has a front: it is seen where up x across points to the camera.
    if (!is_wall && dot(normal, o) <= 0.0) continue;
    // For the ray d = (x, y, 1): t d = o + u a + v b (Cramer's rule; all linear in d).
    const Vec3 for_u = cross_product(o, b);
    const Vec3 for_v = cross_product(a, o);
    const double volume = dot(normal, o);
    const Reach reach = reach_of(o, a, b, lens);
    const FiducialBits* bits = is_wall ? nullptr : &bits_[static_cast<std::size_t>(panel.fiducial)];
    for (int row = reach.top; row <= reach.bottom; ++row) {
      const double y = (row - lens.cy) / lens.fy;
      for (int column = reach.left; column <= reach.right; ++column) {
        const double x = (column - lens.cx) / lens.fx;
        const double slope = normal.x * x + normal.y * y + normal.z;
        const double near = slope / volume;
        const auto pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                           static_cast<std::size_t>(column);
        if (!(near > 1e-3) || near < static_cast<double>(nearness[pixel])) continue;
        // t d = o + u a + v b  gives  u = -(d . (o x b)) / (d . (a x b)) and v likewise.
        const double u = -(for_u.x * x + for_u.y * y + for_u.z) / slope;
        const double v = -(for_v.x * x + for_v.y * y + for_v.z) / slope;
        if (u < 0.0 || u > 1.0 || v < 0.0 || v > 1.0) continue;
        nearness[pixel] = static_cast<float>(near);
        double value = kWall;
        if (bits != nullptr) {
          const int cell_x = std::min(static_cast<int>(u * (cells_ + 2)), cells_ + 1) - 1;
          const int cell_y = std::min(static_cast<int>(v * (cells_ + 2)), cells_ + 1) - 1;
          const bool margin = cell_x < 0 || cell_y < 0 || cell_x >= cells_ || cell_y >= cells_;
          const bool white =
              margin || (*bits)[static_cast<std::size_t>(cell_y * cells_ + cell_x)] != 0;
          value = white ? kPaper : kInk;
        }
        picture[pixel] = static_cast<float>(value);
      }
    }
  }
  return picture;
}

}  // namespace eyebridge::camera::testing
