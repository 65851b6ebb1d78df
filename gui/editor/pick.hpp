#pragma once

#include <optional>

#include "editor/catalogue.hpp"
#include "editor/plan.hpp"

namespace eyebridge::gui {

/// What lies under the pointer, and by which part of it the mouse would hold it.
struct Hold {
  enum class Part {
    Body,
    Rim,     ///< Of a robot, start, box or polygon: turns it.
    Vertex,  ///< An end of a wall, and of all walls that share it.
    WayPoint,
    Way,  ///< Between two points of a way.
  };
  Item item;
  Part part = Part::Body;
  std::size_t point = 0;  ///< Of the way: this one, or the one that the stretch leads to.
  Vec2 at{};              ///< Of the vertex or way-point; else the nearest place of it.
};

/// Metres; a start's arrow is drawn in a disc of this size.
inline constexpr double kStartRadius = 0.07;

/// Of the disc about its place that covers a robot, thing, start or marker, metres; 0 for walls.
double radius_of(const Plan& plan, const Catalogue& catalogue, const Item& item);
/// The topmost thing within `slack` metres of `place`.
std::optional<Hold> pick(const Plan& plan, const Catalogue& catalogue, Vec2 place, double slack);
/// What lies wholly within a rectangle between two corners.
Selection items_within(const Plan& plan, const Catalogue& catalogue, Vec2 a, Vec2 b);

/// The nearest place on a grid of `step` metres; on one of a millimetre where that is 0.
Vec2 on_grid(Vec2 place, double step);
/// The nearest end of a wall within `reach` metres, save those at `except`; else on_grid().
Vec2 on_vertex_or_grid(const Plan& plan, Vec2 place, double step, double reach,
                       std::optional<Vec2> except = {});
/// `to`, moved so that the line from `from` runs level, upright or at 45 degrees.
Vec2 straightened(Vec2 from, Vec2 to);

}  // namespace eyebridge::gui
