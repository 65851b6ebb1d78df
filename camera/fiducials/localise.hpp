#pragma once

#include <functional>
#include <span>

#include "fiducials/pose_fit.hpp"
#include "fiducials/vision.hpp"

namespace eyebridge::camera {

/// A pose found from one picture alone, and by which sightings.
struct Localised {
  PoseFit fit;
  std::vector<Sighting> inliers;
};

/// What is known beforehand of any camera: held about upright, over the floor. With `last`, where
/// it was seen last, its height and tilt are taken to have stayed.
PosePrior upright_prior(const EyePose* last);

/// Whether a camera can be held so: above the floor, below 3 m, tilted by less than 60 degrees.
bool is_plausible(const EyePose& pose);

/// The sightings of `all` that a camera at `pose` sees within `tolerance` pixels.
std::vector<Sighting> inliers_of(std::span<const Sighting> all, const Calibration& lens,
                                 const EyePose& pose, double tolerance);

/// Finds the pose that most sightings agree on: each in turn proposes the one or two poses that its
/// square alone allows (as RANSAC, with all samples instead of random ones), the best is fitted to
/// all that agree. None when nothing agrees with itself, or when a single sighting leaves two
/// different poses that are about as good; then `last`, the last pose known, decides if it is
/// given.
std::optional<Localised> localise(std::span<const Sighting> sightings, const Calibration& lens,
                                  const EyePose* last, const Vision& vision);

}  // namespace eyebridge::camera
