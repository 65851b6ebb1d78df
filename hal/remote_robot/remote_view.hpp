#pragma once

#include <mutex>
#include <string>

#include "eyebridge/camera/view.hpp"
#include "remote_robot/remote_robot.hpp"
#include "remote_robot/robot_line.hpp"

namespace eyebridge::hal {

/// What the camera of a robot looks at, as its server tells: pictures are made where the program
/// is. What stands in the world is known here, too; what moves is asked. Once the server is gone,
/// nothing moves. Any thread.
class RemoteView final : public camera::View {
 public:
  RemoteView(RobotLine& line, WorldLoader world, std::uint32_t carrier, std::string textures)
      : line_(line), load_(std::move(world)), carrier_(carrier), textures_(std::move(textures)) {}

  [[nodiscard]] world::Scene scene() const override;
  [[nodiscard]] camera::Eye eye() const override;
  [[nodiscard]] std::uint32_t carrier() const override { return carrier_; }
  [[nodiscard]] camera::ImageNoise noise() const override;
  [[nodiscard]] std::string texture_directory() const override { return textures_; }

 private:
  RobotLine& line_;
  const WorldLoader load_;
  const std::uint32_t carrier_;
  const std::string textures_;
  mutable std::mutex mutex_;
  mutable world::Scene last_;
  mutable camera::Eye last_eye_;
  mutable camera::ImageNoise last_noise_;
};

// How they are told: what a server's "view" answers.

Values pack_scene(const world::Scene& scene);
/// Its bodies and time; false when these are not the numbers of a scene.
bool unpack_scene(const Values& values, world::Scene& scene);
Values pack_eye(const camera::Eye& eye);
Values pack_noise(const camera::ImageNoise& noise);

}  // namespace eyebridge::hal
