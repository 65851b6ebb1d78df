#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/camera/view.hpp"
#include "eyebridge/hal/time_control.hpp"
#include "eyebridge/hal/world_control.hpp"
#include "eyebridge/robot/robot_model.hpp"
#include "eyebridge/robot/simulation.hpp"
#include "eyebridge/world/scene.hpp"

namespace eyebridge::hal {

/// One robot at one moment.
struct RobotLook {
  std::shared_ptr<const robot::RobotModel> model;  ///< Its errors are those that it came with.
  world::BodyId body = 0;
  Pose pose;                         ///< Truth, in the world.
  Pose odometry;                     ///< As the robot believes, from where it started.
  Twist twist;                       ///< As driven in the last step.
  unsigned stalled = 0;              ///< robot::StallMask.
  std::optional<camera::Eye> eye{};  ///< Of its camera; nothing where it has none.
  double altitude = 0.0;             ///< robot::Simulation::altitude(), metres.
  std::optional<double> depth{};     ///< robot::Simulation::depth(), metres: of submarines alone.
  /// False once it was removed: the rest is as it was then, and the scene has no body of it.
  bool is_there = true;
};

/// A world at one moment, and what happened since the look before.
struct WorldLook {
  world::Scene scene;
  std::vector<RobotLook> robots;  ///< In the order of their numbers, from 1.
  /// Bodies of objects in the order of their numbers, from 1; with those that were removed.
  std::vector<world::BodyId> objects;
  std::vector<robot::CollisionEvent> collisions;  ///< The oldest first.
  std::uint64_t collision_count = 0;              ///< Of all so far; kept from look to look.
};

/// A simulated world as a window sees it and reaches into it. Any thread; whoever owns the world
/// owns it.
class Environment {
 public:
  virtual ~Environment() = default;

  /// Brings `look` up to date: a microsecond or some, in which no step is made. Sensors are not
  /// read: that would change the run.
  virtual void look(WorldLook& look) = 0;
  [[nodiscard]] virtual TimeControl& time() = 0;
  /// Robot 0 is the first one.
  [[nodiscard]] virtual WorldControl& control() = 0;
  /// Drives robot `index`, from 0, as its program would: until the next command of either. Metres
  /// and radians a second, limited to what the robot can. OutOfRange for a robot that is not there
  /// and a twist that is not finite.
  virtual Result<void> drive(std::size_t index, const Twist& twist) = 0;
  /// From now on the devices of robot `index` err as those of `like`, a model with the same
  /// devices: RobotLook::model, scaled, say. OutOfRange for a robot that is not there and a model
  /// with others.
  virtual Result<void> set_errors(std::size_t index, const robot::RobotModel& like) = 0;
  /// The model of robot `index` with the errors that it has now. OutOfRange for a robot that is not
  /// there.
  virtual Result<robot::RobotModel> present_model(std::size_t index) = 0;
  /// Whether the scenario wants a person to let time begin.
  [[nodiscard]] virtual bool starts_paused() const = 0;
  /// Where textures and the like are looked for.
  [[nodiscard]] virtual std::string directory() const = 0;
};

}  // namespace eyebridge::hal
