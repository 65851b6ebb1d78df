#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "eyebridge/base/colour.hpp"
#include "eyebridge/base/pose.hpp"

namespace eyebridge::world {

/// A straight wall. Sensors see its outline; the camera sees it `height` high.
struct Wall {
  static constexpr double kDefaultHeight = 0.2;
  static constexpr Rgb kDefaultColour{230, 230, 230};
  /// Of a wall in a .wld file whose line does not say it, metres: EyeSim's.
  static constexpr double kFileThickness = 0.01;

  Vec2 a;                          ///< One end, metres.
  Vec2 b;                          ///< The other end; never equal to `a`.
  double thickness = 0.0;          ///< Metres, centred on a–b; 0 is a bare line, as in mazes.
  double height = kDefaultHeight;  ///< Metres above the floor.
  Rgb colour = kDefaultColour;

  friend bool operator==(const Wall&, const Wall&) = default;
};

/// What kind of thing lies about.
enum class ObjectKind {
  Ball,     ///< A disc that rolls when pushed, and bounces off walls.
  Can,      ///< A disc that slides while pushed, then stands still.
  Box,      ///< A rectangle that slides as a can does, without turning.
  Polygon,  ///< The same with any convex outline.
};

/// Acceleration of a falling body, metres per second squared.
inline constexpr double kGravity = 9.81;

/// How a thing answers to pushes and hits.
struct Matter {
  double mass = 0.046;  ///< Kilograms, > 0: of two things that roll or slide, how they share a hit.
  /// Coefficient, >= 0, of rolling (balls) or sliding: what moves slows down by friction *
  /// kGravity. Without: a ball slows down by 0.3 m/s^2; other things stop with their
  /// pusher, and no ball moves them.
  std::optional<double> friction{};
  /// Share of the speed of approach that it leaves with, 0 ... 1; when two meet that move, the
  /// larger one counts. Without: 0.6 for a ball, 0.5 when a robot hits it, and 0 for others.
  std::optional<double> restitution{};
  bool fixed = false;  ///< Nothing pushes it away.

  friend bool operator==(const Matter&, const Matter&) = default;
};

/// A way on which an object moves by itself: straight from its place to the first point, and so on.
/// It keeps its heading, pushes what gives way, and waits where a robot or a wall stops it.
struct Path {
  double speed = 0.1;  ///< Metres per second, > 0.
  bool loop = true;    ///< From the last point to its first place; else it comes back as it went.
  std::vector<Vec2> points;  ///< In the world, metres; one at least.
  /// Of the first legs, metres per second, > 0: [0] to the first point, and so on, a loop's last
  /// one to its first place; back by the same. `speed` counts on legs without one.
  std::vector<double> leg_speeds{};
  /// Seconds, >= 0, that it stands at the first points: [0] at points[0], ..., a loop's last one at
  /// its first place. It passes points without one, but at the ends of a way back.
  std::vector<double> waits{};
  /// Metres per second squared, > 0: it gains speed at this rate and slows down by it before it
  /// stands or a slower leg begins. 0: at once.
  double acceleration = 0.0;

  /// How many legs there are that can have speeds.
  [[nodiscard]] std::size_t leg_count() const { return points.size() + (loop ? 1 : 0); }

  friend bool operator==(const Path&, const Path&) = default;
};

/// What an object does by itself about robots: it drives as they do, and keeps its heading.
struct Reaction {
  enum class Kind {
    Follow,  ///< Goes to the nearest robot, until it touches it.
    Flee,    ///< Goes away from the nearest robot, along walls where there is no other way.
    Wander,  ///< Goes straight, in any direction, and bounces off what stands in its way.
  };

  Kind kind = Kind::Follow;
  double speed = 0.1;  ///< Metres per second, > 0.
  /// Robots whose rim is farther than this from its own do not count, metres; not for what wanders.
  double range = std::numeric_limits<double>::infinity();

  friend bool operator==(const Reaction&, const Reaction&) = default;
};

/// A thing that robots meet, and push unless it is fixed or moves by itself.
struct ObjectSpec {
  ObjectKind kind = ObjectKind::Ball;
  std::string name = "ball";  ///< As the file calls it, lower case: "golf", "soccer", "can".
  Pose pose;                  ///< Of its centre in the world.
  double radius = 0.02;       ///< Metres; a box has a `size` instead, a polygon `corners`.
  double height = 0.04;       ///< Metres; a ball's is its diameter.
  Rgb colour{255, 140, 0};
  Vec2 size{};  ///< Of a box: length along its heading and width, metres, > 0.
  /// Of a polygon, metres from its pose, x along its heading: what fault_of_corners() lets pass.
  std::vector<Vec2> corners{};
  Matter matter;
  std::optional<Path> path{};
  std::optional<Reaction> reaction{};  ///< Not with a path.
  /// One that moves by itself stands while the rim of a robot is nearer to its own, metres.
  double yields_within = 0.0;

