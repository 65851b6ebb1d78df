#include "eyebridge/planning/theta_star.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "eyebridge/planning/sight.hpp"
#include "grid_graph.hpp"

namespace eyebridge::planning {
namespace {

using mapping::Cell;

// Shorter by less is rounding, and not worth another look.
constexpr double kShorter = 1e-9;

double between(Cell a, Cell b) {
  const double columns = a.column - b.column;
  const double rows = a.row - b.row;
  return std::sqrt(columns * columns + rows * rows);
}

struct ThetaEntry {
  double whole = 0.0;  ///< From the start, and on to the goal in a straight line, in cells.
  double done = 0.0;   ///< From the start.
  Node node = 0;

  /// Order of a heap whose top comes next; of equals the one nearer to the goal.
  friend bool operator<(const ThetaEntry& a, const ThetaEntry& b) {
    if (a.whole != b.whole) return a.whole > b.whole;
    if (a.done != b.done) return a.done < b.done;
    return a.node > b.node;
  }
};

class ThetaSearch {
 public:
  ThetaSearch(const BlockedRaster& blocked, const Ends& ends)
      : blocked_(blocked),
        graph_(blocked),
        goal_(ends.goal),
        start_node_(graph_.node_of(ends.start)),
        goal_node_(graph_.node_of(ends.goal)),
        done_(graph_.size(), std::numeric_limits<double>::infinity()),
        parents_(graph_.size(), start_node_) {
    improve(start_node_, ends.start, 0.0, start_node_);
  }

  Planned run() {
    while (!heap_.empty() && heap_.front().whole < done_[goal_node_] - kShorter) {
      std::pop_heap(heap_.begin(), heap_.end());
      const ThetaEntry entry = heap_.back();
      heap_.pop_back();
      if (entry.done == done_[entry.node]) expand(entry.node);
    }
    if (std::isinf(done_[goal_node_])) return tl::unexpected(NoPath::Unreachable);
    Path path;
    path.expanded = expanded_;
    for (Node at = goal_node_; at != start_node_; at = parents_[at])
      path.points.push_back(at_centre(at));
    path.points.push_back(at_centre(start_node_));
    std::reverse(path.points.begin(), path.points.end());
    path.length = length_of(path.points);
    return path;
  }

 private:
  [[nodiscard]] Vec2 at_centre(Node node) const {
    return blocked_.geometry.centre_of(graph_.cell_of(node));
  }

  void improve(Node node, Cell cell, double done, Node parent) {
    done_[node] = done;
    parents_[node] = parent;
    heap_.push_back({done + between(cell, goal_), done, node});
    std::push_heap(heap_.begin(), heap_.end());
  }

  void expand(Node node) {
    ++expanded_;
    const Cell cell = graph_.cell_of(node);
    const Node parent = parents_[node];
    const Cell parent_cell = graph_.cell_of(parent);
    const unsigned steps = graph_.steps_from(node);
    for (std::size_t d = 0; d < kDirections.size(); ++d) {
      if ((steps >> d & 1U) == 0) continue;
      const Node next = graph_.neighbour(node, d);
      const Cell to{cell.column + kDirections[d].right, cell.row + kDirections[d].up};
      // From the parent it is never farther; the line is looked at only if it would help.
      const double straight = done_[parent] + between(parent_cell, to);
      if (straight >= done_[next] - kShorter) continue;
      if (is_free_line(blocked_, parent_cell, to)) {
        improve(next, to, straight, parent);
        continue;
      }
      const double stepped = done_[node] + between(cell, to);
      if (stepped < done_[next] - kShorter) improve(next, to, stepped, node);
    }
  }

  const BlockedRaster& blocked_;
  GridGraph graph_;
  Cell goal_;
  Node start_node_;
  Node goal_node_;
  std::vector<double> done_;
  std::vector<Node> parents_;
  std::vector<ThetaEntry> heap_;
  std::size_t expanded_ = 0;
};

}  // namespace

Planned theta_star(const BlockedRaster& blocked, Vec2 start, Vec2 goal) {
  const tl::expected<Ends, NoPath> ends = ends_of(blocked, start, goal);
  if (!ends) return tl::unexpected(ends.error());
  return ThetaSearch(blocked, *ends).run();
}

}  // namespace eyebridge::planning
