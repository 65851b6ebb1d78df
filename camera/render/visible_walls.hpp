#pragma once

#include <cstdint>
#include <vector>

#include "eyebridge/world/world_model.hpp"
#include "render/lens.hpp"

namespace eyebridge::camera {

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

  std::vector<Entry> entries_;
  std::vector<Candidate> candidates_;
};

}  // namespace eyebridge::camera
