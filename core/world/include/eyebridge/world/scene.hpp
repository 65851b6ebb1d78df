#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "eyebridge/base/colour.hpp"
#include "eyebridge/base/pose.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::world {

/// How a body looks to the camera and in pictures.
enum class BodyShape { Robot, Ball, Can, Polygon };

/// How an object of this kind looks.
BodyShape shape_of(ObjectKind kind);

/// One body at one moment.
struct BodyView {
  std::uint32_t id = 0;
  BodyShape shape = BodyShape::Robot;
  Pose pose;            ///< In the world.
  double radius = 0.0;  ///< Metres; of a polygon: of the disc that covers it.
  double height = 0.0;  ///< Metres.
  Rgb colour;
  /// Of a polygon, as corners_of() an object; else null.
  std::shared_ptr<const std::vector<Vec2>> corners{};
};

/// An object as it looks where it was placed, as body `id`.
BodyView view_of(const ObjectSpec& object, std::uint32_t id);

/// Distance from `p` to the rim of `body`, metres; less than 0, or 0, within it.
double rim_distance(const BodyView& body, Vec2 p);

/// A copy of what can be seen at one moment: cheap to take, read without locks.
struct Scene {
  std::shared_ptr<const WorldModel> model;  ///< Walls, floor, markers: never change while running.
  std::vector<BodyView> bodies;             ///< Robots and objects that are there; in order of id.
  double time = 0.0;                        ///< Seconds since start.
};

}  // namespace eyebridge::world
