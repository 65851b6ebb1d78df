#include "eyebridge/robot/sensor_likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "eyebridge/base/normal.hpp"
#include "sensing.hpp"

namespace eyebridge::robot {
namespace {

constexpr double kWholeTurn = 2 * kPi;
constexpr double kNoMore = 9.0;    // standard deviations: 1e-19 is left
constexpr double kMostTurns = 64;  // so far out, a heading is anywhere
constexpr double kEndless = std::numeric_limits<double>::infinity();

double sigma_of(const GaussianError& error, double value) {
  return error.sigma + error.sigma_relative * std::abs(value);
}

double gauss(double x, double mean, double sigma) {
  return normal_density((x - mean) / sigma) / sigma;
}

double gauss_below(double x, double mean, double sigma) { return normal_below((x - mean) / sigma); }

/// `sum(k)` for all whole turns k by which `sigma` may throw a heading round.
template <class Sum>
void each_turn(double sigma, Sum&& sum) {
  const double wanted = std::ceil(kNoMore * sigma / kWholeTurn) + 1;
  const int most = static_cast<int>(wanted < kMostTurns ? wanted : kMostTurns);
  for (int k = -most; k <= most; ++k) sum(kWholeTurn * k);
}

}  // namespace

NormalReadings::NormalReadings(const GyroscopeError& error, double rate, double elapsed)
    : mean_(rate + error.bias) {
  const double sigma = sigma_of(error, rate);
  sigma_ = std::sqrt(sigma * sigma + error.drift * error.drift * elapsed);
}

NormalReadings::NormalReadings(const AccelerometerError& error, double acceleration)
    : mean_(acceleration + error.bias), sigma_(sigma_of(error, acceleration)) {}

double NormalReadings::density(double reading) const {
  return sigma_ > 0.0 ? gauss(reading, mean_, sigma_) : 0.0;
}

double NormalReadings::mass(double reading) const {
  return sigma_ == 0.0 && reading == mean_ ? 1.0 : 0.0;
}

double NormalReadings::at_most(double reading) const {
  if (sigma_ == 0.0) return reading >= mean_ ? 1.0 : 0.0;
  return gauss_below(reading, mean_, sigma_);
}

double NormalReadings::probability(double reading, double resolution) const {
  return at_most(reading + resolution / 2) - at_most(reading - resolution / 2);
}

HeadingReadings::HeadingReadings(const CompassError& error, double heading) {
  const double truth = wrap_angle(heading);
  sigma_ = sigma_of(error, truth);
  mean_ = error.perfect() ? truth : wrap_angle(truth + error.bias);
}

double HeadingReadings::density(double reading) const {
  if (sigma_ == 0.0) return 0.0;
  double sum = 0.0;
  each_turn(sigma_, [&](double turns) { sum += gauss(reading + turns, mean_, sigma_); });
  return sum;
}

double HeadingReadings::mass(double reading) const {
  return sigma_ == 0.0 && reading == mean_ ? 1.0 : 0.0;
}

double HeadingReadings::probability(double reading, double resolution) const {
  const double half = resolution / 2;
  if (sigma_ == 0.0) {
    const double away = wrap_angle(mean_ - reading);
    return away > -half && away <= half ? 1.0 : 0.0;
  }
  const double first = wrap_angle(reading - mean_) - half;
  double sum = 0.0;
  each_turn(sigma_, [&](double turns) {
    sum += gauss_below(first + resolution + turns, 0.0, sigma_) -
           gauss_below(first + turns, 0.0, sigma_);
  });
  return sum;
}

RangeReadings::RangeReadings(const RangeSensorModel& model, double distance, unsigned cross_talkers)
    : max_range_(model.max_range),
      listens_from_(model.min_range),
      cross_talk_(model.error.cross_talk),
      cross_talkers_(model.kind == RangeKind::Ultrasound ? cross_talkers : 0),
      dropout_(model.error.dropout),
      out_of_range_(model.out_of_range) {
  const double range = model.kind == RangeKind::Infrared ? folded_range(distance, model) : distance;
  met_ = range >= model.min_range && range < model.max_range;
  mean_ = range + model.error.bias;
  sigma_ = met_ ? model.error.sigma_at(range) : 0.0;
  if (model.error.quantised) table_ = model.table;
}

RangeReadings::RangeReadings(const LidarModel& model, double distance)
    : met_(distance < model.max_range),
      mean_(distance + model.error.bias),
      sigma_(met_ ? sigma_of(model.error, distance) : 0.0),
      max_range_(model.max_range),
      dropout_(model.error.dropout),
      out_of_range_(model.max_range) {}

/// Probability that the sensor's own echo comes from at most `range`.
double RangeReadings::echo_by(double range) const {
  if (!met_ || range < 0.0) return 0.0;
  if (range >= max_range_) return 1.0;
  if (sigma_ == 0.0) return range >= mean_ ? 1.0 : 0.0;
  return gauss_below(range, mean_, sigma_);
}

/// Probability that no foreign pulse comes in before an echo from `range` would.
double RangeReadings::unheard_by(double range) const {
  const double until = std::min(range, max_range_);
  if (cross_talkers_ == 0 || until <= listens_from_) return 1.0;
  const double one = 1.0 - cross_talk_ * (until - listens_from_) / max_range_;
  double all = 1.0;
  for (unsigned i = 0; i < cross_talkers_; ++i) all *= one;
  return all;
}

/// Probability that what the sensor heard first says `range` or less.
double RangeReadings::before_rounding(double range) const {
  return 1.0 - (1.0 - echo_by(range)) * unheard_by(range);
}

/// The same of what it then says, if it is not lost.
double RangeReadings::in_range(double reading) const {
  return before_rounding(table_.empty() ? reading : table_.upper_edge(reading));
}

/// Probability of the entry `reading` of the table; 0 of what is none.
double RangeReadings::rounded_to(double reading) const {
  const double edge = table_.upper_edge(reading);
  const double edge_before = table_.upper_edge(std::nextafter(reading, -kEndless));
  return before_rounding(edge) - before_rounding(edge_before);
}

double RangeReadings::density(double reading) const {
  if (!table_.empty() || reading <= 0.0 || reading >= max_range_) return 0.0;
  const double echo = met_ && sigma_ > 0.0 ? gauss(reading, mean_, sigma_) : 0.0;
  const double unheard = unheard_by(reading);
  double sum = echo * unheard;
  if (cross_talkers_ > 0 && reading >= listens_from_) {
    const double one = 1.0 - cross_talk_ * (reading - listens_from_) / max_range_;
    const double foreign = cross_talk_ / max_range_ * cross_talkers_ *
                           (one > 0.0 ? unheard / one : (cross_talkers_ == 1 ? 1.0 : 0.0));
    sum += foreign * (1.0 - echo_by(reading));
  }
  return (1.0 - dropout_) * sum;
}

double RangeReadings::mass(double reading) const {
  double sum = 0.0;
  if (!table_.empty()) {
    sum = rounded_to(reading);
  } else if (met_ && sigma_ == 0.0) {
    if (reading == std::clamp(mean_, 0.0, max_range_)) sum = unheard_by(reading);
  } else if (met_ && reading == 0.0) {
    sum = gauss_below(0.0, mean_, sigma_);
  } else if (met_ && reading == max_range_) {
    sum = gauss_below(mean_, max_range_, sigma_) * unheard_by(max_range_);
  }
  sum *= 1.0 - dropout_;
  if (reading == out_of_range_) sum += 1.0 - (1.0 - dropout_) * in_range(kEndless);
  return sum;
}

double RangeReadings::at_most(double reading) const {
  const double seen = (1.0 - dropout_) * in_range(reading);
  const double lost = 1.0 - (1.0 - dropout_) * in_range(kEndless);
  return reading >= out_of_range_ ? seen + lost : seen;
}

double RangeReadings::probability(double reading, double resolution) const {
  return at_most(reading + resolution / 2) - at_most(reading - resolution / 2);
}

}  // namespace eyebridge::robot
