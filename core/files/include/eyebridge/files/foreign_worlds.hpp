#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/files/map_files.hpp"
#include "eyebridge/files/readers.hpp"
#include "eyebridge/files/scenario.hpp"

namespace eyebridge::files {

// Worlds as other programs keep them. What is read and what is written: docs/formats.md.

// Readers. What is in a file and is not carried over is a warning, once a kind. `start_places` as
// in read_world(). All throw ConfigError with file, line and column.

/// Files that a world names: both take the name as it is written, and where it is.
struct NamedFiles {
  std::function<std::string(const std::string& name, const SourceLocation& where)> text;
  std::function<GreyPicture(const std::string& name, const SourceLocation& where)> picture;
};

/// An SVG drawing (W3C, SVG 1.1): the rims of what is filled, and lines as thick as they are drawn,
/// are walls. Its size in millimetres is that of the floor.
world::WorldModel read_svg(std::string_view text, const std::string& file,
                           std::vector<Warning>& warnings,
                           std::vector<SourceLocation>* start_places = nullptr);

/// A `.world` of Stage 2 to 4: bitmaps, blocks and boxes of models are walls, robots are starts.
/// The floor is the smallest one that has them all.
world::WorldModel read_stage(std::string_view text, const std::string& file,
                             const NamedFiles& files, std::vector<Warning>& warnings,
                             std::vector<SourceLocation>* start_places = nullptr);

/// A world of IR-SIM, YAML: obstacles are walls, round ones cans that stand fast, robots starts.
world::WorldModel read_irsim(std::string_view text, const std::string& file,
                             const NamedFiles& files, std::vector<Warning>& warnings,
                             std::vector<SourceLocation>* start_places = nullptr);
/// Whether YAML text is one of IR-SIM, not a map.
bool is_irsim(std::string_view text);

// Writers. What a format cannot say is in WrittenWorld::losses. `name` is what the file calls its
// world.

/// SVG 1.1, for drawing programs: a unit is a millimetre, walls are lines as wide as the walls are
/// thick, black where they have no colour of their own, starts circles of the class "start" with
/// their heading in `data-heading`, degrees counter-clockwise.
WrittenWorld write_svg(const Scenario& scenario, const std::string& name);

/// SDFormat 1.9, for Gazebo: walls as boxes that stand still, balls, cans, boxes and polygons as
/// models with their mass and friction, starts as frames.
WrittenWorld write_sdf(const Scenario& scenario, const std::string& name);

/// The `.world` of Stage 4: walls and things as models, starts as robots that drive on two wheels.
WrittenWorld write_stage(const Scenario& scenario, const std::string& name);

/// What a map of ROS cannot say of a world: walls are pixels there, and all else is free.
std::vector<std::string> losses_of_map(const Scenario& scenario);

}  // namespace eyebridge::files
