#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::camera {

/// Sets of marks: which number has which picture.
enum class FiducialFamily {
  Aruco5x5,  ///< OpenCV's DICT_5X5_1000.
  Tag36h11,  ///< AprilTags (Olson, ICRA 2011; Wang and Olson, IROS 2016), as their library draws
  Tag25h9,   ///< them.
  Tag16h5,
};

/// The words for them, for messages.
inline constexpr std::string_view kFamilyWords = "aruco, tag36h11, tag25h9 or tag16h5";
/// The family that one of these words means; nothing for another word.
std::optional<FiducialFamily> family_named(std::string_view name);
/// How many different ones there are: numbers 0 … count_of() - 1.
constexpr int count_of(FiducialFamily family) {
  switch (family) {
    case FiducialFamily::Tag36h11:
      return 587;
    case FiducialFamily::Tag25h9:
      return 35;
    case FiducialFamily::Tag16h5:
      return 30;
    case FiducialFamily::Aruco5x5:
      break;
  }
  return 1000;
}
/// Cells along an edge of the black square: those of the code, and a black one on either side.
constexpr int cells_of(FiducialFamily family) {
  switch (family) {
    case FiducialFamily::Tag36h11:
      return 8;
    case FiducialFamily::Tag16h5:
      return 6;
    case FiducialFamily::Tag25h9:
    case FiducialFamily::Aruco5x5:
      break;
  }
  return 7;
}

/// A square black-and-white mark on a wall, by whose picture a camera knows where it is.
struct Fiducial {
  int id = 0;           ///< Its number in the dictionary.
  Vec2 centre;          ///< On the wall's face, world, metres.
  double z = 0.0;       ///< Of its centre above the floor, metres.
  double facing = 0.0;  ///< Heading of the normal, away from the wall, radians.
  double size = 0.0;    ///< Edge of its black square, metres.
  FiducialFamily family = FiducialFamily::Aruco5x5;

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
  FiducialFamily family = FiducialFamily::Aruco5x5;

  friend bool operator==(const FiducialLayout&, const FiducialLayout&) = default;
};

/// Edge of the white square that has a fiducial of `size` in its middle, metres: without a white
/// margin of one cell it is not found.
constexpr double with_margin(double size, FiducialFamily family) {
  return size * (cells_of(family) + 2) / cells_of(family);
}
constexpr double with_margin(const Fiducial& fiducial) {
  return with_margin(fiducial.size, fiducial.family);
}

/// Where the fiducials of a world are: on both long sides of each wall, where these can be seen
/// from inside the world's floor and no other wall touches them, in the order of the walls,
/// numbered from 0. With their margins they fit on the wall; a wall on which only fiducials under
/// kSmallestFiducial would fit gets none. The same world and layout always give the same: the sheet
/// that was printed and the program that looks at it need no file between them.
/// Throws ConfigError for a layout whose lengths cannot be, or when the world needs more than
/// the family has.
std::vector<Fiducial> place_fiducials(const world::WorldModel& model,
                                      const FiducialLayout& layout = {});

/// Edge under which a fiducial is of no use, metres.
inline constexpr double kSmallestFiducial = 0.015;

/// A fiducial's picture, without its margin: 1 is white, 0 black; row by row from the top left, as
/// one sees it who faces the wall; cells_of() its family in both directions.
using FiducialBits = std::vector<std::uint8_t>;

/// The picture of fiducial `id`. Loads the vision library; throws ConfigError when that cannot be,
/// std::out_of_range for an `id` that the family lacks.
FiducialBits fiducial_bits(FiducialFamily family, int id);

}  // namespace eyebridge::camera
