#include "eyebridge/localisation/scan_matcher.hpp"

#include <algorithm>
#include <cmath>

namespace eyebridge::localisation {
namespace {

/// A distance between cells, and how it grows along x and y.
struct Slope {
  double value;
  Vec2 gradient;
};

/// Bilinear, between the centres of cells; nothing at the rim and beyond.
std::optional<Slope> interpolated(const mapping::Raster<float>& field, Vec2 point) {
  const mapping::GridGeometry& where = field.geometry;
  const double x = (point.x - where.origin.x) / where.resolution - 0.5;
  const double y = (point.y - where.origin.y) / where.resolution - 0.5;
  if (!(x >= 0.0 && y >= 0.0 && x < where.columns - 1 && y < where.rows - 1)) return std::nullopt;
  const auto column = static_cast<int>(x);
  const auto row = static_cast<int>(y);
  const double u = x - column;
  const double v = y - row;
  const double a = field[{column, row}];
  const double b = field[{column + 1, row}];
  const double c = field[{column, row + 1}];
  const double d = field[{column + 1, row + 1}];
  const double below = a + u * (b - a);
  const double above = c + u * (d - c);
  const double along_x = (b - a) + v * ((d - c) - (b - a));
  return Slope{below + v * (above - below),
               {along_x / where.resolution, (above - below) / where.resolution}};
}

/// Sums over the hits of a scan at one pose.
struct Fit {
  Matrix3 information;  ///< Of the pose, for residuals of variance 1.
  Vector3 pull;         ///< Right side of the normal equations.
  double score = 0.0;   ///< Sum of the weights.
  double squares = 0.0;
};

Fit fit_of(const mapping::Raster<float>& distances, const Pose& pose, const Scan& scan,
           double sigma) {
  Fit fit;
  const Heading heading = Heading::from_angle(pose.theta);
  for (const Vec2 hit : scan.hits) {
    const Vec2 arm = heading.rotate(hit);
    const auto slope = interpolated(distances, pose.position() + arm);
    if (!slope || !std::isfinite(slope->value)) continue;
    const double z = slope->value / sigma;
    const double weight = exp_of(-0.5 * z * z);  // Welsch's: what does not fit has no say
    const Vector3 by_pose{{slope->gradient.x, slope->gradient.y, cross(arm, slope->gradient)}};
    fit.information = fit.information + weight * (by_pose * transposed(by_pose));
    fit.pull = fit.pull - (weight * slope->value) * by_pose;
    fit.score += weight;
    fit.squares += weight * slope->value * slope->value;
  }
  return fit;
}

Pose moved(const Pose& pose, const Vector3& by) {
  return {pose.x + by(0, 0), pose.y + by(1, 0), wrap_angle(pose.theta + by(2, 0))};
}

}  // namespace

ScanMatch ScanMatcher::refined(const Pose& pose, const Scan& scan) const {
  ScanMatch out;
  out.estimate.pose = pose;
  const double cell = distances_.geometry.resolution;
  const Matrix3 prior = diagonal<3>({1.0 / (settings_.window * settings_.window),
                                     1.0 / (settings_.window * settings_.window),
                                     1.0 / (settings_.turn_window * settings_.turn_window)});
  // The edge of a wall is anywhere in its cell.
  const double least_variance = cell * cell / 12.0;
  const auto variance_of = [&](const Fit& fit) {
    const double free = std::max(fit.score - 3.0, 1.0);
    return std::max(fit.squares / free, least_variance);
  };
  Fit fit = fit_of(distances_, pose, scan, settings_.sigma);
  for (int round = 0; round < settings_.rounds; ++round) {
    // As if the window were a sight of its own: what hits do not settle stays where it is.
    const auto inverse = inverse_of(fit.information + variance_of(fit) * prior);
    if (!inverse) break;
    const Vector3 step = *inverse * fit.pull;
    const Pose next = moved(out.estimate.pose, step);
    const Fit there = fit_of(distances_, next, scan, settings_.sigma);
    if (!(there.score > fit.score)) break;
    out.estimate.pose = next;
    fit = there;
    constexpr double kSettled = 1e-6;  // metres, radians
    if (std::abs(step(0, 0)) + std::abs(step(1, 0)) + std::abs(step(2, 0)) < kSettled) break;
  }
  const Matrix3 information = (1.0 / variance_of(fit)) * fit.information + prior;
  out.estimate.covariance =
      inverse_of(information)
          .value_or(diagonal<3>({1.0 / prior(0, 0), 1.0 / prior(1, 1), 1.0 / prior(2, 2)}));
  if (!scan.hits.empty()) out.score = fit.score / static_cast<double>(scan.hits.size());
  return out;
}

std::optional<ScanMatch> ScanMatcher::match(const Pose& guess, const Scan& scan) const {
  if (scan.hits.empty()) return std::nullopt;
  const ScanMatch found = refined(search(guess, scan), scan);
  if (found.score < settings_.least_score) return std::nullopt;
  return found;
}

}  // namespace eyebridge::localisation
