#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/files/scenario.hpp"

namespace eyebridge::files {

/// Where files are looked for that are found neither as given nor beside the file that names them:
/// in this order. Empty ones are left out.
struct SearchPlaces {
  std::filesystem::path eyesim_home;  ///< EYESIM_HOME of the environment; also what `%sim%` means.
  std::filesystem::path program;      ///< Folder `worlds/` beside the robot program.
  std::filesystem::path user;         ///< ${XDG_DATA_HOME:-~/.local/share}/eyebridge/worlds
  std::filesystem::path installed;    ///< EyeBridge's own worlds.

  /// Those of this process, which runs `program` (a file; empty: none).
  static SearchPlaces of_process(const std::filesystem::path& program = {});
  /// Those that are not empty, in the order of the search.
  [[nodiscard]] std::vector<std::filesystem::path> folders() const;
};

/// Folder of EyeBridge's own worlds: beside this code (share_folder()), else, for a program of
/// somebody else that our static libraries are linked into, in the first of XDG_DATA_DIRS that has
/// it. Empty if there is none.
std::filesystem::path own_worlds();

/// How load_scenario() reads.
struct LoadOptions {
  /// A built-in robot, which a world or maze without robots gets; empty: it stays without.
  std::string robot = "S4";
  SourceLocation robot_where{"default robot"};  ///< Where that was said.
  SearchPlaces places = SearchPlaces::of_process();
  Reading reading = Reading::Strict;
  /// Edge length of a maze's cells, metres, whatever its file says.
  std::optional<double> cell = std::nullopt;
  SourceLocation cell_where{"cell"};
};

/// Loads a `.wld`, `.sim`, `.robi` or `.esObj` (in an empty room), EyeSim parameter file (`.p`) or
/// maze (`.maz`, or any other name: read_maze() knows it by its content) and everything it names. A
/// world or maze without robots gets one at its first start pose, or at the free place nearest to
/// its centre. A floor texture that exists becomes an absolute path; it is looked for beside the
/// world's file first. A `path` that does not exist is looked for by name in the places
/// (find_file()).
///
/// Throws ConfigError. Robots that would stand in a wall, an object or another robot are an error
/// at the line that places them: of a `.sim`, or the start position or letter. With
/// Reading::Tolerant what a line breaks is a warning, robots that would stand in something are put
/// to the nearest free place, and objects whose files cannot be read are boxes.
Scenario load_scenario(const std::filesystem::path& path, const LoadOptions& options = {});

/// A built-in robot by name, case ignored ("S4", "LabBot", "Mouse"); null when there is none.
/// Parsed on first use; any thread.
const robot::RobotModel* builtin_robot(std::string_view name);

/// Names of the built-in robots that have a device: `kind` is "PSD", "servo", "motor", "encoder" or
/// "lidar", `id` what programs call it (of a lidar, any). Any thread.
std::vector<std::string> robots_with(std::string_view kind, int id);
/// The same for a PSD by its name ("PSD_FRONTLEFT"), case ignored.
std::vector<std::string> robots_with_psd(std::string_view name);

/// As builtin_robot(), but throws ConfigError at `where` when there is none, naming those there
/// are.
const robot::RobotModel& named_robot(std::string_view name, const SourceLocation& where);

/// Leaves the first `count` (> 0) robots of `scenario`, or adds more like the last one, its program
/// too: at starts where nobody stands yet, then at the free places nearest to the centre. Throws
/// ConfigError at `where`, which asked for that many, when there is no room for them.
void set_robot_count(Scenario& scenario, std::size_t count, const SourceLocation& where);

/// As many robots as the scenario has places for by itself: those it places, or one at each start.
std::size_t robots_meant(const Scenario& scenario);

/// An empty room, 2 m x 2 m with walls, and one S4 in its middle: what a program gets that names
/// no world (as in EyeSim).
Scenario default_scenario();

}  // namespace eyebridge::files
