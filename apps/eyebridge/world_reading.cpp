#include "world_reading.hpp"

#include <CLI/CLI.hpp>

#include "eyebridge/base/length.hpp"
#include "eyebridge/files/maze_limits.hpp"

namespace eyebridge::apps {

files::LoadOptions ReadingFlags::options() const {
  files::LoadOptions out;
  out.robot = robot;
  out.robot_where = {"--robot"};
  out.cell_where = {"--cell"};
  if (!cell.empty()) {
    out.cell = parse_length(cell, out.cell_where, files::kLeastMazeCell, files::kMostMazeCell);
  }
  return out;
}

std::shared_ptr<ReadingFlags> add_cell_flag(CLI::App& command) {
  auto flags = std::make_shared<ReadingFlags>();
  command
      .add_option("--cell", flags->cell, "Size of a maze's cells, such as 180mm [as its file says]")
      ->type_name("LENGTH");
  return flags;
}

std::shared_ptr<ReadingFlags> add_reading_flags(CLI::App& command) {
  auto flags = add_cell_flag(command);
  command.add_option("--robot", flags->robot, "Robot to place where the world places none")
      ->type_name("ROBOT");
  return flags;
}

}  // namespace eyebridge::apps
