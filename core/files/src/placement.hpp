#pragma once

#include <optional>
#include <string>

#include "eyebridge/files/scenario.hpp"
#include "eyebridge/world/world.hpp"

namespace eyebridge::files {

/// "from (0, 0) mm to (100, 0) mm"
std::string in_words(const world::Wall& wall);

/// Puts robots into a scenario whose walls and objects are complete.
///
/// A place is free where world::World takes the robot: rims may touch.
class Placer {
 public:
  /// `scenario` is lent for the object's life; its world does not change meanwhile. The robots that
  /// it has stand where they are.
  explicit Placer(Scenario& scenario, Reading reading = Reading::Strict);

  /// Adds a robot. Where something stands there already: throws ConfigError at `where`, or, where
  /// reading is Tolerant and there is room, puts it to the nearest free place with a warning.
  void place(std::size_t model, const Pose& pose, const SourceLocation& where);
  /// Throws ConfigError at `where` when a robot would stand in a wall there; adds none.
  void check_walls(std::size_t model, const Pose& pose, const SourceLocation& where);
  /// Adds a robot at the free place on the floor nearest to its centre (in a maze: a cell's
  /// centre). Throws ConfigError at `where` when there is none.
  void place_anywhere(std::size_t model, const SourceLocation& where);
  /// Adds up to `count` robots at the world's free starts, then at the free places nearest to its
  /// centre. Returns how many found one.
  std::size_t place_many(std::size_t model, std::size_t count);
  /// Adds `robot` to the models and places one at the world's first start, else anywhere. Throws
  /// ConfigError at the start's line, else at `where`.
  void place_at_start(const robot::RobotModel& robot, const SourceLocation& where);

 private:
  /// Puts `robot` into world_; false where it would not stand, or has no `gap` metres around it.
  bool add(Vec2 centre, const robot::RobotModel& robot, double gap = 0);
  void record(std::size_t model, const Pose& pose, const SourceLocation& where);
  /// Throws ConfigError at `where` for a submarine that is higher than the water is deep.
  void check_water(std::size_t model, const SourceLocation& where) const;
  void warn_outside(std::size_t model, const Pose& pose, const SourceLocation& where);
  /// The free place that is nearest to `wanted`, to a few millimetres; the robot is there then.
  std::optional<Vec2> add_near(Vec2 wanted, const robot::RobotModel& robot);
  [[nodiscard]] std::string in_the_way(std::size_t model, const Pose& pose,
                                       const std::string& obstacle) const;
  [[noreturn]] void refuse(std::size_t model, const Pose& pose, const std::string& obstacle,
                           const SourceLocation& where) const;
  /// The robot placed already that a disc would overlap; null when there is none.
  [[nodiscard]] const RobotPlacement* robot_at(Vec2 centre, double radius) const;
  /// What stands where add() gave false, in words.
  [[nodiscard]] std::string obstacle_at(Vec2 centre, double radius) const;
  [[nodiscard]] std::string wall_at(Vec2 centre) const;

  Scenario& scenario_;
  Reading reading_;
  world::World world_;                 ///< The same walls, objects and robots, to ask what is free.
  std::optional<world::World> walls_;  ///< The same walls alone, once somebody asks.
};

}  // namespace eyebridge::files
