#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "eyebridge/world/world_model.hpp"
#include "render/lens.hpp"

namespace eyebridge::camera {

/// For each of many narrow sectors before the eye, how far a wall closes it off.
///
/// Seen from above, with depth along the eye's heading and u the tangent of the bearing. On a line,
/// 1 / depth is linear in u, so the depths at a sector's two edges bound those between them.
class Horizon {
 public:
  /// Opens all sectors over -`reach` … `reach`.
  void clear(double reach);
  /// Closes the sectors that the segment spans from edge to edge. Its ends as (depth, sideways).
  void close(Vec2 a, Vec2 b);
  /// True when every sector that the hull of `corners` touches is closed before all of them. False
  /// when one of them is not before the eye.
  [[nodiscard]] bool hides(std::span<const Vec2> corners) const;

 private:
  static constexpr int kSectors = 512;
  std::array<double, kSectors> depth_{};
  double reach_ = 1.0;
};

/// Picks the quads of the walls that a lens may see, nearest first.
///
/// Never leaves out anything visible. One thread at a time.
class VisibleWalls {
 public:
  /// Takes copies of `walls`; quads count as in wall_mesh().
  explicit VisibleWalls(const std::vector<world::Wall>& walls);

  /// Replaces `indices` by the triangles of what `lens` may see.
  void select(const Lens& lens, std::vector<std::uint32_t>& indices);

 private:
  struct Entry {
    world::Wall wall;
    std::uint32_t first_quad;
  };
  struct Candidate {
    double near_squared;  ///< Of the nearest point, from above, metres^2.
    std::uint32_t index;
  };

  [[nodiscard]] bool in_frustum(const world::Wall& wall, const Lens& lens) const;
  void add_quads(const Entry& entry, const Lens& lens, std::vector<std::uint32_t>& indices) const;

  /// Leaves out what stands behind nearer walls, when the eye cannot look over them.
  void drop_hidden(const Lens& lens);

  std::vector<Entry> entries_;
  double tallest_ = 0.0;
  Horizon horizon_;
  std::vector<Candidate> candidates_;
};

}  // namespace eyebridge::camera
