#include "render/visible_walls.hpp"

#include <algorithm>

#include "render/mesh.hpp"

namespace eyebridge::camera {
namespace {

Vec2 nearest_point(const world::Wall& wall, Vec2 from) {
  const Vec2 along = wall.b - wall.a;
  const double t = std::clamp(dot(from - wall.a, along) / norm_squared(along), 0.0, 1.0);
  return wall.a + t * along;
}

}  // namespace

VisibleWalls::VisibleWalls(const std::vector<world::Wall>& walls) {
  std::uint32_t quad = 0;
  for (const world::Wall& wall : walls) {
    entries_.push_back({wall, quad});
    quad += static_cast<std::uint32_t>(quads_of(wall));
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
  for (const Candidate& candidate : candidates_) {
    add_quads(entries_[candidate.index], lens, indices);
  }
}

}  // namespace eyebridge::camera
