#include <cmath>
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
#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/calibration.hpp"
#include "eyebridge/camera/calibrator.hpp"
#include "eyebridge/camera/png.hpp"
#include "eyebridge/camera/sheet.hpp"
#include "eyebridge/camera/source.hpp"
#include "source_clock.hpp"

namespace eyebridge::apps {
namespace {

constexpr Time kPatience{2'000'000'000};  ///< For a single frame.
/// Of the picture, that the views should have reached before they are enough.
constexpr double kEnoughCoverage = 0.6;

struct CalibrateOptions {
  std::string camera;
  std::string board = "chessboard:9x6";
  std::string square = "25mm";
  std::string out;
  std::string print;
  int views = 15;
  double seconds = 180.0;
};

int print_board(const camera::Board& board, const std::filesystem::path& path) {
  if (path.extension() == ".png") {
    camera::write_png(camera::draw_page(board, camera::kPixelsPerMm), path);
  } else if (path.extension() == ".pdf") {
    camera::write_pdf(board, path);
  } else {
    throw ConfigError(
        {"--print"},
        fmt::format("found {}, expected a name that ends in .pdf or .png", path.string()));
  }
  std::printf("%s: print it at 100 %%, and stick it on something flat\n", path.c_str());
  return kFine;
}

/// Takes frames until there are enough views; why it ended before, or nothing.
std::string collect(const CalibrateOptions& options, camera::Source& source, const Clock& clock,
                    camera::Calibrator& calibrator) {
  const Time end = from_seconds(options.seconds);
  while (clock.now() < end) {
    const Result<camera::FramePtr> frame = source.next(clock.now() + kPatience);
    if (!frame) return frame.error().what;
    const Result<camera::BoardView> view = calibrator.take(**frame);
    if (!view) return view.error().what;
    if (*view != camera::BoardView::Kept) continue;
    std::printf("view %d of %d, %.0f %% of the picture reached\n", calibrator.views(),
                options.views, 100.0 * calibrator.coverage());
    std::fflush(stdout);
    if (calibrator.views() >= options.views && calibrator.coverage() >= kEnoughCoverage) return "";
  }
  return fmt::format("{:g} s are over", options.seconds);
}

int calibrate(const CalibrateOptions& options, const camera::Board& board) {
  if (options.camera.empty()) throw ConfigError({"--camera"}, "expected a camera, or --print FILE");
  if (options.out.empty())
    throw ConfigError({"--out"}, "expected the file to write, such as cam.toml");
  if (options.camera.find("calibration=") != std::string::npos) {
    throw ConfigError({"--camera"}, "found a calibration, expected the camera as it is");
  }
  try {
    camera::check_calibration_place(options.out);  // before minutes of work
  } catch (const ConfigError& error) {
    throw ConfigError({"--out"}, error.text());
  }
  const std::unique_ptr<Clock> clock = clock_for(options.camera);
  const auto calibrator = camera::make_calibrator(board);
  const auto source = camera::open_source(options.camera, {clock.get(), nullptr, nullptr});
  std::printf(
      "hold the board into the picture: near and far, in all corners, slanted to all sides\n");
  std::fflush(stdout);
  const std::string ended = collect(options, *source, *clock, *calibrator);
  const Result<camera::Calibration> lens = calibrator->solve();
  if (!lens) {
    tell("no calibration: " + lens.error().what +
         (ended.empty() ? "" : "; it ended because: " + ended));
    return kFailed;
  }
  if (!ended.empty()) tell("ended early: " + ended);
  camera::write_calibration(*lens, options.out);
  const double across = 2.0 * std::atan(0.5 * lens->size.width / lens->fx);
  std::printf("%s: %dx%d pixels, error %.2f pixels by %d views, %.1f degrees across\n",
              options.out.c_str(), lens->size.width, lens->size.height, lens->error,
              calibrator->views(), rad_to_deg(across));
  return kFine;
}

}  // namespace

void add_camera_calibrate(CLI::App& camera, int& code) {
  CLI::App* command = camera.add_subcommand(
      "calibrate",
      "Measures a camera's lens with a printed board, for --camera …?calibration=FILE");
  auto options = std::make_shared<CalibrateOptions>();
  command->add_option("--camera", options->camera, "The camera, as for eyebridge run")
      ->type_name("CAMERA");
  command->add_option("--board", options->board,
                      "chessboard:9x6 (inner corners) or charuco:5x7 (squares)");
  command->add_option("--square", options->square, "Edge of a square [25mm]");
  command->add_option("--out", options->out, "The calibration to write (TOML)")->type_name("FILE");
  command->add_option("--print", options->print, "Writes the board to FILE.pdf or .png instead")
      ->type_name("FILE");
  command->add_option("--views", options->views, "Different views that are enough [15]")
      ->check(CLI::Range(6, 200));
  command->add_option("--seconds", options->seconds, "Gives up after so long [180]")
      ->check(CLI::Range(1.0, 3600.0));
  command->callback([options, &code] {
    const double square = parse_length(options->square, {"--square"}, 0.001, 1.0);
    const camera::Board board = camera::parse_board(options->board, square);
    code = options->print.empty() ? calibrate(*options, board) : print_board(board, options->print);
  });
}

}  // namespace eyebridge::apps
