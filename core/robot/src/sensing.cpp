#include "sensing.hpp"

#include <algorithm>
#include <cmath>

#include "errors.hpp"
#include "eyebridge/base/math.hpp"

namespace eyebridge::robot {
namespace {

constexpr double kTurn = 2 * kPi;
// Sectors are written in whole degrees; their ends must not depend on the last bit.
constexpr double kBearingSlack = 1e-9;

double to_full_turn(double angle) {  // into [0, 2 pi)
  const double wrapped = wrap_angle(angle);
  return wrapped < 0.0 ? wrapped + kTurn : wrapped;
}

}  // namespace

bool in_sector(double bearing, double start, double end) {
  if (end - start >= kTurn - kBearingSlack) return true;
  const double from_start = to_full_turn(bearing - start);
  return from_start <= to_full_turn(end - start) + kBearingSlack ||
         from_start >= kTurn - kBearingSlack;
}

ScanShape::ScanShape(double given_field_of_view, std::size_t points)
    : field_of_view(given_field_of_view), directions(points) {
  const bool full_circle = field_of_view >= kTurn - kBearingSlack;
  const double gaps =
      static_cast<double>(full_circle ? points : std::max<std::size_t>(points, 2) - 1);
  gap = field_of_view <= kTurn + kBearingSlack ? -field_of_view / gaps : 0.0;
  for (std::size_t i = 0; i < points; ++i) {
    const double bearing = field_of_view / 2 - static_cast<double>(i) * field_of_view / gaps;
    const bool single = points == 1 && !full_circle;
    directions[i] = Heading::from_angle(single ? 0.0 : bearing).forward();
  }
}

const ScanShape& ScanShapes::of(double field_of_view, std::size_t points) {
  const auto found = std::find_if(shapes_.begin(), shapes_.end(), [&](const ScanShape& shape) {
    return shape.field_of_view == field_of_view && shape.directions.size() == points;
  });
  if (found != shapes_.end()) {
    if (found != shapes_.begin()) std::rotate(shapes_.begin(), found, found + 1);
    return shapes_.front();
  }
  if (shapes_.size() == kMost) shapes_.pop_back();
  return *shapes_.emplace(shapes_.begin(), field_of_view, points);
}

namespace {

bool in_reach(double range, const RangeSensorModel& model) {
  return range >= model.min_range && range < model.max_range;
}

}  // namespace

double range_reading(double range, const RangeSensorModel& model, Random& random,
                     unsigned cross_talkers) {
  const bool met = in_reach(range, model);
  if (!met && cross_talkers == 0) return model.out_of_range;
  const RangeError& error = model.error;
  if (error.perfect()) return range;
  bool heard = met;
  double reading = model.max_range;
  if (met) {
    const GaussianError by_now{error.bias, error.sigma_at(range), 0.0};
    reading = std::clamp(with_error(range, by_now, random), 0.0, model.max_range);
  }
  for (unsigned i = 0; i < cross_talkers; ++i) {
    if (!random.chance(error.cross_talk)) continue;
    const double foreign = random.uniform() * model.max_range;
    if (foreign < model.min_range) continue;
    reading = std::min(reading, foreign);
    heard = true;
  }
  if (!heard) return model.out_of_range;
  if (error.quantised) reading = model.table.nearest(reading, model.out_of_range);
  return error.dropout > 0.0 && random.chance(error.dropout) ? model.out_of_range : reading;
}

double range_reading(double range, const RangeSensorModel& model) {
  return in_reach(range, model) ? range : model.out_of_range;
}

SlantedBeam::SlantedBeam(const LidarModel& model, double tilt)
    : max_range_(model.max_range), level_reach_(model.max_range), miss_(model.max_range) {
  const SinCos slant = sin_cos(tilt);
  cosine_ = std::max(slant.cos, 0.0);  // straight down, rounding may put it below 0
  level_reach_ = max_range_ * cosine_;
  if (slant.sin > 0.0 && model.height < max_range_ * slant.sin) {
    miss_ = model.height / slant.sin;
    level_reach_ = miss_ * cosine_;
  }
}

double SlantedBeam::range(double level) const {
  return level >= level_reach_ ? miss_ : level / cosine_;
}

}  // namespace eyebridge::robot
