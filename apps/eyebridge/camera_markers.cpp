#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "camera_commands.hpp"
#include "command.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/length.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/fiducials.hpp"
#include "eyebridge/camera/png.hpp"
#include "eyebridge/camera/sheet.hpp"
#include "eyebridge/files/load.hpp"

namespace eyebridge::apps {
namespace {

struct MarkerOptions {
  std::string world;
  std::string out;
  std::string size = "80mm";
  std::string spacing = "360mm";
  std::string height;
  std::string family = "aruco";
  int page = 1;
};

int write_sheet(const MarkerOptions& options) {
  const std::filesystem::path out(options.out);
  const bool picture = out.extension() == ".png";
  if (!picture && out.extension() != ".pdf") {
    throw ConfigError(
        {"--out"}, fmt::format("found {}, expected a name that ends in .pdf or .png", options.out));
  }
  camera::FiducialLayout layout;
  layout.size =
      parse_length(options.size, {"--size"}, camera::kSmallestFiducial, camera::kLargestPrinted);
  layout.spacing = parse_length(options.spacing, {"--spacing"}, 0.02, 100.0);
  if (!options.height.empty())
    layout.height = parse_length(options.height, {"--height"}, 0.01, 10.0);
  const auto family = camera::family_named(options.family);
  if (!family) {
    throw ConfigError({"--family"}, fmt::format("found {}, expected {}", in_quotes(options.family),
                                                camera::kFamilyWords));
  }
  layout.family = *family;
  // Only the walls count: the smallest robot, so that none is too large for a start.
  const files::Scenario scenario = files::load_scenario(options.world, {.robot = ""});
  for (const Warning& warning : scenario.warnings) {
    tell(warning.str());
  }
  const auto fiducials = camera::place_fiducials(scenario.world, layout);
  if (fiducials.empty()) {
    throw ConfigError({options.world},
                      "has no wall that fiducials fit on, expected walls at least 20 mm long and "
                      "high");
  }
  const camera::FiducialSheet sheet{scenario.world, fiducials,
                                    std::filesystem::path(options.world).filename().string()};
  const int pages = camera::pages_of(sheet);
  if (options.page > pages) {
    throw ConfigError({"--page"}, fmt::format("found {}, expected 1 to {}", options.page, pages));
  }
  if (picture) {
    camera::write_png(camera::draw_page(sheet, options.page, camera::kPixelsPerMm), out);
    std::printf("%s: page %d of %d\n", printable(out.string()).c_str(), options.page, pages);
    return kFine;
  }
  camera::write_pdf(sheet, out);
  std::printf("%s: %zu fiducials on %d pages: print them at 100 %%\n",
              printable(out.string()).c_str(), fiducials.size(), pages);
  return kFine;
}

}  // namespace

void add_camera_markers(CLI::App& camera, int& code) {
  CLI::App* command = camera.add_subcommand(
      "markers", "Writes a sheet with fiducials for the walls of a world, to print and stick on");
  auto options = std::make_shared<MarkerOptions>();
  command->add_option("--world", options->world, "World, maze or scenario file")
      ->required()
      ->type_name("WORLD");
  command->add_option("--out", options->out, "The sheet: FILE.pdf, or FILE.png for one page")
      ->required()
      ->type_name("FILE");
  command->add_option("--size", options->size, "Edge of the black squares [80mm]");
  command->add_option("--spacing", options->spacing, "One for so much of a long wall [360mm]");
  command->add_option("--height", options->height,
                      "Of the centres above the floor [the middle of the wall]");
  command->add_option("--family", options->family,
                      "aruco, tag36h11, tag25h9 or tag16h5 [aruco, which has the most numbers]");
  command->add_option("--page", options->page, "Page of a .png [1, the map]")
      ->check(CLI::Range(1, 10000));
  command->callback([options, &code] { code = write_sheet(*options); });
}

}  // namespace eyebridge::apps
