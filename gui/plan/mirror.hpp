#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "eyebridge/hal/environment.hpp"
#include "eyebridge/robot/simulation.hpp"

namespace eyebridge::gui {

/// What a sensor sees, as a line on the floor.
struct SensorRay {
  Vec2 from;
  Vec2 to;           ///< Where it ends: on something, or at the sensor's reach.
  double range = 0;  ///< As the sensor would read without error, metres.
};

/// A copy of the world that is looked at: sensors are asked here, so that the run does not change
/// and nobody waits. One thread.
class Mirror {
 public:
  /// Puts everything where `look` saw it; what is new is added, what was removed removed.
  void follow(const hal::WorldLook& look);

  /// Of the robot with this index, in the order of its model. Without error.
  [[nodiscard]] std::vector<SensorRay> distance_rays(std::size_t robot);
  /// Lent until the next call.
  [[nodiscard]] const std::vector<SensorRay>& lidar_rays(std::size_t robot);
  [[nodiscard]] std::vector<SensorRay> proximity_rays(std::size_t robot) const;
  /// Of its bumpers, in the order of the model.
  [[nodiscard]] std::vector<bool> bumpers(std::size_t robot);
  /// Whether the body can stand there: on the floor, and in nothing else.
  [[nodiscard]] bool is_free(world::BodyId body, Vec2 place) const;

 private:
  void begin(const hal::WorldLook& look);
  /// Adds what came after the mirror's own bodies, in their order, so that ids are the same here.
  void add_newcomers(const hal::WorldLook& look);

  std::optional<robot::Simulation> world_;
  std::vector<double> ranges_;
  std::vector<SensorRay> scan_;
};

}  // namespace eyebridge::gui
