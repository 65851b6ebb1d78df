#include "eyebridge/planning/path.hpp"

namespace eyebridge::planning {

const char* to_text(NoPath reason) {
  switch (reason) {
    case NoPath::StartOutside:
      return "the start lies outside of the map";
    case NoPath::GoalOutside:
      return "the goal lies outside of the map";
    case NoPath::StartBlocked:
      return "the start is blocked";
    case NoPath::GoalBlocked:
      return "the goal is blocked";
    case NoPath::Unreachable:
      return "no way leads from the start to the goal";
    case NoPath::LocalMinimum:
      return "stuck in a local minimum before the goal";
    case NoPath::BudgetSpent:
      return "no way found with the samples or steps allowed";
  }
  return "";
}

double length_of(const std::vector<Vec2>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length += norm(points[i] - points[i - 1]);
  return length;
}

bool is_within(const mapping::GridGeometry& geometry, Vec2 point) {
  // Before cell_at(), whose cells are ints; written so that NaN is outside.
  const double column = (point.x - geometry.origin.x) / geometry.resolution;
  const double row = (point.y - geometry.origin.y) / geometry.resolution;
  return column >= 0.0 && row >= 0.0 && column < geometry.columns && row < geometry.rows;
}

tl::expected<Ends, NoPath> ends_of(const BlockedRaster& blocked, Vec2 start, Vec2 goal) {
  const mapping::GridGeometry& geometry = blocked.geometry;
  if (!is_within(geometry, start)) return tl::unexpected(NoPath::StartOutside);
  const mapping::Cell from = geometry.cell_at(start);
  if (blocked[from] != 0) return tl::unexpected(NoPath::StartBlocked);
  if (!is_within(geometry, goal)) return tl::unexpected(NoPath::GoalOutside);
  const mapping::Cell to = geometry.cell_at(goal);
  if (blocked[to] != 0) return tl::unexpected(NoPath::GoalBlocked);
  return Ends{from, to};
}

}  // namespace eyebridge::planning
