#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::camera {

/// A square black-and-white mark on a wall, by whose picture a camera knows where it is.
struct Fiducial {
  int id = 0;           ///< Its number in the dictionary.
  Vec2 centre;          ///< On the wall's face, world, metres.
  double z = 0.0;       ///< Of its centre above the floor, metres.
  double facing = 0.0;  ///< Heading of the normal, away from the wall, radians.
  double size = 0.0;    ///< Edge of its black square, metres.

  friend bool operator==(const Fiducial&, const Fiducial&) = default;
};

/// The corners of a fiducial's black square: top left, top right, bottom right, bottom left, as one
/// sees them who faces the wall.
using Corners = std::array<Vec2, 4>;

/// A fiducial found in a picture.
struct SeenFiducial {
  int id = 0;
  Corners corners{};  ///< Pixels; (0, 0) is the centre of the top left pixel.
};

/// How a world is marked.
struct FiducialLayout {
  double size = 0.08;     ///< Edge of the black square, metres; smaller where a wall is too small.
  double spacing = 0.36;  ///< On longer walls one for so many metres.
  double height = 0.0;    ///< Of the centres above the floor, metres; 0: the middle of the wall.

  friend bool operator==(const FiducialLayout&, const FiducialLayout&) = default;
};

/// How many different fiducials there are: 0 … kFiducials - 1.
inline constexpr int kFiducials = 1000;
/// Cells along an edge of the black square: 5 of the code, and a black one on either side.
inline constexpr int kFiducialCells = 7;

/// Edge of the white square that has a fiducial of `size` in its middle, metres: without a white
/// margin of one cell it is not found.
constexpr double with_margin(double size) { return size * (kFiducialCells + 2) / kFiducialCells; }

/// Where the fiducials of a world are: on both long sides of each wall, where these can be seen
/// from inside the world's floor and no other wall touches them, in the order of the walls,
/// numbered from 0. With their margins they fit on the wall; a wall on which only fiducials under
/// kSmallestFiducial would fit gets none. The same world and layout always give the same: the sheet
/// that was printed and the program that looks at it need no file between them.
/// Throws ConfigError for a layout whose lengths cannot be, or when the world needs more than
/// kFiducials.
std::vector<Fiducial> place_fiducials(const world::WorldModel& model,
                                      const FiducialLayout& layout = {});

/// Edge under which a fiducial is of no use, metres.
inline constexpr double kSmallestFiducial = 0.015;

/// A fiducial's picture, without its margin: 1 is white, 0 black; row by row from the top left, as
/// one sees it who faces the wall.
using FiducialBits = std::array<std::uint8_t, kFiducialCells * kFiducialCells>;

/// The picture of fiducial `id`, 0 … kFiducials - 1, of OpenCV's dictionary DICT_5X5_1000. Loads
/// the vision library; throws ConfigError when that cannot be, std::out_of_range for another `id`.
FiducialBits fiducial_bits(int id);

}  // namespace eyebridge::camera
