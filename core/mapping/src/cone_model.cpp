#include "eyebridge/mapping/cone_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "eyebridge/base/math.hpp"

namespace eyebridge::mapping {
namespace {

/// What one cell of a cone gets.
struct ConeCell {
  Cell cell;
  double weight;  ///< By bearing.
  double said;    ///< Probability along the range, before bearings count.
};

}  // namespace

double ConeModel::weight(double bearing) const {
  const double share = bearing / (0.5 * beam_width);
  return std::max(1.0 - share * share, 0.0);
}

void ConeModel::check() const {
  beam.check();
  if (!(beam_width > 0.0 && beam_width <= kPi)) {
    throw std::invalid_argument("cone model: the beam's width is not between 0 and pi");
  }
}

ConeModel cone_model_of(const robot::RangeSensorModel& sensor) {
  ConeModel model{beam_model_of(sensor), sensor.ultrasound.beam_width};
  const double heard = std::min(sensor.ultrasound.critical_angle / (kPi / 2), 1.0);
  model.beam.dropout = 1.0 - heard * (1.0 - model.beam.dropout);
  return model;
}

Result<void> insert_cone(OccupancyGrid& grid, const ConeModel& model, const Pose& sensor_in_world,
                         double range) {
  model.check();
  const Vec2 origin = sensor_in_world.position();
  if (!std::isfinite(origin.x) || !std::isfinite(origin.y) ||
      !std::isfinite(sensor_in_world.theta)) {
    return fail(Errc::OutOfRange, "a reading from a pose that is not finite");
  }
  if (!BeamModel::is_reading(range)) return {};
  const BeamModel& beam = model.beam;
  const double resolution = grid.geometry().resolution;
  const bool unmet = beam.is_out_of_range(range);
  const double reach =
      unmet ? beam.max_range
            : std::max(range - beam.bias, 0.0) + 3.0 * beam.sigma_at(range) + resolution;

  // The sector's corners, and where its arc crosses an axis of the world.
  const Heading axis = Heading::from_angle(sensor_in_world.theta);
  const double half = 0.5 * model.beam_width;
  Vec2 lower = origin;
  Vec2 upper = origin;
  const auto enclose = [&](Vec2 direction) {
    const Vec2 p = origin + reach * direction;
    lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
    upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
  };
  enclose(axis.turned(Heading::from_angle(half)).forward());
  enclose(axis.turned(Heading::from_angle(-half)).forward());
  const double least = sin_cos(half).cos;
  for (const Vec2 direction : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}}) {
    if (dot(direction, axis.forward()) >= least) enclose(direction);
  }
  if (auto covered = grid.cover(lower, upper); !covered) return covered;

  const GridGeometry& g = grid.geometry();
  const auto cut = [&](double place, double corner, int count) {
    const double cell = std::floor((place - corner) / g.resolution);
    return static_cast<int>(std::min(std::max(cell, -1.0), static_cast<double>(count)));
  };
  std::vector<ConeCell> cells;
  double total = 0.0;  // of the shares of those that may hold what was met
  const int top = std::min(cut(upper.y, g.origin.y, g.rows), g.rows - 1);
  const int right = std::min(cut(upper.x, g.origin.x, g.columns), g.columns - 1);
  for (int row = std::max(cut(lower.y, g.origin.y, g.rows), 0); row <= top; ++row) {
    for (int column = std::max(cut(lower.x, g.origin.x, g.columns), 0); column <= right; ++column) {
      const Vec2 away = g.centre_of({column, row}) - origin;
      const double distance = norm(away);
      if (distance > reach) continue;
      const double bearing = arc_tan2(cross(axis.forward(), away), dot(axis.forward(), away));
      const double weight = model.weight(bearing);
      if (weight <= 0.0) continue;
      const double said =
          beam.probability(range, distance - 0.5 * g.resolution, distance + 0.5 * g.resolution);
      if (said > 0.5) total += weight * (said - 0.5);
      cells.push_back({{column, row}, weight, said});
    }
  }
  // One echo is shared among the cells that it may come from: each of n alike gets 1 / n of it, but
  // a lone one no more than a beam would give it.
  const double met = beam.met - 0.5;
  for (const ConeCell& cell : cells) {
    const double off = cell.weight * (cell.said - 0.5);
    const double p = 0.5 + (off > 0.0 ? off * std::min(met / total, 1.0) : off);
    grid.add(cell.cell, static_cast<float>(log_odds_of(p)));
  }
  return {};
}

}  // namespace eyebridge::mapping
