#include "world_list.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/one_line.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/files/load.hpp"
#include "eyebridge/files/readers.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> kWorldEndings = {".maz", ".p", ".sim", ".wld"};

struct WorldLine {
  std::string name;
  std::string size;
  std::string description;
};

/// A world that cannot be read is listed all the same: with what is wrong.
WorldLine world_line_of(const fs::path& path) {
  WorldLine line{path.filename().string(), "", ""};
  try {
    const files::Scenario scenario = files::load_scenario(path, {.robot = ""});
    line.size = size_text(scenario);
    if (path.extension() == ".sim") {
      line.size += fmt::format(", {}", robots_text(scenario));
    }
    line.description = files::description_in(files::read_text_file(path));
  } catch (const ConfigError& error) {
    line.size = "cannot be read";
    line.description = error.what();
  }
  return line;
}

std::vector<fs::path> worlds_in(const fs::path& folder) {
  std::vector<fs::path> out;
  std::error_code error;
  for (fs::directory_iterator file(folder, error), end; !error && file != end;
       file.increment(error)) {
    const std::string ending = file->path().extension().string();
    if (std::ranges::find(kWorldEndings, ending) != kWorldEndings.end())
      out.push_back(file->path());
  }
  std::ranges::sort(out);
  return out;
}

/// Prints the worlds of one place; a name that an earlier place has as well is never found here.
void print_place(const char* what, const fs::path& folder, std::set<std::string>& taken) {
  std::printf("%s: %s\n", what, printable(folder.string()).c_str());
  std::vector<WorldLine> lines;
  std::size_t name_width = 0;
  std::size_t size_width = 0;
  for (const fs::path& path : worlds_in(folder)) {
    WorldLine line = world_line_of(path);
    if (!taken.insert(line.name).second) {
      line.description = "hidden by the world of this name above";
    }
    name_width = std::max(name_width, line.name.size());
    size_width = std::max(size_width, line.size.size());
    lines.push_back(std::move(line));
  }
  if (lines.empty()) std::puts("  no worlds");
  for (const WorldLine& line : lines) {
    const std::string text = fmt::format("  {:{}}  {:{}}  {}", line.name, name_width, line.size,
                                         size_width, line.description);
    // A line each, whatever the files are called.
    std::printf("%s\n", printable(escaped(text.substr(0, text.find_last_not_of(' ') + 1))).c_str());
  }
}

int list_worlds(const std::string& program) {
  const auto places = files::SearchPlaces::of_process(program);
  std::set<std::string> taken;
  print_place("Working folder", fs::current_path(), taken);
  if (!places.eyesim_home.empty()) print_place("EYESIM_HOME", places.eyesim_home, taken);
  if (!places.program.empty()) print_place("Beside the program", places.program, taken);
  if (!places.user.empty()) print_place("Yours", places.user, taken);
  if (places.installed.empty()) {
    throw ConfigError({"world list"},
                      "EyeBridge's own worlds are not here: the installation is not complete");
  }
  print_place("Installed", places.installed, taken);
  return kFine;
}

}  // namespace

std::string size_text(const files::Scenario& scenario) {
  const world::WorldModel& world = scenario.world;
  std::string text = fmt::format("{:g} m x {:g} m", world.width, world.height);
  if (world.maze) {
    text += fmt::format(", {} x {} cells of {:g} m", world.maze->columns, world.maze->rows,
                        world.maze->cell);
  }
  return text;
}

std::string robots_text(const files::Scenario& scenario) {
  const std::size_t count = scenario.robots.size();
  std::string text = fmt::format("{} {}", count, count == 1 ? "robot" : "robots");
  if (!scenario.newcomers.empty()) {
    text += fmt::format(" and {} that enter later", scenario.newcomers.size());
  }
  return text;
}

void add_world_list(CLI::App& world, int& code) {
  CLI::App* command =
      world.add_subcommand("list", "Lists the worlds that can be named, with size and description");
  const auto program = std::make_shared<std::string>();
  command->add_option("--program", *program, "Lists the folder worlds/ beside this program, too")
      ->type_name("FILE");
  command->footer(
      "Places are searched from top to bottom. A description is the comment that a file begins "
      "with.");
  command->callback([program, &code] { code = list_worlds(*program); });
}

}  // namespace eyebridge::apps
