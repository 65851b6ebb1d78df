#include "eyebridge/planning/wavefront.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "bucket_queue.hpp"
#include "grid_graph.hpp"

namespace eyebridge::planning {
namespace {

using mapping::Cell;

std::size_t directions_of(Neighbours neighbours) { return neighbours == Neighbours::Four ? 4 : 8; }

std::vector<Cost> flood(const GridGraph& graph, const std::vector<Node>& sources,
                        std::size_t directions) {
  std::vector<Cost> costs(graph.size(), kNoWay);
  std::vector<std::uint8_t> passed_on(graph.size(), 0);
  BucketQueue queue(0);
  for (const Node node : sources) {
    if (costs[node] != 0) queue.push(node, 0);
    costs[node] = 0;
  }
  while (queue.lowest()) {
    const Node node = queue.pop();
    // No step is as short as a bucket is wide, so that what comes out is final.
    if (passed_on[node] != 0) continue;
    passed_on[node] = 1;
    const unsigned steps = graph.steps_from(node);
    for (std::size_t d = 0; d < directions; ++d) {
      const Node next = graph.neighbour(node, d);
      const Cost reached = costs[node] + kDirections[d].cost;
      if ((steps >> d & 1U) == 0 || reached >= costs[next]) continue;
      costs[next] = reached;
      queue.push(next, reached);
    }
  }
  return costs;
}

}  // namespace

DistanceField wavefront(const BlockedRaster& blocked, std::span<const Vec2> goals,
                        Neighbours neighbours) {
  const mapping::GridGeometry& grid = blocked.geometry;
  const GridGraph graph(blocked);
  std::vector<Node> sources;
  for (const Vec2 goal : goals) {
    if (!is_within(grid, goal)) continue;
    const Cell cell = grid.cell_at(goal);
    if (blocked[cell] == 0) sources.push_back(graph.node_of(cell));
  }
  const std::vector<Cost> costs = flood(graph, sources, directions_of(neighbours));
  DistanceField field(grid, std::numeric_limits<double>::infinity());
  const double metres = grid.resolution / static_cast<double>(kStraightCost);
  for (int row = 0; row < grid.rows; ++row) {
    Node node = graph.node_of({0, row});
    for (int column = 0; column < grid.columns; ++column, ++node) {
      if (costs[node] < kNoWay) field[{column, row}] = static_cast<double>(costs[node]) * metres;
    }
  }
  return field;
}

Planned path_down(const BlockedRaster& blocked, const DistanceField& field, Vec2 start,
                  Neighbours neighbours) {
  assert(field.geometry == blocked.geometry);
  const mapping::GridGeometry& grid = field.geometry;
  const tl::expected<Ends, NoPath> ends = ends_of(blocked, start, start);
  if (!ends) return tl::unexpected(ends.error());
  if (std::isinf(field[ends->start])) return tl::unexpected(NoPath::Unreachable);
  // Cells beside a free one that are free have a distance as well: where both beside a diagonal
  // step have one, it cuts no corner.
  const auto has_distance = [&](Cell cell) {
    return grid.contains(cell) && std::isfinite(field[cell]);
  };
  Path path;
  path.points.push_back(grid.centre_of(ends->start));
  path.expanded = 1;
  std::size_t last = kDirections.size();
  for (Cell at = ends->start; field[at] != 0.0;) {
    std::size_t best = kDirections.size();
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t d = 0; d < directions_of(neighbours); ++d) {
      const Direction& step = kDirections[d];
      const Cell to{at.column + step.right, at.row + step.up};
      if (!has_distance(to) || !has_distance({to.column, at.row}) ||
          !has_distance({at.column, to.row}) || field[to] >= field[at]) {
        continue;
      }
      const double way = field[to] + grid.resolution * (d < 4 ? 1.0 : std::sqrt(2.0));
      // Of ways that are equal but for rounding the straight one.
      const double slack = 1e-9 * grid.resolution;
      if (way < lowest - slack || (way < lowest + slack && d == last)) {
        lowest = way;
        best = d;
      }
    }
    assert(best < kDirections.size());
    if (best != last && path.expanded > 1) path.points.push_back(grid.centre_of(at));
    last = best;
    at = {at.column + kDirections[best].right, at.row + kDirections[best].up};
    ++path.expanded;
    if (field[at] == 0.0) path.points.push_back(grid.centre_of(at));
  }
  path.length = length_of(path.points);
  return path;
}

}  // namespace eyebridge::planning
