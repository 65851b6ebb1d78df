#include "grid_graph.hpp"

#include <algorithm>
#include <cassert>

namespace eyebridge::planning {

GridGraph::GridGraph(const BlockedRaster& blocked)
    : stride_(static_cast<Node>(blocked.geometry.columns) + 2), offsets_{} {
  const std::size_t columns = static_cast<std::size_t>(blocked.geometry.columns);
  const std::size_t rows = static_cast<std::size_t>(blocked.geometry.rows);
  assert((columns + 2) * (rows + 2) <= std::numeric_limits<Node>::max());
  for (std::size_t d = 0; d < kDirections.size(); ++d) {
    offsets_[d] =
        static_cast<Node>(kDirections[d].up) * stride_ + static_cast<Node>(kDirections[d].right);
  }
  blocked_.assign((columns + 2) * (rows + 2), 1);
  for (std::size_t row = 0; row < rows; ++row) {
    const auto from = blocked.cells.begin() + static_cast<std::ptrdiff_t>(row * columns);
    const auto to = blocked_.begin() + static_cast<std::ptrdiff_t>((row + 1) * (columns + 2) + 1);
    std::copy(from, from + static_cast<std::ptrdiff_t>(columns), to);
  }
}

std::vector<Vec2> descend(const GridGraph& graph, const std::vector<Cost>& costs, Node from,
                          const mapping::GridGeometry& geometry) {
  std::vector<Vec2> points{geometry.centre_of(graph.cell_of(from))};
  std::size_t last = kDirections.size();
  for (Node at = from; costs[at] != 0;) {
    const unsigned steps = graph.steps_from(at);
    std::size_t best = kDirections.size();
    Cost lowest = kNoWay;
    for (std::size_t d = 0; d < kDirections.size(); ++d) {
      if ((steps >> d & 1U) == 0) continue;
      const Cost cost = costs[graph.neighbour(at, d)] + kDirections[d].cost;
      if (cost > lowest || (cost == lowest && d != last)) continue;
      lowest = cost;
      best = d;
    }
    assert(best < kDirections.size());
    if (best != last && at != from) points.push_back(geometry.centre_of(graph.cell_of(at)));
    last = best;
    at = graph.neighbour(at, best);
    if (costs[at] == 0) points.push_back(geometry.centre_of(graph.cell_of(at)));
  }
  return points;
}

}  // namespace eyebridge::planning
