#include "render/visible_walls.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "eyebridge/base/math.hpp"
#include "render/mesh.hpp"

namespace eyebridge::camera {
namespace {

/// Whether an upright quad, or a lying one at `height` and `margin` to its sides, may be in view.
bool in_frustum(Vec2 a, Vec2 b, double height, double margin, const Lens& lens) {
  return std::ranges::all_of(lens.frustum(), [&](const Plane& plane) {
    const double top = std::max(0.0, plane.normal.z * height) + margin;
    return plane.distance({a.x, a.y, 0.0}) >= -top || plane.distance({b.x, b.y, 0.0}) >= -top;
  });
}

}  // namespace

VisibleWalls::VisibleWalls(const std::vector<world::Wall>& walls) {
  for (const world::Wall& wall : walls) {
    add_faces(wall);
    tallest_ = std::max(tallest_, wall.height);
  }
}

void VisibleWalls::add_faces(const world::Wall& wall) {
  if (wall.thickness <= 0.0) {
    faces_.push_back({wall.a, wall.b, wall.height, 0.0, true});
    return;
  }
  const std::array<Vec2, 4> corner = outline_of(wall);
  for (const auto& [from, to] : {std::pair{0U, 1U}, {2U, 3U}, {1U, 2U}, {3U, 0U}}) {
    faces_.push_back({corner[from], corner[to], wall.height, 0.0, false});
  }
  faces_.push_back({wall.a, wall.b, wall.height, wall.thickness, true});
}

bool VisibleWalls::may_be_seen(const Face& face, Vec2 a, Vec2 b, const Lens& lens) const {
  if (!face.both_sides && cross(b - a, -1.0 * a) <= 0.0) return false;
  if (face.thickness > 0.0 && eye_.z <= face.height) return false;
  if (over_walls_) return in_frustum(face.a, face.b, face.height, face.thickness, lens);
  // Not when it is wholly behind the eye, or to the left or right of what is in view.
  const double margin = face.thickness * (1.0 + reach_);
  return std::max(a.x, b.x) >= -margin &&
         std::min(a.y - reach_ * a.x, b.y - reach_ * b.x) <= margin &&
         std::max(a.y + reach_ * a.x, b.y + reach_ * b.x) >= -margin;
}

bool VisibleWalls::hides(const Face& face) const {
  const Vec2 along = face.b - face.a;
  const Vec2 half = (0.5 * face.thickness / norm(along)) * Vec2{-along.y, along.x};
  return horizon_.hides(std::array{before_eye(face.a - half), before_eye(face.a + half),
                                   before_eye(face.b - half), before_eye(face.b + half)});
}

void VisibleWalls::drop_hidden() {
  const auto farther = [](const Candidate& a, const Candidate& b) { return a.depth > b.depth; };
  std::make_heap(candidates_.begin(), candidates_.end(), farther);
  std::size_t left = candidates_.size();
  seen_.clear();
  low_.clear();
  while (left > 0 && candidates_.front().depth <= horizon_.farthest()) {
    std::pop_heap(candidates_.begin(), candidates_.begin() + static_cast<std::ptrdiff_t>(left--),
                  farther);
    const Candidate& next = candidates_[left];
    const Face& face = faces_[next.quad];
    if (face.thickness > 0.0 || face.height < tallest_) {
      low_.push_back(next.quad);
      continue;
    }
    // What the picture's plane may cut hides nothing.
    if (next.depth <= horizon_.nearest()) seen_.push_back(next.quad);
    horizon_.add(before_eye(face.a), before_eye(face.b), next.quad);
  }
  horizon_.list_seen(seen_);
  for (const std::uint32_t quad : low_) {
    if (!hides(faces_[quad])) seen_.push_back(quad);
  }
  std::sort(seen_.begin(), seen_.end());
  seen_.erase(std::unique(seen_.begin(), seen_.end()), seen_.end());
  std::erase_if(candidates_, [&](const Candidate& candidate) {
    return !std::binary_search(seen_.begin(), seen_.end(), candidate.quad);
  });
}

void VisibleWalls::select(const Lens& lens, std::vector<std::uint32_t>& indices) {
  eye_ = lens.eye();
  const SinCos heading = sin_cos(eye_.heading);
  back_ = {heading.cos, -heading.sin};
  // Tangents of the bearings in view: the frustum's corners, seen from above. A camera that looks
  // steeply sees more bearings than a plane before it can hold.
  const SinCos pitch = sin_cos(eye_.pitch);
  const double shallowest = pitch.cos - lens.half_height() * std::abs(pitch.sin);
  over_walls_ = eye_.z >= tallest_ || shallowest < 0.3;
  reach_ = 1.001 * lens.half_width() / std::max(shallowest, 0.3);

  candidates_.clear();
  for (std::uint32_t quad = 0; quad < faces_.size(); ++quad) {
    const Face& face = faces_[quad];
    const Vec2 a = before_eye(face.a);
    const Vec2 b = before_eye(face.b);
    if (!may_be_seen(face, a, b, lens)) continue;
    candidates_.push_back({std::min(a.x, b.x) - face.thickness, quad});
  }
  if (!over_walls_) {
    horizon_.clear(reach_, Lens::kNear * (1.0 + lens.half_height()));
    drop_hidden();
  }
  // Nearest first, so that the depth test spares the shading of what is hidden.
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
    return a.depth != b.depth ? a.depth < b.depth : a.quad < b.quad;
  });
  indices.clear();
  for (const Candidate& candidate : candidates_) {
    for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) {
      indices.push_back(4 * candidate.quad + i);
    }
  }
}

bool VisibleWalls::hide(Vec2 centre, double radius, double height) const {
  if (over_walls_ || height > tallest_) return false;
  const Vec2 at = before_eye(centre);
  return horizon_.hides(std::array{at + Vec2{-radius, -radius}, at + Vec2{-radius, radius},
                                   at + Vec2{radius, -radius}, at + Vec2{radius, radius}});
}

bool VisibleWalls::hide(Vec2 a, Vec2 b, double height) const {
  if (over_walls_ || height > tallest_) return false;
  return horizon_.hides(std::array{before_eye(a), before_eye(b)});
}

}  // namespace eyebridge::camera
