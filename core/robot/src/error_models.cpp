#include "eyebridge/robot/error_models.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace eyebridge::robot {

GaussianError GaussianError::scaled(double share) const {
  return {bias * share, sigma * share, sigma_relative * share};
}

// A rounding cannot be done by half: it is there as soon as there is any error.
RangeError RangeError::scaled(double share) const {
  return {GaussianError::scaled(share), dropout * share, quantised && share > 0, cross_talk * share,
          sigma_quadratic * share};
}

LidarError LidarError::scaled(double share) const {
  return {GaussianError::scaled(share), dropout * share};
}

DriveError DriveError::scaled(double share) const {
  return {linear_sigma * share, angular_sigma * share,          left_scale * share,
          right_scale * share,  encoder_quantised && share > 0, slip * share,
          encoder_miss * share};
}

CameraError CameraError::scaled(double share) const {
  return {salt_and_pepper * share, sigma * share,         coloured * share, blur * share,
          exposure * share,        exposure_sigma * share};
}

RadioError RadioError::scaled(double share) const {
  return {loss * share, delay * share, jitter * share, corrupt * share,
          share > 0 ? range / share : 0.0};
}

RangeTable::RangeTable(const std::vector<double>& metres) {
  constexpr double kNothingSeen = 9.999;  // the 9999 mm of RoBIOS
  std::vector<double> levels;
  std::copy_if(metres.begin(), metres.end(), std::back_inserter(levels),
               [](double level) { return level > 0.0 && level < kNothingSeen; });
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  if (levels.empty()) return;
  levels_ = std::make_shared<const std::vector<double>>(std::move(levels));
}

double RangeTable::nearest(double range, double out_of_range) const {
  if (empty()) return range;
  const std::vector<double>& levels = *levels_;
  const auto above = std::lower_bound(levels.begin(), levels.end(), range);
  if (above == levels.end()) {
    const double last_step = levels.size() > 1 ? levels.back() - *std::prev(levels.end(), 2) : 0.0;
    return range > levels.back() + last_step / 2 ? out_of_range : levels.back();
  }
  if (above == levels.begin()) return *above;
  const double below = *std::prev(above);
  return range - below <= *above - range ? below : *above;
}

double RangeTable::upper_edge(double reading) const {
  const std::vector<double>& levels = *levels_;
  const auto above = std::upper_bound(levels.begin(), levels.end(), reading);
  if (above == levels.begin()) return -std::numeric_limits<double>::infinity();
  const double below = *std::prev(above);
  if (above != levels.end()) return below + (*above - below) / 2;
  const double last_step = levels.size() > 1 ? below - *std::prev(levels.end(), 2) : 0.0;
  return below + last_step / 2;
}

std::vector<double> RangeTable::levels() const {
  return empty() ? std::vector<double>{} : *levels_;
}

}  // namespace eyebridge::robot
