#pragma once

#include <cstdint>
#include <string>

#include "eyebridge/robot/error_models.hpp"
#include "eyebridge/world/scene.hpp"

namespace eyebridge::camera {

/// A pinhole in the world, its optical axis and its opening.
struct Eye {
  double x = 0.0;  ///< World, metres.
  double y = 0.0;
  double z = 0.06;       ///< Above the floor, metres.
  double heading = 0.0;  ///< Of the optical axis, radians counter-clockwise from +x.
  double pitch = 0.0;    ///< Of the optical axis, radians, up positive.
  double horizontal_field_of_view = 1.0471975511965976;  ///< Radians; pixels are square.
};

/// What is wrong with a camera's pictures.
struct ImageNoise {
  robot::CameraError error;
  std::uint64_t seed = 1;  ///< Of this camera alone; each picture makes a stream of it.
};

/// What a rendered camera looks at: implemented by a simulated robot. Any thread.
class View {
 public:
  virtual ~View() = default;

  /// The world as it is now.
  [[nodiscard]] virtual world::Scene scene() const = 0;
  /// Where the robot's camera is now, pan and tilt included.
  [[nodiscard]] virtual Eye eye() const = 0;
  /// The body that carries the camera: not drawn.
  [[nodiscard]] virtual std::uint32_t carrier() const = 0;
  [[nodiscard]] virtual ImageNoise noise() const = 0;
  /// Folder that relative texture names are searched in.
  [[nodiscard]] virtual std::string texture_directory() const = 0;
};

}  // namespace eyebridge::camera
