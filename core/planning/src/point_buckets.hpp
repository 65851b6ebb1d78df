#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/mapping/raster.hpp"

namespace eyebridge::planning {

/// Points of the plane in square buckets, each a chain through one array: near ones are found
/// without looking at the others, whatever order they came in.
class PointBuckets {
 public:
  /// For points within `area`; `edge` of a bucket in metres, > 0.
  PointBuckets(const mapping::GridGeometry& area, double edge)
      : grid_(mapping::GridGeometry::covering(area.origin, area.columns * area.resolution,
                                              area.rows * area.resolution, edge)),
        heads_(grid_.size(), kEnd) {}

  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] Vec2 operator[](std::size_t i) const { return points_[i]; }

  void add(Vec2 point) {
    std::uint32_t& head = heads_[grid_.index_of(bucket_of(point))];
    next_.push_back(head);
    head = static_cast<std::uint32_t>(points_.size());
    points_.push_back(point);
  }

  /// The nearest point, of equally near ones the first added; there is one.
  [[nodiscard]] std::size_t nearest(Vec2 place) const {
    const mapping::Cell centre = bucket_of(place);
    std::size_t found = 0;
    double best = std::numeric_limits<double>::infinity();
    // What lies beyond a ring is farther away than the ring is wide.
    for (int ring = 0; ring == 0 || (ring - 1) * grid_.resolution < std::sqrt(best); ++ring) {
      each_bucket_of_ring(centre, ring, [&](std::uint32_t i) {
        const double squared = norm_squared(points_[i] - place);
        if (squared > best || (squared == best && i > found)) return;
        best = squared;
        found = i;
      });
    }
    return found;
  }

  /// All points closer than `radius` metres, in the order that they were added.
  void within(Vec2 place, double radius, std::vector<std::uint32_t>& found) const {
    found.clear();
    const mapping::Cell low = bucket_of(place - Vec2{radius, radius});
    const mapping::Cell high = bucket_of(place + Vec2{radius, radius});
    for (int row = low.row; row <= high.row; ++row) {
      for (int column = low.column; column <= high.column; ++column) {
        each_in({column, row}, [&](std::uint32_t i) {
          if (norm_squared(points_[i] - place) < radius * radius) found.push_back(i);
        });
      }
    }
    std::sort(found.begin(), found.end());
  }

 private:
  static constexpr std::uint32_t kEnd = std::numeric_limits<std::uint32_t>::max();

  [[nodiscard]] mapping::Cell bucket_of(Vec2 point) const {
    const mapping::Cell cell = grid_.cell_at(point);
    return {std::clamp(cell.column, 0, grid_.columns - 1), std::clamp(cell.row, 0, grid_.rows - 1)};
  }
  template <class Visit>
  void each_in(mapping::Cell bucket, const Visit& visit) const {
    for (std::uint32_t i = heads_[grid_.index_of(bucket)]; i != kEnd; i = next_[i]) visit(i);
  }
  template <class Visit>
  void each_bucket_of_ring(mapping::Cell centre, int ring, const Visit& visit) const {
    for (int up = -ring; up <= ring; ++up) {
      const bool whole = up == -ring || up == ring;
      for (int right = -ring; right <= ring; right += whole || ring == 0 ? 1 : 2 * ring) {
        const mapping::Cell bucket{centre.column + right, centre.row + up};
        if (grid_.contains(bucket)) each_in(bucket, visit);
      }
    }
  }

  mapping::GridGeometry grid_;
  std::vector<std::uint32_t> heads_;
  std::vector<std::uint32_t> next_;
  std::vector<Vec2> points_;
};

}  // namespace eyebridge::planning
