#include "eyebridge/planning/dstar_lite.hpp"

#include <algorithm>
#include <cassert>
#include <optional>

#include "bucket_queue.hpp"
#include "grid_graph.hpp"
#include "node_heap.hpp"

namespace eyebridge::planning {
namespace {

using mapping::Cell;

struct DStarKey {
  Cost whole = 0;
  Cost rest = 0;

  friend bool operator==(const DStarKey&, const DStarKey&) = default;
  friend bool operator<(const DStarKey& a, const DStarKey& b) {
    return a.whole != b.whole ? a.whole < b.whole : a.rest < b.rest;
  }
};

}  // namespace

// Names as in the paper: g is the distance to the goal that neighbours go by, rhs what they make
// of it one step ahead, km how far the robot has moved since the keys in the heap were made.
class DStarLite::Impl {
 public:
  Impl(const BlockedRaster& blocked, Vec2 goal)
      : raster(blocked),
        goal_point_(goal),
        graph_(blocked),
        g_(graph_.size(), kNoWay),
        rhs_(graph_.size(), kNoWay),
        heap_(graph_.size()) {}

  void set_blocked(Cell cell, bool blocked) {
    assert(raster.geometry.contains(cell));
    if ((raster[cell] != 0) == blocked) return;
    raster[cell] = blocked ? 1 : 0;
    graph_.set_blocked(graph_.node_of(cell), blocked);
    if (!start_) return;
    // Steps to and from the cell, and those that pass its corners, join cells of its block of nine.
    for (int up = -1; up <= 1; ++up) {
      for (int right = -1; right <= 1; ++right) {
        const Cell near{cell.column + right, cell.row + up};
        if (!raster.geometry.contains(near)) continue;
        const Node node = graph_.node_of(near);
        rhs_[node] = one_step_ahead(node);
        update(node);
      }
    }
  }

  Planned plan(Vec2 start) {
    const tl::expected<Ends, NoPath> ends = ends_of(raster, start, goal_point_);
    if (!ends) return tl::unexpected(ends.error());
    if (ends->start == ends->goal) return Path{{raster.geometry.centre_of(ends->goal)}, 0.0, 0};
    bool first = false;
    if (start_) {
      km_ += octile(*start_, ends->start);
      start_ = ends->start;
    } else {
      start_ = ends->start;
      goal_ = graph_.node_of(ends->goal);
      first = true;
    }
    const Node from = graph_.node_of(ends->start);
    const std::size_t expanded = first ? search(from) : compute(from);
    if (rhs_[from] >= kNoWay) return tl::unexpected(NoPath::Unreachable);
    Path path;
    path.expanded = expanded;
    path.points = descend(graph_, g_, from, raster.geometry);
    path.length = length_of(path.points);
    return path;
  }

  BlockedRaster raster;

 private:
  [[nodiscard]] DStarKey key_of(Node node) const {
    const Cost rest = std::min(g_[node], rhs_[node]);
    return {rest + octile(*start_, graph_.cell_of(node)) + km_, rest};
  }

  [[nodiscard]] Cost one_step_ahead(Node node) const {
    if (node == goal_) return 0;
    if (graph_.is_blocked(node)) return kNoWay;
    Cost lowest = kNoWay;
    const unsigned steps = graph_.steps_from(node);
    for (std::size_t d = 0; d < kDirections.size(); ++d) {
      if ((steps >> d & 1U) == 0) continue;
      lowest = std::min(lowest, g_[graph_.neighbour(node, d)] + kDirections[d].cost);
    }
    return lowest;
  }

  void update(Node node) {
    if (g_[node] == rhs_[node]) {
      heap_.remove(node);
    } else {
      heap_.set(node, key_of(node));
    }
  }

