#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "eyebridge/files/readers.hpp"

namespace eyebridge::gui {

/// An object that balls and robots meet, and whether a maze's drawing has it.
struct Thing {
  world::ObjectSpec spec;
  bool is_drawn = false;  ///< Part of the .maz file, not of the .sim file.

  friend bool operator==(const Thing&, const Thing&) = default;
};

/// What an editor edits: a world or maze and what a simulation puts into it. A plain value; lengths
/// in metres.
struct Plan {
  double width = 0.0;   ///< Of the floor.
  double height = 0.0;  ///< Of the floor.
  std::optional<std::string> texture;
  std::optional<double> water;  ///< Its depth, as the world says; a simulation's is in `rest`.
  std::optional<double> cell;   ///< Of the maze that it is to be; none: any.
  std::vector<world::MazeCell> goals;  ///< Of that maze.
  std::vector<world::Wall> walls;
  std::vector<world::StartPose> starts;
  std::vector<Thing> things;
  std::vector<world::Marker> markers;
  std::vector<files::SimRobot> robots;  ///< Also objects that a file describes.
  files::SimFile rest;                  ///< Files, errors, settings: all else of a .sim file.
};

/// Whether `a` and `b` say the same, wherever their robots and errors stand in files.
bool same_plan(const Plan& a, const Plan& b);

/// The lists of a plan; the order is that in which later ones are drawn over earlier ones.
enum class Kind { Wall, Marker, Start, Thing, Robot };

/// One element of a plan: the list it is in, and where.
struct Item {
  Kind kind = Kind::Wall;
  std::size_t index = 0;

  friend auto operator<=>(const Item&, const Item&) = default;
};
using Selection = std::set<Item>;

/// Whether the plan has it.
bool has(const Plan& plan, const Item& item);
/// All that can be selected.
Selection all_items(const Plan& plan);
/// Where a robot stands: at its pose, or at the start with its letter; nothing when that is
/// missing. `robot` is its place among the robots: a letter's starts are taken in turn.
std::optional<Pose> pose_of_robot(const Plan& plan, std::size_t robot);
/// The pose of a robot, start or thing, theta 0 for a marker; of a wall its middle, along it.
std::optional<Pose> pose_of(const Plan& plan, const Item& item);
/// The way of a moving thing, null when it has none.
const world::Path* way_of(const Plan& plan, const Item& item);
/// What a way starts with when a person gives a thing its first point.
world::Path* make_way(Plan& plan, const Item& item);
/// Takes speeds and waits off `path` that are for legs which it has no more.
void fit_profile(world::Path& path);

/// The ends of walls that are one point.
inline constexpr double kSamePoint = 1e-6;  // metres
inline bool same_point(Vec2 a, Vec2 b) { return norm_squared(a - b) <= kSamePoint * kSamePoint; }

/// A room of this size, metres, with four outer walls: a new world.
Plan empty_plan(double width, double height);

/// The parts of a plan as files have them: the ground with `letters` of its starts or without.
world::WorldModel ground_of(const Plan& plan, bool letters);
files::SimFile sim_of(const Plan& plan);

}  // namespace eyebridge::gui
