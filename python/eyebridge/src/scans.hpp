#pragma once

#include <cmath>
#include <stdexcept>
#include <tuple>

#include <pybind11/numpy.h>

#include "arrays.hpp"
#include "checks.hpp"
#include "eyebridge/localisation/scan.hpp"

namespace eyebridge::python {

/// x, y, theta, as Python has poses.
using Place = std::tuple<double, double, double>;

/// Raises ValueError for what is not finite.
inline Pose pose_from(const Place& place) {
  const auto [x, y, theta] = place;
  for (const double value : {x, y, theta}) need_finite("pose", value);
  return {x, y, theta};
}

inline Place place_of(const Pose& pose) { return {pose.x, pose.y, pose.theta}; }

/// What a scanner in the middle of the robot saw: `ranges` along `bearings`. What met nothing reads
/// as `max_range`, give or take rounding: a miss. Raises ValueError unless there are as many of
/// both.
inline localisation::Scan scan_from(const Numbers& ranges, const Numbers& bearings,
                                    double max_range) {
  if (!(max_range > 0 && std::isfinite(max_range))) refuse("max_range", max_range, "more than 0 m");
  if (ranges.ndim() != 1 || bearings.ndim() != 1 || ranges.size() != bearings.size()) {
    throw std::invalid_argument("expected as many bearings as ranges");
  }
  localisation::Scan scan;
  for (pybind11::ssize_t i = 0; i < ranges.size(); ++i) {
    const double range = ranges.at(i);
    if (!(range > 0)) continue;
    need_finite("bearings", bearings.at(i));
    const Vec2 direction = Heading::from_angle(bearings.at(i)).forward();
    if (range < max_range * (1 - 1e-6)) {
      scan.hits.push_back(range * direction);
    } else {
      scan.misses.push_back(max_range * direction);
    }
  }
  return scan;
}

}  // namespace eyebridge::python
