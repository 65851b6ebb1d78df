#include "eyebridge/world/ray_caster.hpp"

#include <cassert>
#include <optional>
#include <stdexcept>

#include "maze_edges.hpp"
#include "ray_grid.hpp"

namespace eyebridge::world {

struct RayCaster::Impl {
  RayMethod method;
  std::vector<Segment> segments;
  std::optional<RayGrid> grid;  ///< Without it all segments are tried.
  std::optional<MazeEdges> edges;

  void cast(Vec2 origin, std::span<const Vec2> directions, double max_range,
            std::span<double> ranges) const;
};

namespace {

RayMethod pick_method(const WorldModel& model, RayMethod asked) {
  switch (asked) {
    case RayMethod::Auto:
      if (MazeEdges::describes(model)) return RayMethod::EdgeBits;
      return RayMethod::Grid;
    case RayMethod::EdgeBits:
      if (!MazeEdges::describes(model)) {
        throw std::invalid_argument("edge bits need a world whose walls are all edges of its maze");
      }
      break;
    case RayMethod::BruteForce:
    case RayMethod::Grid:
      break;
  }
  return asked;
}

}  // namespace

void RayCaster::Impl::cast(Vec2 origin, std::span<const Vec2> directions, double max_range,
                           std::span<double> ranges) const {
  if (edges && !edges->on_line(origin)) {
    edges->cast(origin, directions, max_range, ranges);
  } else if (grid) {
    grid->cast(origin, directions, max_range, ranges);
  } else {
    for (std::size_t i = 0; i < directions.size(); ++i) {
      double range = max_range;
      for (const Segment& s : segments) range = nearer_hit(s, origin, directions[i], range);
      ranges[i] = range;
    }
  }
}

RayCaster::RayCaster(const WorldModel& model, RayMethod method)
    : impl_(std::make_unique<Impl>(
          Impl{pick_method(model, method), outlines_of(model.walls), {}, {}})) {
  if (impl_->method != RayMethod::BruteForce && !impl_->segments.empty()) {
    impl_->grid.emplace(impl_->segments);
  }
  if (impl_->method == RayMethod::EdgeBits) impl_->edges.emplace(*model.maze);
}
RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

double RayCaster::cast(Vec2 origin, Vec2 direction, double max_range) const {
  double range = max_range;
  impl_->cast(origin, {&direction, 1}, max_range, {&range, 1});
  return range;
}

void RayCaster::cast_fan(Vec2 origin, std::span<const Vec2> directions, double max_range,
                         std::span<double> ranges) const {
  assert(directions.size() == ranges.size());
  impl_->cast(origin, directions, max_range, ranges);
}

RayMethod RayCaster::method() const { return impl_->method; }

}  // namespace eyebridge::world