  /// The first plan: A* from the goal, whose queue costs half as much as a heap with keys that
  /// change. The heap gets what is left open.
  std::size_t search(Node from) {
    std::vector<std::uint8_t> open(graph_.size(), 0);
    std::vector<Node> too_far;
    BucketQueue queue(octile(*start_, graph_.cell_of(goal_)));
    const auto reach = [&](Node node, Cost cost) {
      rhs_[node] = cost;
      open[node] = 1;
      queue.push(node, cost + octile(*start_, graph_.cell_of(node)));
    };
    const auto expand = [&](Node node) {
      open[node] = 0;
      g_[node] = rhs_[node];
      const unsigned steps = graph_.steps_from(node);
      for (std::size_t d = 0; d < kDirections.size(); ++d) {
        const Node near = graph_.neighbour(node, d);
        const Cost cost = g_[node] + kDirections[d].cost;
        if ((steps >> d & 1U) != 0 && cost < rhs_[near]) reach(near, cost);
      }
    };
    std::size_t expanded = 0;
    reach(goal_, 0);
    for (std::optional<Cost> lowest = queue.lowest(); lowest && *lowest < rhs_[from];
         lowest = queue.lowest()) {
      const Node node = queue.pop();
      if (open[node] == 0) continue;
      if (rhs_[node] + octile(*start_, graph_.cell_of(node)) >= rhs_[from]) {
        too_far.push_back(node);
        continue;
      }
      ++expanded;
      expand(node);
    }
    if (rhs_[from] < kNoWay) expand(from);
    while (queue.lowest()) too_far.push_back(queue.pop());
    for (const Node node : too_far) update(node);
    return expanded;
  }

  std::size_t compute(Node from) {
    std::size_t expanded = 0;
    while (!heap_.empty() && (heap_.top().key < key_of(from) || rhs_[from] > g_[from])) {
      const auto [old_key, node] = heap_.top();
      if (const DStarKey key = key_of(node); old_key < key) {
        heap_.set(node, key);
        continue;
      }
      ++expanded;
      if (g_[node] > rhs_[node]) {
        g_[node] = rhs_[node];
        heap_.remove(node);
        pass_on(node, [&](Node near, Cost reached) {
          if (reached >= rhs_[near]) return false;
          rhs_[near] = reached;
          return true;
        });
      } else {
        const Cost before = g_[node];
        g_[node] = kNoWay;
        update(node);
        pass_on(node, [&](Node near, Cost reached) {
          if (rhs_[near] != reached - kNoWay + before) return false;
          rhs_[near] = one_step_ahead(near);
          return true;
        });
      }
    }
    return expanded;
  }

  /// Calls `change(neighbour, cost of its way over node)` for all but the goal: whether it changed
  /// anything.
  template <class Change>
  void pass_on(Node node, const Change& change) {
    if (graph_.is_blocked(node)) return;  // its neighbours heard of it when it was
    const unsigned steps = graph_.steps_from(node);
    for (std::size_t d = 0; d < kDirections.size(); ++d) {
      const Node near = graph_.neighbour(node, d);
      if ((steps >> d & 1U) == 0 || near == goal_) continue;
      if (change(near, g_[node] + kDirections[d].cost)) update(near);
    }
  }

  Vec2 goal_point_;
  GridGraph graph_;
  Node goal_ = 0;
  std::optional<Cell> start_;  ///< Of the last plan.
  Cost km_ = 0;
  std::vector<Cost> g_;
  std::vector<Cost> rhs_;
  NodeHeap<DStarKey> heap_;
};

DStarLite::DStarLite(const BlockedRaster& blocked, Vec2 goal)
    : impl_(std::make_unique<Impl>(blocked, goal)) {}
DStarLite::DStarLite(DStarLite&&) noexcept = default;
DStarLite& DStarLite::operator=(DStarLite&&) noexcept = default;
DStarLite::~DStarLite() = default;

void DStarLite::set_blocked(Cell cell, bool blocked) { impl_->set_blocked(cell, blocked); }
const BlockedRaster& DStarLite::blocked() const { return impl_->raster; }
Planned DStarLite::plan(Vec2 start) { return impl_->plan(start); }

}  // namespace eyebridge::planning
