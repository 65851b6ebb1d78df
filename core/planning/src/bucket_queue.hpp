#pragma once

#include <array>
#include <cassert>
#include <optional>
#include <vector>

#include "grid_graph.hpp"

namespace eyebridge::planning {

/// Nodes by cost, to within an eighth of a cell's edge, last in first out (Dial, "Algorithm 360:
/// Shortest-path forest with topological ordering", CACM 12, 1969): no comparisons, and no memory
/// but one array for each of the few costs that are open at once.
class BucketQueue {
 public:
  /// `lowest`: the least cost that comes.
  explicit BucketQueue(Cost lowest) : first_(lowest >> kShift) {}

  /// `cost` is not below lowest(), nor 3.8 cells' edges or more above.
  void push(Node node, Cost cost) {
    const Cost bucket = cost >> kShift;
    assert(bucket >= first_ && bucket < first_ + kBuckets);
    buckets_[bucket % kBuckets].push_back(node);
    ++count_;
  }
  /// No node here costs less; nothing if there is none.
  [[nodiscard]] std::optional<Cost> lowest() {
    if (count_ == 0) return std::nullopt;
    while (buckets_[first_ % kBuckets].empty()) ++first_;
    return first_ << kShift;
  }
  /// One of the cheapest nodes; after lowest(), which found some.
  Node pop() {
    std::vector<Node>& bucket = buckets_[first_ % kBuckets];
    const Node node = bucket.back();
    bucket.pop_back();
    --count_;
    return node;
  }

 private:
  static constexpr unsigned kShift = 29;
  static constexpr Cost kBuckets = 32;

  std::array<std::vector<Node>, kBuckets> buckets_;
  Cost first_;
  std::size_t count_ = 0;
};

}  // namespace eyebridge::planning