  /// Of the disc about its centre that covers it, metres.
  [[nodiscard]] double outer_radius() const;

  friend bool operator==(const ObjectSpec&, const ObjectSpec&) = default;
};

/// A coloured disc painted on the floor; nothing bumps into it.
struct Marker {
  Vec2 position;
  Rgb colour{255, 0, 0};

  friend bool operator==(const Marker&, const Marker&) = default;
};

/// Where a robot may start. Letter 0: a `position` line of a world file.
struct StartPose {
  char letter = 0;  ///< As drawn in the maze: 'S', 'u', …
  Pose pose;

  friend bool operator==(const StartPose&, const StartPose&) = default;
};

/// A cell of a maze.
struct MazeCell {
  int column = 0;
  int row = 0;

  friend bool operator==(const MazeCell&, const MazeCell&) = default;
};

/// A maze drawn on a square grid. Cell (0, 0) is at the lower left.
///
/// Edges are stored as bits: `south[row * columns + column]` is the edge under a cell, with one
/// more row for the top boundary; `west[row * (columns + 1) + column]` the edge left of a cell,
/// with one more column for the right boundary.
struct MazeGrid {
  int columns = 0;
  int rows = 0;
  double cell = 0.36;                ///< Edge length of a cell, metres.
  std::vector<char> south;           ///< columns * (rows + 1) flags.
  std::vector<char> west;            ///< (columns + 1) * rows flags.
  std::vector<MazeCell> goals = {};  ///< Where a contest run ends; none: its file says nothing.

  friend bool operator==(const MazeGrid&, const MazeGrid&) = default;
};

/// Everything that stands in a world before the first robot moves.
struct WorldModel {
  /// Depth of the water where a submarine is and no file says how deep it is, metres.
  static constexpr double kDefaultWater = 2.0;

  double width = 0.0;   ///< Of the floor, along x, metres.
  double height = 0.0;  ///< Of the floor, along y, metres.
  std::vector<Wall> walls;
  std::optional<std::string> floor_texture;  ///< As written in the file, not yet searched for.
  std::vector<StartPose> starts;             ///< In the order of the file.
  std::vector<ObjectSpec> objects;
  std::vector<Marker> markers;
  std::optional<MazeGrid> maze;  ///< Set when the world was drawn as a maze; `walls` has its walls.
  std::optional<double> water{};  ///< How deep water stands on the floor, metres, as a file says.
  Vec2 corner{};  ///< The lower left one of the floor, metres; that of a map may lie anywhere.

  /// The upper right corner of the floor, metres.
  [[nodiscard]] Vec2 far_corner() const { return corner + Vec2{width, height}; }
  /// The middle of the floor, metres.
  [[nodiscard]] Vec2 middle() const { return corner + Vec2{width / 2, height / 2}; }
  /// Whether a place lies on the floor or on its edge.
  [[nodiscard]] bool has_floor_at(Vec2 place) const {
    const Vec2 far = far_corner();
    return place.x >= corner.x && place.y >= corner.y && place.x <= far.x && place.y <= far.y;
  }

  /// How deep the water is for a submarine, metres, > 0.
  [[nodiscard]] double water_depth() const { return water.value_or(kDefaultWater); }

  friend bool operator==(const WorldModel&, const WorldModel&) = default;
};

/// The walls of `maze`, in row order, one per edge: what `walls` of a maze's model holds.
std::vector<Wall> walls_of(const MazeGrid& maze);

/// Four walls round a floor of `width` x `height`, metres, counter-clockwise from (0, 0).
std::vector<Wall> walls_around(double width, double height);

/// Corners that an outline may have.
inline constexpr std::size_t kMostCorners = 16;

/// What is wrong with the corners of a polygon: one that no outline can have, with its index, and
/// what was expected. Nothing for 3 ... kMostCorners that lie counter-clockwise about the origin,
/// which is within, without a dent and no three in a line.
struct CornerFault {
  std::size_t corner = 0;
  std::string expected;
};
std::optional<CornerFault> fault_of_corners(const std::vector<Vec2>& corners);

/// The corners of a box or polygon, counter-clockwise, metres from its pose, x along its heading;
/// none of what is round.
std::vector<Vec2> corners_of(const ObjectSpec& object);

/// Distance from `p` to the rim of `object`, metres; less than 0, or 0, within it.
double rim_distance(const ObjectSpec& object, Vec2 p);

/// Index of a wall of `model` that `object` would meet on its path, which it has; nothing when
/// there is none.
std::optional<std::size_t> wall_on_path(const WorldModel& model, const ObjectSpec& object);

}  // namespace eyebridge::world
