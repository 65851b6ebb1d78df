#pragma once

#include <span>
#include <vector>

#include "eyebridge/base/colour.hpp"
#include "eyebridge/base/pose.hpp"
#include "eyebridge/camera/frame.hpp"
#include "eyebridge/world/scene.hpp"

namespace eyebridge::camera {

/// Where a robot has been.
struct Trail {
  Rgb colour;
  std::vector<Vec2> points;  ///< World, metres.
};

/// How to draw a world from above.
struct BirdseyeOptions {
  int longest_side = 1000;  ///< Of the picture, pixels, border included.
};

/// The world seen from above, north up: floor, walls, markers, bodies with their headings, start
/// poses, trails. Rgb24.
Frame draw_birdseye(const world::Scene& scene, std::span<const Trail> trails,
                    const BirdseyeOptions& options = {});

}  // namespace eyebridge::camera
