#pragma once

#include <filesystem>

#include "eyebridge/files/scenario.hpp"

namespace eyebridge::files {

/// Loads a `.wld`, `.maz`, `.sim`, `.robi` (in an empty room) or EyeSim parameter file and
/// everything it names. A world or maze without robots gets one robot of `default_robot` at its
/// first start pose, or at the free place nearest to its centre.
///
/// Throws ConfigError. Robots that would stand in a wall are an error at the line that places them.
Scenario load_scenario(const std::filesystem::path& path, const std::string& default_robot = "S4");

/// A built-in robot by name, case ignored ("S4", "LabBot"); null when there is none.
const robot::RobotModel* builtin_robot(std::string_view name);

/// An empty room, 2 m x 2 m with walls, and one S4 in its middle: what a program gets that names
/// no world (as in EyeSim).
Scenario default_scenario();

}  // namespace eyebridge::files
