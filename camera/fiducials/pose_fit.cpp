#include "fiducials/pose_fit.hpp"

#include <cmath>
#include <limits>

namespace eyebridge::camera {
namespace {

constexpr int kMostSteps = 12;
/// Misses beyond so many deviations count linearly.
constexpr double kHuber = 2.5;

/// The normal equations of one Gauss-Newton step.
struct Normal {
  Matrix<6, 6> information;
  Vector<6> gradient{};
  double cost = 0.0;

  void add(const Projection& seen, Vec2 pixel) {
    const Vec2 error = pixel - seen.pixel;
    const double deviations = norm(error) / kCornerDeviation;
    const bool far = deviations > kHuber;
    const double weight = (far ? kHuber / deviations : 1.0) / (kCornerDeviation * kCornerDeviation);
    cost += far ? kHuber * (2.0 * deviations - kHuber) : deviations * deviations;
    for (std::size_t i = 0; i < 6; ++i) {
      const Vec2 by_i{seen.jacobian(0, i), seen.jacobian(1, i)};
      gradient[i] += weight * dot(by_i, error);
      for (std::size_t j = 0; j < 6; ++j) {
        information(i, j) += weight * dot(by_i, {seen.jacobian(0, j), seen.jacobian(1, j)});
      }
    }
  }
};

std::optional<Normal> normal_at(std::span<const Sighting> sightings, const Calibration& lens,
                                const PosePrior& prior, const EyePose& pose) {
  Normal normal;
  for (const Sighting& sighting : sightings) {
    for (std::size_t i = 0; i < 4; ++i) {
      const std::optional<Projection> seen = project(pose, lens, sighting.corners[i]);
      if (!seen) return std::nullopt;
      normal.add(*seen, sighting.pixels[i]);
    }
  }
  const Vector<6> off = difference(prior.mean, pose);
  const Vector<6> pull = prior.information * off;
  for (std::size_t i = 0; i < 6; ++i) {
    normal.gradient[i] += pull[i];
    normal.cost += off[i] * pull[i];
  }
  normal.information = normal.information + prior.information;
  return normal;
}

}  // namespace

std::optional<PoseFit> fit_pose(std::span<const Sighting> sightings, const Calibration& lens,
                                const PosePrior& prior, const EyePose& start) {
  EyePose pose = start;
  std::optional<Normal> normal = normal_at(sightings, lens, prior, pose);
  for (int i = 0; normal && i < kMostSteps; ++i) {
    const auto covariance = inverse_of(normal->information, kNearlySingular);
    if (!covariance) return std::nullopt;
    Vector<6> step = *covariance * normal->gradient;
    double length = 0.0;
    for (const double value : step) length += value * value;
    if (!std::isfinite(length)) return std::nullopt;
    if (length < 1e-12) return PoseFit{pose, *covariance, normal->cost};
    // A step that makes it worse is halved: the projection bends most close to the fiducial.
    std::optional<Normal> next;
    for (int halving = 0; halving < 6; ++halving) {
      next = normal_at(sightings, lens, prior, moved(pose, step));
      if (next && next->cost <= normal->cost + 1e-9) break;
      next.reset();
      for (double& value : step) value *= 0.5;
    }
    if (!next) return PoseFit{pose, *covariance, normal->cost};
    pose = moved(pose, step);
    normal = next;
  }
  if (!normal) return std::nullopt;
  const auto covariance = inverse_of(normal->information, kNearlySingular);
  if (!covariance) return std::nullopt;
  return PoseFit{pose, *covariance, normal->cost};
}

double miss(const Sighting& sighting, const Calibration& lens, const EyePose& pose) {
  double squares = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::optional<Projection> seen = project(pose, lens, sighting.corners[i]);
    if (!seen) return std::numeric_limits<double>::infinity();
    squares += norm_squared(seen->pixel - sighting.pixels[i]);
  }
  return std::sqrt(squares / 4.0);
}

}  // namespace eyebridge::camera
