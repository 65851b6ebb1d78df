#include "world_convert.hpp"

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command.hpp"
#include "eyebridge/base/length.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/base/write_file.hpp"
#include "eyebridge/files/foreign_worlds.hpp"
#include "eyebridge/files/map_files.hpp"
#include "eyebridge/files/readers.hpp"
#include "eyebridge/mapping/ground_truth.hpp"
#include "world_reading.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

/// Where a world goes, and how.
struct Target {
  fs::path path;
  double resolution = 0.01;  ///< Of a map, metres a pixel.
};

/// What becomes of a world in a format.
struct Converted {
  std::string text;
  std::vector<std::string> losses;
  fs::path beside{};          ///< A second file, …
  std::string beside_text{};  ///< … and what is in it.
};

Converted converted(files::WrittenWorld written) {
  return {std::move(written.text), std::move(written.losses)};
}

void lose_robots(const files::Scenario& scenario, Converted& out) {
  const std::size_t count = scenario.robots.size();
  if (count > 0) out.losses.push_back(fmt::format("{} robot{}", count, count == 1 ? "" : "s"));
}

Converted as_maze(files::MazeFormat format, const files::Scenario& scenario) {
  Converted out = converted(files::write_maze_as(format, scenario.world));
  lose_robots(scenario, out);
  return out;
}
Converted as_drawing(const files::Scenario& scenario, const Target& /*target*/) {
  return as_maze(files::MazeFormat::Drawing, scenario);
}
Converted as_posts(const files::Scenario& scenario, const Target& /*target*/) {
  return as_maze(files::MazeFormat::Posts, scenario);
}
Converted as_list(const files::Scenario& scenario, const Target& /*target*/) {
  return as_maze(files::MazeFormat::List, scenario);
}
Converted as_svg(const files::Scenario& scenario, const Target& target) {
  return converted(files::write_svg(scenario, target.path.stem().string()));
}
Converted as_sdf(const files::Scenario& scenario, const Target& target) {
  return converted(files::write_sdf(scenario, target.path.stem().string()));
}
Converted as_stage(const files::Scenario& scenario, const Target& target) {
  return converted(files::write_stage(scenario, target.path.stem().string()));
}

Converted as_map(const files::Scenario& scenario, const Target& target) {
  const auto grid = [&] {
    try {
      return mapping::truth_of(scenario.world, {.resolution = target.resolution});
    } catch (const std::invalid_argument& error) {
      throw ConfigError({"--resolution"}, error.what());
    }
  }();
  Converted out;
  out.beside = target.path;
  out.beside.replace_extension(".pgm");
  files::MapTexts texts = files::write_map(grid, out.beside.filename().string());
  out.text = std::move(texts.yaml);
  out.beside_text = std::move(texts.pgm);
  out.losses = files::losses_of_map(scenario);
  return out;
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

Converted as_world(const files::Scenario& scenario, const Target& /*target*/) {
  Converted out;
  world::WorldModel model = scenario.world;
  for (const world::ObjectSpec& object : model.objects) out.losses.push_back("the " + object.name);
  if (!model.markers.empty()) out.losses.push_back(fmt::format("{} markers", model.markers.size()));
  if (model.maze && !model.maze->goals.empty()) out.losses.push_back("the goals of the maze");
  move_to_origin(model, out.losses);
  model.objects.clear();
  model.markers.clear();
  model.maze.reset();
  lose_robots(scenario, out);
  out.text = files::write_world(model);
  return out;
}

constexpr double kFinest = 0.001;  // metres a pixel
constexpr double kCoarsest = 1.0;

struct Format {
  const char* ending;
  Converted (*write)(const files::Scenario& scenario, const Target& target);
};
constexpr auto kFormats = std::to_array<Format>({
    {".maz", as_drawing},
    {".txt", as_posts},
    {".num", as_list},
    {".wld", as_world},
    {".svg", as_svg},
    {".sdf", as_sdf},
    {".world", as_stage},
    {".yaml", as_map},
});

const Format& format_of(const fs::path& path) {
  std::string endings;
  for (const Format& format : kFormats) {
    if (path.extension() == format.ending) return format;
    endings += fmt::format("{}{}", endings.empty() ? "" : ", ", format.ending);
  }
  throw ConfigError({path.string()}, "unknown kind of file: expected " + endings);
}

void need_free(const fs::path& path, bool overwrites) {
  std::error_code error;
  if (!overwrites && fs::exists(fs::symlink_status(path, error))) {
    throw ConfigError({path.string()}, "is there already: expected another name, or --overwrite");
  }
}

void write(const fs::path& path, const std::string& text) {
  if (const auto done = write_file(path, text); !done) {
    throw ConfigError({path.string()}, done.error().what);
  }
  std::printf("%s\n", printable(path.string()).c_str());
}

int convert(const fs::path& from, const Target& target, const ReadingFlags& flags,
            bool overwrites) {
  const fs::path& to = target.path;
  const Format& format = format_of(to);
  need_free(to, overwrites);
  const files::Scenario scenario = files::load_scenario(from, flags.options());
  for (const Warning& warning : scenario.warnings) tell(warning.str());
  const Converted out = format.write(scenario, target);
  for (const std::string& loss : out.losses) {
    tell(fmt::format("{}: warning: not carried over: {}", to.string(), loss));
  }
  if (!out.beside.empty()) {
    need_free(out.beside, overwrites);
    write(out.beside, out.beside_text);
  }
  write(to, out.text);
  return kFine;
}

}  // namespace

void add_world_convert(CLI::App& world, int& code) {
  CLI::App* command = world.add_subcommand("convert", "Writes a world or maze in another format");
  auto from = std::make_shared<std::string>();
  auto to = std::make_shared<std::string>();
  auto resolution = std::make_shared<std::string>("10mm");
  auto overwrites = std::make_shared<bool>(false);
  command->add_option("FILE", *from, "World, maze, map, drawing or scenario")
      ->required()
      ->type_name("WORLD");
  command
      ->add_option(
          "OUTPUT", *to,
          "Its ending says the format: .maz, as EyeSim draws mazes; .txt, with posts; .num, "
          "a list of cells; .wld, walls; .svg, a drawing; .yaml, a map of ROS with its .pgm; "
          ".world, of Stage; .sdf, of Gazebo")
      ->required()
      ->type_name("FILE");
  command->add_option("--resolution", *resolution, "Size of a map's pixels [10mm]")
      ->type_name("LENGTH");
  command->add_flag("--overwrite", *overwrites, "Replaces a file that is there");
  const auto flags = add_cell_flag(*command);
  command->callback([=, &code] {
    const double metres = parse_length(*resolution, {"--resolution"}, kFinest, kCoarsest);
    code = convert(*from, {*to, metres}, *flags, *overwrites);
  });
}

}  // namespace eyebridge::apps
