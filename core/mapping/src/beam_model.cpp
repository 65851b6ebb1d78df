#include "eyebridge/mapping/beam_model.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>

#include "beam_table.hpp"
#include "eyebridge/base/math.hpp"
#include "eyebridge/base/normal.hpp"

namespace eyebridge::mapping {
namespace {

constexpr double kEven = 0.5;
constexpr double kLeastBlur = 0.01;  // of a cell: see BeamModel::probability()

void require(bool good, const char* what) {
  if (!good) throw std::invalid_argument(std::string("beam model: ") + what);
}

bool is_share(double value) { return value >= 0.0 && value <= 1.0; }

}  // namespace

double blurred_probability(const BeamModel& model, double near, double far, double sigma) {
  const double before = normal_below(near / sigma);
  const double up_to = normal_below(far / sigma);
  return (up_to - before) * model.met + before * kEven + (1.0 - up_to) * model.crossed;
}

double folded_probability(const BeamModel& model, double depth) {
  if (!(model.min_range > 0.0)) return kEven;
  const double within = std::min(depth / model.min_range, 1.0);
  return within * model.met + (1.0 - within) * 0.5 * (kEven + model.crossed);
}

double mixed_probability(const BeamModel& model, double said, double hidden) {
  return (1.0 - model.fold) * said + model.fold * hidden;
}

double BeamModel::sigma_at(double range) const {
  const double noise = sigma + sigma_relative * std::abs(range) + sigma_quadratic * range * range;
  if (levels.size() < 2) return noise;
  // A reading stands for all that is rounded to it: evenly spread over the gap between the middles
  // to its neighbours, of which the standard deviation is the width / sqrt(12).
  const auto above = std::upper_bound(levels.begin(), levels.end(), range);
  const auto high = above == levels.end() ? std::prev(above)
                                          : (above == levels.begin() ? std::next(above) : above);
  const double gap = *high - *std::prev(high);
  return std::sqrt(noise * noise + gap * gap / 12.0);
}

double BeamModel::probability(double range, double near, double far) const {
  if (!is_reading(range)) return kEven;
  const bool is_near = 0.5 * (near + far) < min_range;
  if (is_out_of_range(range)) return is_near ? kEven : probability_out_of_range();
  const double place = range - bias;
  const double blur = std::max(sigma_at(range), kLeastBlur * (far - near));
  const double said = blurred_probability(*this, near - place, far - place, blur);
  return mixed_probability(*this, said, is_near ? folded_probability(*this, far - near) : kEven);
}

double BeamModel::probability_out_of_range() const {
  // Bayes: of the readings out of range, the share that is none of those that dropped out.
  const double told = empty_share / (empty_share + (1.0 - empty_share) * dropout);
  return told * crossed + (1.0 - told) * kEven;
}

void BeamModel::check() const {
  require(max_range > 0.0 && std::isfinite(max_range), "the reach is not a positive length");
  require(min_range >= 0.0 && min_range < max_range, "the least range is not 0 to the reach");
  require(!std::isnan(out_of_range), "the reading out of range is no number");
  require(std::isfinite(bias), "the bias is not finite");
  require(sigma >= 0.0 && std::isfinite(sigma), "sigma is no length");
  require(sigma_relative >= 0.0 && std::isfinite(sigma_relative), "sigma_relative is negative");
  require(sigma_quadratic >= 0.0 && std::isfinite(sigma_quadratic), "sigma_quadratic is negative");
  require(std::all_of(levels.begin(), levels.end(), [](double v) { return std::isfinite(v); }),
          "a level is not finite");
  require(std::is_sorted(levels.begin(), levels.end()), "the levels do not ascend");
  require(is_share(dropout), "dropout is not 0 to 1");
  require(is_share(fold), "fold is not 0 to 1");
  require(crossed > 0.0 && crossed < kEven, "crossed is not between 0 and 1/2");
  require(met > kEven && met < 1.0, "met is not between 1/2 and 1");
  require(empty_share > 0.0 && empty_share < 1.0, "empty_share is not between 0 and 1");
}

BeamModel beam_model_of(const robot::RangeSensorModel& sensor) {
  BeamModel model;
  model.min_range = sensor.min_range;
  model.max_range = sensor.max_range;
  model.out_of_range = sensor.out_of_range;
  model.bias = sensor.error.bias;
  model.sigma = sensor.error.sigma;
  model.sigma_relative = sensor.error.sigma_relative;
  model.sigma_quadratic = sensor.error.sigma_quadratic;
  model.dropout = sensor.error.dropout;
  if (sensor.error.quantised) model.levels = sensor.table.levels();
  if (sensor.kind == robot::RangeKind::Infrared) {
    // Things are as likely at any distance: so many of them are too near, and read as far ones.
    model.fold = model.min_range / model.max_range;
  }
  return model;
}

BeamModel beam_model_of(const robot::LidarModel& lidar) {
  const SinCos slant = sin_cos(lidar.tilt);
  BeamModel model;
  double reach = lidar.max_range;
  if (slant.sin > 0.0) {
    // Three standard deviations before the floor, a reading may be of the floor already.
    const double floor = lidar.height / slant.sin;
    const double blur = lidar.error.sigma + lidar.error.sigma_relative * floor;
    reach = std::min(reach, std::max(floor - 3.0 * blur, 0.1 * floor));
  }
  model.max_range = reach * std::max(slant.cos, 1e-3);
  model.out_of_range = model.max_range;
  model.bias = lidar.error.bias * slant.cos;
  model.sigma = lidar.error.sigma * slant.cos;
  model.sigma_relative = lidar.error.sigma_relative;
  model.dropout = lidar.error.dropout;
  return model;
}

double level_range(const robot::LidarModel& lidar, double range) {
  return range * std::max(sin_cos(lidar.tilt).cos, 0.0);
}

}  // namespace eyebridge::mapping
