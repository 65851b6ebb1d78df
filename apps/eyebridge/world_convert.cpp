#include "world_convert.hpp"

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/base/write_file.hpp"
#include "eyebridge/files/readers.hpp"
#include "world_reading.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

/// A world in a format, and what of it that format cannot say.
using Converted = files::MazeText;

Converted as_drawing(const files::Scenario& scenario) {
  return files::write_maze_as(files::MazeFormat::Drawing, scenario.world);
}
Converted as_posts(const files::Scenario& scenario) {
  return files::write_maze_as(files::MazeFormat::Posts, scenario.world);
}
Converted as_list(const files::Scenario& scenario) {
  return files::write_maze_as(files::MazeFormat::List, scenario.world);
}

/// The floor of a .wld file begins at the origin.
void move_to_origin(world::WorldModel& model, std::vector<std::string>& losses) {
  const Vec2 corner = model.corner;
  if (corner == Vec2{}) return;
  losses.push_back(fmt::format("where its floor begins: all is moved by {:g} {:g} mm",
                               m_to_mm(-corner.x), m_to_mm(-corner.y)));
  for (world::Wall& wall : model.walls) {
    wall.a = wall.a - corner;
    wall.b = wall.b - corner;
  }
  for (world::StartPose& start : model.starts) {
    start.pose.x -= corner.x;
    start.pose.y -= corner.y;
  }
  model.corner = {};
}

Converted as_world(const files::Scenario& scenario) {
  Converted out;
  world::WorldModel model = scenario.world;
  for (const world::ObjectSpec& object : model.objects) out.losses.push_back("the " + object.name);
  if (!model.markers.empty()) out.losses.push_back(fmt::format("{} markers", model.markers.size()));
  if (model.maze && !model.maze->goals.empty()) out.losses.push_back("the goals of the maze");
  move_to_origin(model, out.losses);
  model.objects.clear();
  model.markers.clear();
  model.maze.reset();
  out.text = files::write_world(model);
  return out;
}

struct Format {
  const char* ending;
  Converted (*write)(const files::Scenario& scenario);
};
constexpr auto kFormats = std::to_array<Format>({
    {".maz", as_drawing},
    {".txt", as_posts},
    {".num", as_list},
    {".wld", as_world},
});

const Format& format_of(const fs::path& path) {
  std::string endings;
  for (const Format& format : kFormats) {
    if (path.extension() == format.ending) return format;
    endings += fmt::format("{}{}", endings.empty() ? "" : ", ", format.ending);
  }
  throw ConfigError({path.string()}, "unknown kind of file: expected " + endings);
}

int convert(const fs::path& from, const fs::path& to, const ReadingFlags& flags, bool overwrites) {
  const Format& format = format_of(to);
  std::error_code error;
  if (!overwrites && fs::exists(fs::symlink_status(to, error))) {
    throw ConfigError({to.string()}, "is there already: expected another name, or --overwrite");
  }
  const files::Scenario scenario = files::load_scenario(from, flags.options());
  for (const Warning& warning : scenario.warnings) tell(warning.str());
  Converted converted = format.write(scenario);
  if (!scenario.robots.empty()) {
    converted.losses.push_back(fmt::format("{} robots", scenario.robots.size()));
  }
  for (const std::string& loss : converted.losses) {
    tell(fmt::format("{}: warning: not carried over: {}", to.string(), loss));
  }
  if (const auto done = write_file(to, converted.text); !done) {
    throw ConfigError({to.string()}, done.error().what);
  }
  std::printf("%s\n", printable(to.string()).c_str());
  return kFine;
}

}  // namespace

void add_world_convert(CLI::App& world, int& code) {
  CLI::App* command = world.add_subcommand("convert", "Writes a world or maze in another format");
  auto from = std::make_shared<std::string>();
  auto to = std::make_shared<std::string>();
  auto overwrites = std::make_shared<bool>(false);
  command->add_option("FILE", *from, "World, maze or scenario")->required()->type_name("WORLD");
  command
      ->add_option(
          "OUTPUT", *to,
          "Its ending says the format: .maz, as EyeSim draws mazes; .txt, with posts; .num, "
          "a list of cells; .wld, walls")
      ->required()
      ->type_name("FILE");
  command->add_flag("--overwrite", *overwrites, "Replaces a file that is there");
  const auto flags = add_cell_flag(*command);
  command->callback([=, &code] { code = convert(*from, *to, *flags, *overwrites); });
}

}  // namespace eyebridge::apps
