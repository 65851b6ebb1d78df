#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "eyebridge/base/colour.hpp"
#include "eyebridge/base/pose.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::world {

/// How a body looks to the camera and in pictures.
enum class BodyShape { Robot, Ball, Can, Box };

/// How an object of this kind looks.
BodyShape shape_of(ObjectKind kind);

/// One body at one moment.
struct BodyView {
  std::uint32_t id = 0;
  BodyShape shape = BodyShape::Robot;
  Pose pose;            ///< In the world.
  double radius = 0.0;  ///< Metres; of a box: of the disc that covers it.
  double height = 0.0;  ///< Metres.
  Rgb colour;
  Vec2 size{};  ///< Of a box: length along its heading and width, metres.
};

/// A copy of what can be seen at one moment: cheap to take, read without locks.
struct Scene {
  std::shared_ptr<const WorldModel> model;  ///< Walls, floor, markers: never change while running.
  std::vector<BodyView> bodies;             ///< Robots and objects that are there; in order of id.
  double time = 0.0;                        ///< Seconds since start.
};

}  // namespace eyebridge::world
