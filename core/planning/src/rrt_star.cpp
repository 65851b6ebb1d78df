#include "eyebridge/planning/rrt_star.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "eyebridge/base/math.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/planning/sight.hpp"
#include "point_buckets.hpp"

namespace eyebridge::planning {
namespace {

// Buckets finer than a step find less in vain; coarser ones than this share of the floor, none.
constexpr double kBucketsPerStep = 2.0;
constexpr double kMostBuckets = 256.0;

/// The paper wants more than this bound (its theorem 38, for the plane).
constexpr double kBeyondBound = 1.1;

double bucket_edge(const mapping::GridGeometry& grid, double step) {
  const double longest = std::max(grid.columns, grid.rows) * grid.resolution;
  return std::clamp(step / kBucketsPerStep, longest / kMostBuckets, longest);
}

class RrtStarTree {
 public:
  RrtStarTree(const BlockedRaster& blocked, Vec2 root, Vec2 goal, const RrtStarSettings& settings)
      : blocked_(blocked),
        settings_(settings),
        goal_(goal),
        points_(blocked.geometry, bucket_edge(blocked.geometry, settings.step)) {
    const std::size_t free = static_cast<std::size_t>(
        std::count(blocked.cells.begin(), blocked.cells.end(), std::uint8_t{0}));
    const double cell_area = blocked.geometry.resolution * blocked.geometry.resolution;
    const double area = static_cast<double>(free) * cell_area;
    gamma_ = kBeyondBound * 2.0 * std::sqrt(1.5) * std::sqrt(area / kPi);
    add(root, 0, 0.0);
  }

  void grow_towards(Vec2 sample) {
    const std::size_t nearest = points_.nearest(sample);
    const Vec2 from = points_[nearest];
    const double distance = norm(sample - from);
    if (distance == 0.0) return;  // the goal again, which is a node already
    const Vec2 point =
        distance <= settings_.step ? sample : from + settings_.step / distance * (sample - from);
    if (!is_free_line(blocked_, from, point)) return;
    const double n = static_cast<double>(points_.size() + 1);
    points_.within(point, std::min(settings_.step, gamma_ * std::sqrt(log_of(n) / n)), near_);
    std::size_t parent = nearest;
    double cost = costs_[nearest] + norm(point - from);
    for (const std::uint32_t other : near_) {
      const double way = costs_[other] + norm(point - points_[other]);
      if (way >= cost || !is_free_line(blocked_, points_[other], point)) continue;
      parent = other;
      cost = way;
    }
    const std::size_t node = add(point, parent, cost);
    for (const std::uint32_t other : near_) {
      const double way = cost + norm(points_[other] - point);
      if (way < costs_[other] && is_free_line(blocked_, point, points_[other])) {
        rewire(other, node, way);
      }
    }
  }

  [[nodiscard]] Planned path() const {
    if (goal_node_ == kNone) return tl::unexpected(NoPath::BudgetSpent);
    Path path;
    path.expanded = points_.size();
    for (std::size_t at = goal_node_; at != 0; at = parents_[at])
      path.points.push_back(points_[at]);
    path.points.push_back(points_[0]);
    std::reverse(path.points.begin(), path.points.end());
    path.length = length_of(path.points);
    return path;
  }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  std::size_t add(Vec2 point, std::size_t parent, double cost) {
    const std::uint32_t node = static_cast<std::uint32_t>(points_.size());
    points_.add(point);
    parents_.push_back(static_cast<std::uint32_t>(parent));
    costs_.push_back(cost);
    first_child_.push_back(kNone);
    next_sibling_.push_back(kNone);
    if (node != 0) hang(node, parent);
    if (point == goal_) goal_node_ = node;
    return node;
  }

  void hang(std::uint32_t node, std::size_t parent) {
    parents_[node] = static_cast<std::uint32_t>(parent);
    next_sibling_[node] = first_child_[parent];
    first_child_[parent] = node;
  }

  /// Makes `node` a child of `parent`; all that hangs on it becomes shorter as well.
  void rewire(std::uint32_t node, std::size_t parent, double cost) {
    std::uint32_t* link = &first_child_[parents_[node]];
    while (*link != node) link = &next_sibling_[*link];
    *link = next_sibling_[node];
    hang(node, parent);
    costs_[node] = cost;
    below_.assign(1, node);
    while (!below_.empty()) {
      const std::uint32_t at = below_.back();
      below_.pop_back();
      for (std::uint32_t child = first_child_[at]; child != kNone; child = next_sibling_[child]) {
        costs_[child] = costs_[at] + norm(points_[child] - points_[at]);
        below_.push_back(child);
      }
    }
  }

  const BlockedRaster& blocked_;
  const RrtStarSettings& settings_;
  Vec2 goal_;
  PointBuckets points_;
  double gamma_ = 0.0;
  std::vector<std::uint32_t> parents_;
  std::vector<double> costs_;
  std::vector<std::uint32_t> first_child_;
  std::vector<std::uint32_t> next_sibling_;
  std::vector<std::uint32_t> near_;   ///< Of the last sample.
  std::vector<std::uint32_t> below_;  ///< Still to be told of a shorter way.
  std::uint32_t goal_node_ = kNone;
};

}  // namespace

Planned rrt_star(const BlockedRaster& blocked, Vec2 start, Vec2 goal, Random& random,
                 const RrtStarSettings& settings) {
  if (settings.samples <= 0) throw std::invalid_argument("RRT*: samples must be > 0");
  if (!(settings.step > 0.0)) throw std::invalid_argument("RRT*: step must be > 0");
  if (!(settings.goal_bias > 0.0 && settings.goal_bias <= 1.0)) {
    throw std::invalid_argument("RRT*: goal_bias must be in (0, 1]");
  }
  const tl::expected<Ends, NoPath> ends = ends_of(blocked, start, goal);
  if (!ends) return tl::unexpected(ends.error());
  RrtStarTree tree(blocked, start, goal, settings);
  const mapping::GridGeometry& grid = blocked.geometry;
  const Vec2 extent{grid.columns * grid.resolution, grid.rows * grid.resolution};
  for (int i = 0; i < settings.samples; ++i) {
    if (random.chance(settings.goal_bias)) {
      tree.grow_towards(goal);
      continue;
    }
    const double x = random.uniform() * extent.x;
    const double y = random.uniform() * extent.y;
    const Vec2 sample = grid.origin + Vec2{x, y};
    if (is_within(grid, sample) && blocked[grid.cell_at(sample)] == 0) tree.grow_towards(sample);
  }
  return tree.path();
}

}  // namespace eyebridge::planning
