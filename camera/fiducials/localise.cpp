#include "fiducials/localise.hpp"

#include <algorithm>
#include <cmath>

#include "eyebridge/base/units.hpp"
#include "optics/lens_distortion.hpp"

namespace eyebridge::camera {
namespace {

/// A fit to one sighting says little about others far off: what the first look lets pass, pixels.
constexpr double kLooseTolerance = 15.0;
constexpr double kTightTolerance = 2.5;
/// Two poses whose costs differ by less may be taken for each other: a chance of about 1 in 100.
constexpr double kAmbiguousCost = 9.0;

std::vector<EyePose> proposals(const Sighting& sighting, const Calibration& lens,
                               const Vision& vision) {
  Corners corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = to_plane(lens, sighting.pixels[i]);
  const auto& [top_left, top_right, bottom_right, bottom_left] = sighting.corners;
  const auto minus = [](Vec3 a, Vec3 b) { return Vec3{a.x - b.x, a.y - b.y, a.z - b.z}; };
  const Vec3 edge = minus(top_right, top_left);
  const double size = std::sqrt(dot(edge, edge));
  const Vec3 right{edge.x / size, edge.y / size, 0.0};
  // Right, up and towards the viewer; fiducials hang upright.
  const Vec3 out{right.y, -right.x, 0.0};
  const auto turned = [&](Vec3 v) {
    return Vec3{v.x * right.x + v.z * out.x, v.x * right.y + v.z * out.y, v.y};
  };
  std::vector<EyePose> poses;
  for (const SquarePose& square : vision.square_poses(corners, size)) {
    const Vec3 off = turned(square.position);
    const Vec3 at{0.5 * (top_left.x + bottom_right.x) + off.x,
                  0.5 * (top_left.y + bottom_right.y) + off.y,
                  0.5 * (top_left.z + bottom_right.z) + off.z};
    poses.push_back(eye_pose(at, turned(square.right), turned(square.forward)));
  }
  return poses;
}

/// `start` fitted to what agrees with it, twice, each time more strictly.
std::optional<Localised> settle(std::span<const Sighting> sightings, const Calibration& lens,
                                const PosePrior& upright, const EyePose& start) {
  PosePrior prior = upright;
  for (const std::size_t free : {kX, kY, kHeading}) prior.mean.values[free] = start.values[free];
  Localised found;
  found.fit.pose = start;
  for (const double tolerance : {kLooseTolerance, kTightTolerance}) {
    found.inliers = inliers_of(sightings, lens, found.fit.pose, tolerance);
    if (found.inliers.empty()) return std::nullopt;
    const auto fit = fit_pose(found.inliers, lens, prior, found.fit.pose);
    if (!fit) return std::nullopt;
    found.fit = *fit;
  }
  found.inliers = inliers_of(found.inliers, lens, found.fit.pose, kTightTolerance);
  if (found.inliers.empty() || !is_plausible(found.fit.pose)) return std::nullopt;
  return found;
}

bool are_alike(const EyePose& a, const EyePose& b) {
  const Vector<6> d = difference(a, b);
  return std::sqrt(d[kX] * d[kX] + d[kY] * d[kY]) < 0.05 && std::abs(d[kHeading]) < deg_to_rad(5.0);
}

double distance(const EyePose& a, const EyePose& b) {
  const Vector<6> d = difference(a, b);
  const double turn = 0.3 * d[kHeading];
  return std::sqrt(d[kX] * d[kX] + d[kY] * d[kY] + turn * turn);
}

}  // namespace

PosePrior upright_prior(const EyePose* last) {
  // Standard deviations; 0 says nothing.
  Vector<6> deviation{0.0, 0.0, 0.3, 0.0, deg_to_rad(20.0), deg_to_rad(10.0)};
  PosePrior prior;
  prior.mean.values[kZ] = 0.2;
  if (last != nullptr) {
    prior.mean = *last;
    deviation = {0.0, 0.0, 0.05, 0.0, deg_to_rad(8.0), deg_to_rad(8.0)};
  }
  for (std::size_t i = 0; i < 6; ++i) {
    prior.information(i, i) = deviation[i] > 0.0 ? 1.0 / (deviation[i] * deviation[i]) : 0.0;
  }
  return prior;
}

bool is_plausible(const EyePose& pose) {
  const double most = deg_to_rad(60.0);
  return pose.values[kZ] > 0.0 && pose.values[kZ] < 3.0 && std::abs(pose.values[kPitch]) < most &&
         std::abs(pose.values[kRoll]) < most;
}

std::vector<Sighting> inliers_of(std::span<const Sighting> all, const Calibration& lens,
                                 const EyePose& pose, double tolerance) {
  std::vector<Sighting> inliers;
  for (const Sighting& sighting : all) {
    if (miss(sighting, lens, pose) <= tolerance) inliers.push_back(sighting);
  }
  return inliers;
}

std::optional<Localised> localise(std::span<const Sighting> sightings, const Calibration& lens,
                                  const EyePose* last, const Vision& vision) {
  const PosePrior upright = upright_prior(last);
  std::vector<Localised> found;
  for (const Sighting& sighting : sightings) {
    for (const EyePose& start : proposals(sighting, lens, vision)) {
      auto candidate = settle(sightings, lens, upright, start);
      if (candidate) found.push_back(std::move(*candidate));
    }
  }
  if (found.empty()) return std::nullopt;
  std::sort(found.begin(), found.end(), [](const Localised& a, const Localised& b) {
    if (a.inliers.size() != b.inliers.size()) return a.inliers.size() > b.inliers.size();
    return a.fit.cost < b.fit.cost;
  });
  // The second best by as many, if it is somewhere else.
  const auto rival = std::find_if(found.begin() + 1, found.end(), [&](const Localised& other) {
    return other.inliers.size() == found[0].inliers.size() &&
           other.fit.cost < found[0].fit.cost + kAmbiguousCost &&
           !are_alike(other.fit.pose, found[0].fit.pose);
  });
  if (rival == found.end()) return found[0];
  if (last == nullptr) return std::nullopt;
  return distance(rival->fit.pose, *last) < distance(found[0].fit.pose, *last) ? *rival : found[0];
}

}  // namespace eyebridge::camera
