#pragma once

#include <optional>
#include <string>

#include "eyebridge/files/scenario.hpp"
#include "eyebridge/world/world.hpp"

namespace eyebridge::files {

/// Puts robots into a scenario whose walls and objects are complete.
///
/// A place is free by the rule of world::World: rims may touch, and overlap by 1e-9 m.
class Placer {
 public:
  /// `scenario` is lent for the object's life; its world does not change meanwhile.
  explicit Placer(Scenario& scenario);

  /// Adds a robot. Throws ConfigError at `where` when something stands there already.
  void place(std::size_t model, const Pose& pose, const SourceLocation& where);
  /// Adds a robot at the free place on the floor nearest to its centre (in a maze: a cell's
  /// centre). Throws ConfigError at `where` when there is none.
  void place_anywhere(std::size_t model, const SourceLocation& where);
  /// Adds `robot` to the models and places one at the world's first start, else anywhere. Throws
  /// ConfigError at the start's line, else at `where`.
  void place_at_start(const robot::RobotModel& robot, const SourceLocation& where);

  /// Whether place_at_start() would find room for `robot`.
  [[nodiscard]] bool has_room_for(const robot::RobotModel& robot) const;

 private:
  [[nodiscard]] bool is_free(Vec2 centre, double radius) const;
  /// The robot placed already that a disc would overlap; null when there is none.
  [[nodiscard]] const RobotPlacement* robot_at(Vec2 centre, double radius) const;
  /// What stands where is_free() is false, in words.
  [[nodiscard]] std::string obstacle_at(Vec2 centre, double radius) const;
  [[nodiscard]] std::optional<Vec2> free_place(double radius) const;

  Scenario& scenario_;
  world::World world_;  ///< Walls and objects, to ask what is free.
};

}  // namespace eyebridge::files
