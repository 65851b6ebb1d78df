#include "render/visible_walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/mesh.hpp"

namespace eyebridge::camera {
namespace {

Vec2 nearest_point(const world::Wall& wall, Vec2 from) {
  const Vec2 along = wall.b - wall.a;
  const double t = std::clamp(dot(from - wall.a, along) / norm_squared(along), 0.0, 1.0);
  return wall.a + t * along;
}

constexpr double kOpen = std::numeric_limits<double>::infinity();

}  // namespace

void Horizon::clear(double reach) {
  reach_ = reach;
  depth_.fill(kOpen);
}

void Horizon::close(Vec2 a, Vec2 b) {
  if (a.x <= Lens::kNear || b.x <= Lens::kNear) return;
  double u = a.y / a.x;
  double v = b.y / b.x;
  double w = 1.0 / a.x;
  double z = 1.0 / b.x;
  if (u > v) {
    std::swap(u, v);
    std::swap(w, z);
  }
  const double scale = 0.5 * kSectors / reach_;
  // Sectors that lie wholly within, a hair less.
  const double first = std::max(0.0, std::ceil((u + reach_) * scale + 1e-6));
  const double last = std::min(double{kSectors}, std::floor((v + reach_) * scale - 1e-6));
  if (first >= last) return;
  const double slope = (z - w) / (v - u);
  const auto depth_at = [&](int edge) { return 1.0 / (w + slope * (edge / scale - reach_ - u)); };
  double before = depth_at(static_cast<int>(first));
  for (int i = static_cast<int>(first); i < static_cast<int>(last); ++i) {
    const double after = depth_at(i + 1);
    double& depth = depth_[static_cast<std::size_t>(i)];
    depth = std::min(depth, std::max(before, after));
    before = after;
  }
}

bool Horizon::hides(std::span<const Vec2> corners) const {
  double nearest = kOpen;
  double u = kOpen;
  double v = -kOpen;
  for (const Vec2 corner : corners) {
    if (corner.x <= Lens::kNear) return false;
    nearest = std::min(nearest, corner.x);
    u = std::min(u, corner.y / corner.x);
    v = std::max(v, corner.y / corner.x);
  }
  const double scale = 0.5 * kSectors / reach_;
  const int first = static_cast<int>(std::max(0.0, std::floor((u + reach_) * scale - 1e-6)));
  const int last =
      static_cast<int>(std::min(double{kSectors}, std::ceil((v + reach_) * scale + 1e-6)));
  for (int i = first; i < last; ++i) {
    if (depth_[static_cast<std::size_t>(i)] >= nearest - 1e-6) return false;
  }
  return true;
}

VisibleWalls::VisibleWalls(const std::vector<world::Wall>& walls) {
  std::uint32_t quad = 0;
  for (const world::Wall& wall : walls) {
    entries_.push_back({wall, quad});
    quad += static_cast<std::uint32_t>(quads_of(wall));
    tallest_ = std::max(tallest_, wall.height);
  }
}

bool VisibleWalls::in_frustum(const world::Wall& wall, const Lens& lens) const {
  // A corner of the outline lies at most this far from an end of the middle line.
  const double margin = wall.thickness;
  for (const Plane& plane : lens.frustum()) {
    const double top = std::max(0.0, plane.normal.z * wall.height);
    if (plane.distance({wall.a.x, wall.a.y, 0.0}) + top < -margin &&
        plane.distance({wall.b.x, wall.b.y, 0.0}) + top < -margin) {
      return false;
    }
  }
  return true;
}

void VisibleWalls::add_quads(const Entry& entry, const Lens& lens,
                             std::vector<std::uint32_t>& indices) const {
  const auto add = [&](std::uint32_t quad) {
    const std::uint32_t first = 4 * (entry.first_quad + quad);
    for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) indices.push_back(first + i);
  };
  const world::Wall& wall = entry.wall;
  if (wall.thickness <= 0.0) {
    add(0);
    return;
  }
  // Only faces whose outside looks at the eye; an eye within the wall sees none of them.
  const Vec2 eye{lens.eye().x, lens.eye().y};
  const Vec2 along = wall.b - wall.a;
  const double length = norm(along);
  const double beside = cross(along, eye - wall.a) / length;
  const double ahead = dot(along, eye - wall.a) / length;
  if (beside > 0.5 * wall.thickness) add(0);
  if (beside < -0.5 * wall.thickness) add(1);
  if (ahead > length) add(2);
  if (ahead < 0.0) add(3);
  if (lens.eye().z > wall.height) add(4);
}

void VisibleWalls::drop_hidden(const Lens& lens) {
  const Eye& eye = lens.eye();
  // Tangents of the bearings in view: the frustum's corners, seen from above. A camera that looks
  // steeply sees more bearings than a plane before it can hold.
  const SinCos pitch = sin_cos(eye.pitch);
  const double shallowest = pitch.cos - lens.half_height() * std::abs(pitch.sin);
  if (eye.z >= tallest_ || shallowest < 0.3) return;
  horizon_.clear(1.001 * lens.half_width() / shallowest);

  const SinCos heading = sin_cos(eye.heading);
  const Heading back{heading.cos, -heading.sin};
  std::size_t kept = 0;
  for (const Candidate& candidate : candidates_) {
    const world::Wall& wall = entries_[candidate.index].wall;
    const Vec2 a = back.rotate(wall.a - Vec2{eye.x, eye.y});
    const Vec2 b = back.rotate(wall.b - Vec2{eye.x, eye.y});
    const Vec2 along = b - a;
    const Vec2 half = (0.5 * wall.thickness / norm(along)) * Vec2{-along.y, along.x};
    const Vec2 corners[] = {a - half, a + half, b - half, b + half};
    if (horizon_.hides(corners)) continue;
    // A thick wall hides at least what its middle line would.
    if (wall.height >= tallest_) horizon_.close(a, b);
    candidates_[kept++] = candidate;
  }
  candidates_.resize(kept);
}

void VisibleWalls::select(const Lens& lens, std::vector<std::uint32_t>& indices) {
  indices.clear();
  candidates_.clear();
  const Vec2 eye{lens.eye().x, lens.eye().y};
  for (std::uint32_t i = 0; i < entries_.size(); ++i) {
    const world::Wall& wall = entries_[i].wall;
    if (!in_frustum(wall, lens)) continue;
    candidates_.push_back({norm_squared(nearest_point(wall, eye) - eye), i});
  }
  // Nearest first, so that the depth test spares the shading of what is hidden.
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
    return a.near_squared != b.near_squared ? a.near_squared < b.near_squared : a.index < b.index;
  });
  drop_hidden(lens);
  for (const Candidate& candidate : candidates_) {
    add_quads(entries_[candidate.index], lens, indices);
  }
}

}  // namespace eyebridge::camera
