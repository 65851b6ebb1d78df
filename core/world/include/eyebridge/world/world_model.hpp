#pragma once

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

  Vec2 a;                          ///< One end, metres.
  Vec2 b;                          ///< The other end; never equal to `a`.
  double thickness = 0.0;          ///< Metres, centred on a–b; 0 is a bare line, as in EyeSim 2D.
  double height = kDefaultHeight;  ///< Metres above the floor.
  Rgb colour = kDefaultColour;

  friend bool operator==(const Wall&, const Wall&) = default;
};

/// What kind of loose thing lies about.
enum class ObjectKind {
  Ball,  ///< Rolls when pushed, bounces off walls.
  Can,   ///< Slides while pushed, then stands still.
};

/// A loose thing: a disc seen from above.
struct ObjectSpec {
  ObjectKind kind = ObjectKind::Ball;
  std::string name = "ball";  ///< As the file calls it, lower case: "golf", "soccer", "can".
  Pose pose;                  ///< Of its centre in the world.
  double radius = 0.02;       ///< Metres.
  double height = 0.04;       ///< Metres; a ball's is its diameter.
  Rgb colour{255, 140, 0};

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

/// A maze drawn on a square grid. Cell (0, 0) is at the lower left.
///
/// Edges are stored as bits: `south[row * columns + column]` is the edge under a cell, with one
/// more row for the top boundary; `west[row * (columns + 1) + column]` the edge left of a cell,
/// with one more column for the right boundary.
struct MazeGrid {
  int columns = 0;
  int rows = 0;
  double cell = 0.36;       ///< Edge length of a cell, metres.
  std::vector<char> south;  ///< columns * (rows + 1) flags.
  std::vector<char> west;   ///< (columns + 1) * rows flags.

  friend bool operator==(const MazeGrid&, const MazeGrid&) = default;
};

/// Everything that stands in a world before the first robot moves.
struct WorldModel {
  double width = 0.0;   ///< Floor from x = 0 to `width`, metres.
  double height = 0.0;  ///< Floor from y = 0 to `height`, metres.
  std::vector<Wall> walls;
  std::optional<std::string> floor_texture;  ///< As written in the file, not yet searched for.
  std::vector<StartPose> starts;             ///< In the order of the file.
  std::vector<ObjectSpec> objects;
  std::vector<Marker> markers;
  std::optional<MazeGrid> maze;  ///< Set when the world was drawn as a maze; `walls` has its walls.

  friend bool operator==(const WorldModel&, const WorldModel&) = default;
};

/// The walls of `maze`, in row order, one per edge: what `walls` of a maze's model holds.
std::vector<Wall> walls_of(const MazeGrid& maze);

}  // namespace eyebridge::world
