#include "eyebridge/planning/astar.hpp"

#include <algorithm>

#include "bucket_queue.hpp"
#include "grid_graph.hpp"

namespace eyebridge::planning {

Planned astar(const BlockedRaster& blocked, Vec2 start, Vec2 goal) {
  const tl::expected<Ends, NoPath> ends = ends_of(blocked, start, goal);
  if (!ends) return tl::unexpected(ends.error());
  const GridGraph graph(blocked);
  const Node from = graph.node_of(ends->start);
  const Node to = graph.node_of(ends->goal);
  std::vector<Cost> costs(graph.size(), kNoWay);
  // Set while a node's cost has not been passed on: an entry of the queue without it is outdated.
  std::vector<std::uint8_t> open(graph.size(), 0);
  const Cost least = octile(ends->start, ends->goal);
  BucketQueue queue(least);
  costs[from] = 0;
  open[from] = 1;
  queue.push(from, least);
  std::size_t expanded = 0;
  // Within a bucket nodes come in any order, so that a cost may fall again after it was passed on;
  // the node is then open once more. What ends at the goal cannot be shorter than its bucket.
  for (std::optional<Cost> lowest = queue.lowest(); lowest && *lowest < costs[to];
       lowest = queue.lowest()) {
    const Node node = queue.pop();
    if (open[node] == 0) continue;
    open[node] = 0;
    const mapping::Cell cell = graph.cell_of(node);
    const Cost cost = costs[node];
    if (cost + octile(cell, ends->goal) >= costs[to]) continue;
    ++expanded;
    const unsigned steps = graph.steps_from(node);
    for (std::size_t d = 0; d < kDirections.size(); ++d) {
      if ((steps >> d & 1U) == 0) continue;
      const Direction& direction = kDirections[d];
      const Node next = graph.neighbour(node, d);
      const Cost reached = cost + direction.cost;
      if (reached >= costs[next]) continue;
      costs[next] = reached;
      open[next] = 1;
      queue.push(next, reached + octile({cell.column + direction.right, cell.row + direction.up},
                                        ends->goal));
    }
  }
  if (costs[to] == kNoWay) return tl::unexpected(NoPath::Unreachable);
  Path path;
  path.expanded = expanded;
  path.points = descend(graph, costs, to, blocked.geometry);
  std::reverse(path.points.begin(), path.points.end());
  path.length = length_of(path.points);
  return path;
}

}  // namespace eyebridge::planning
