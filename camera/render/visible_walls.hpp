#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "eyebridge/world/world_model.hpp"
#include "optics/lens.hpp"
#include "render/horizon.hpp"

namespace eyebridge::camera {

/// Picks the quads of the walls that a lens may see, nearest first.
///
/// Never leaves out anything visible. One thread at a time.
class VisibleWalls {
 public:
  /// Quads count as in wall_mesh().
  explicit VisibleWalls(const std::vector<world::Wall>& walls);

  /// Replaces `indices` by the triangles of what `lens` may see.
  void select(const Lens& lens, std::vector<std::uint32_t>& indices);

  /// True when walls hide the upright cylinder of `radius` and `height` round `centre` from the
  /// lens of the last select().
  [[nodiscard]] bool hide(Vec2 centre, double radius, double height) const;
  /// The same for what stands over the line a-b up to `height`.
  [[nodiscard]] bool hide(Vec2 a, Vec2 b, double height) const;

 private:
  /// A quad, seen from above: an upright one, or the top of a thick wall by its middle line.
  struct Face {
    Vec2 a;
    Vec2 b;
    double height;
    double thickness;  ///< Of a top; 0 for what is upright.
    bool both_sides;   ///< Else it is seen from the left of a-b only.
  };
  struct Candidate {
    double depth;  ///< Of its nearest point along the eye's heading, metres.
    std::uint32_t quad;
  };

  void add_faces(const world::Wall& wall);
  /// A place as (depth along the eye's heading, sideways to the left).
  [[nodiscard]] Vec2 before_eye(Vec2 place) const {
    return back_.rotate(place - Vec2{eye_.x, eye_.y});
  }
  [[nodiscard]] bool may_be_seen(const Face& face, Vec2 a, Vec2 b, const Lens& lens) const;
  /// Leaves only those candidates that no nearer wall hides.
  void drop_hidden();
  [[nodiscard]] bool hides(const Face& face) const;

  std::vector<Face> faces_;  ///< One for each quad.
  double tallest_ = 0.0;
  Eye eye_;
  Heading back_;
  double reach_ = 0.0;      ///< Largest tangent of a bearing in view.
  bool over_walls_ = true;  ///< The lens may see over walls, or down steeply.
  Horizon horizon_;
  std::vector<Candidate> candidates_;
  std::vector<std::uint32_t> seen_;
  std::vector<std::uint32_t> low_;
};

}  // namespace eyebridge::camera
