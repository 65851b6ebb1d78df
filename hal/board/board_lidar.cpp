#include "board/board_lidar.hpp"

#include <algorithm>
#include <cmath>

#include "arguments/arguments.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {
namespace {

constexpr const char* kName = "lidar";
constexpr double kAngleSlack = 0.01;  // radians: boards round to whole degrees

/// Bearing of ray `i`, left positive. A full circle starts straight behind; a part of one has rays
/// at both its edges.
double bearing(const LidarShape& shape, int i) {
  if (shape.points == 1) return 0.0;
  const bool circle = shape.field_of_view > 2 * kPi - kAngleSlack;
  const double step = shape.field_of_view / (circle ? shape.points : shape.points - 1);
  return shape.field_of_view / 2 - step * i;
}

/// The ray of `shape` that is nearest to `angle`.
std::size_t nearest_ray(const LidarShape& shape, double angle) {
  if (shape.points == 1) return 0;
  const double step = bearing(shape, 0) - bearing(shape, 1);
  const auto ray = std::lround((bearing(shape, 0) - angle) / step);
  const bool circle = shape.field_of_view > 2 * kPi - kAngleSlack;
  if (circle) return static_cast<std::size_t>(ray % shape.points);
  return static_cast<std::size_t>(std::clamp<long>(ray, 0, shape.points - 1));
}

}  // namespace

LidarShape BoardLidar::shape() const {
  {
    const std::lock_guard lock(mutex_);
    if (shape_) return *shape_;
  }
  BoardScan scan;
  return link_.scan(scan) ? scan.shape : LidarShape{2 * kPi, 0.0, 1};
}

Result<void> BoardLidar::configure(double field_of_view, double tilt, int points) {
  BoardScan scan;
  if (auto there = link_.scan(scan); !there) return there;
  const LidarShape& board = scan.shape;
  return require(field_of_view > 0.0 && field_of_view <= board.field_of_view + kAngleSlack, kName,
                 field_of_view, "a field of view of more than 0, at most the board's")
      .and_then([&] {
        return require(std::abs(tilt - board.tilt) <= kAngleSlack, kName, tilt, "the board's tilt");
      })
      .and_then([&] {
        return require(points >= 1 && points <= board.points, kName, points,
                       "1 point, at most as many as the board has");
      })
      .map([&] {
        const std::lock_guard lock(mutex_);
        shape_ = LidarShape{field_of_view, tilt, points};
      });
}

Result<void> BoardLidar::read(std::span<double> ranges) {
  BoardScan scan;
  if (auto there = link_.scan(scan); !there) return there;
  const LidarShape wanted = [&] {
    const std::lock_guard lock(mutex_);
    return shape_.value_or(scan.shape);
  }();
  if (auto good = check_scan_size(ranges.size(), wanted.points); !good) return good;
  for (int i = 0; i < wanted.points; ++i) {
    ranges[static_cast<std::size_t>(i)] =
        std::min(scan.ranges[nearest_ray(scan.shape, bearing(wanted, i))], max_range());
  }
  return {};
}

}  // namespace eyebridge::hal
