#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/base/own_results.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/camera/birdseye.hpp"
#include "eyebridge/camera/png.hpp"
#include "eyebridge/files/load.hpp"
#include "world_convert.hpp"
#include "world_list.hpp"
#include "world_reading.hpp"

namespace eyebridge::apps {
namespace {

std::string counted(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string summary(const files::Scenario& scenario) {
  std::string text = size_text(scenario);
  text += ", " + counted(scenario.world.walls.size(), "wall");
  if (!scenario.robots.empty()) text += ", " + robots_text(scenario);
  text += ", " + counted(scenario.world.objects.size(), "object");
  return text + ", " + counted(scenario.warnings.size(), "warning");
}

/// Goes through all files, so that one bad file does not hide the next.
int check(const std::vector<std::string>& paths, const ReadingFlags& flags) {
  int code = kFine;
  for (const std::string& path : paths) {
    try {
      const files::Scenario scenario = files::load_scenario(path, flags.options());
      std::printf("%s: %s\n", printable(path).c_str(), summary(scenario).c_str());
      for (const Warning& warning : scenario.warnings) {
        std::printf("  %s\n", printable(warning.str()).c_str());
      }
    } catch (const ConfigError& error) {
      tell(error.what());
      code = kBadInput;
    }
  }
  return code;
}

world::Scene scene_of(const files::Scenario& scenario) {
  world::Scene scene;
  scene.model = std::make_shared<const world::WorldModel>(scenario.world);
  std::uint32_t id = 0;
  for (const files::RobotPlacement& placement : scenario.robots) {
    const robot::RobotModel& model = scenario.models.at(placement.model);
    scene.bodies.push_back({id++, world::BodyShape::Robot, placement.pose, model.radius(),
                            model.height, Rgb{60, 120, 200}});
  }
  for (const world::ObjectSpec& object : scenario.world.objects) {
    scene.bodies.push_back(world::view_of(object, id++));
  }
  return scene;
}

int draw(const std::string& path, const std::string& output, int longest_side,
         const ReadingFlags& flags) {
  const files::Scenario scenario = files::load_scenario(path, flags.options());
  for (const Warning& warning : scenario.warnings) {
    tell(warning.str());
  }
  const auto target = output.empty() ? std::filesystem::path(path).stem().concat(".png")
                                     : std::filesystem::path(output);
  if (output.empty()) drop_link(target);  // nobody has said that name
  camera::write_png(camera::draw_birdseye(scene_of(scenario), {}, {.longest_side = longest_side}),
                    target);
  std::printf("%s\n", printable(target.string()).c_str());
  return kFine;
}

}  // namespace

void add_world(CLI::App& root, int& code) {
  CLI::App* world = root.add_subcommand("world", "Lists, checks, draws or converts worlds");
  world->require_subcommand(1);
  add_world_list(*world, code);

  CLI::App* checking = world->add_subcommand("check", "Reads files; names what is wrong or odd");
  auto paths = std::make_shared<std::vector<std::string>>();
  checking->add_option("FILE", *paths, "World, maze, scenario, robot or parameter file")
      ->required()
      ->type_name("WORLD");
  const auto check_flags = add_reading_flags(*checking);
  checking->callback([paths, check_flags, &code] { code = check(*paths, *check_flags); });

  CLI::App* drawing = world->add_subcommand("draw", "Writes a picture of a world seen from above");
  auto path = std::make_shared<std::string>();
  auto output = std::make_shared<std::string>();
  auto side = std::make_shared<int>(camera::BirdseyeOptions{}.longest_side);
  drawing->add_option("FILE", *path, "World, maze, scenario, robot or parameter file")
      ->required()
      ->type_name("WORLD");
  drawing->add_option("-o,--output", *output, "Picture [the file's name with .png, here]")
      ->type_name("FILE");
  drawing->add_option("--size", *side, "Longest side of the picture, pixels [1000]")
      ->check(CLI::Range(50, 8000));
  const auto draw_flags = add_reading_flags(*drawing);
  drawing->callback(
      [path, output, side, draw_flags, &code] { code = draw(*path, *output, *side, *draw_flags); });
  add_world_convert(*world, code);
}

}  // namespace eyebridge::apps
