// `eyebridge camera calibrate` from pictures of a board to a file that sources read.
#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "board_painter.hpp"
#include "board_views.hpp"
#include "command.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/calibrator.hpp"
#include "eyebridge/camera/png.hpp"
#include "eyebridge/camera/sheet.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::run_command;
using testing::ScratchFolder;

/// Pictures of a chessboard through a bent lens, as a person would hold it.
void film_board(const std::filesystem::path& folder) {
  constexpr double kPixelsPerMm = 4.0;
  const camera::Board board{camera::Board::Kind::Chessboard, 6, 9, 0.02};
  const camera::Frame page = camera::draw_page(board, kPixelsPerMm);
  int number = 0;
  for (const camera::EyePose& eye : camera::testing::board_views(0.4)) {
    camera::write_png(
        camera::testing::look_at_page(page, kPixelsPerMm, camera::testing::bent_webcam(), eye),
        folder / fmt::format("view{}.png", ++number));
  }
}

TEST(CalibrateCommand, ViewsOfABoardGiveTheLensThatOtherCommandsUse) {
  const ScratchFolder folder;
  film_board(folder.path());
  const ProgramRun run =
      run_command({"camera", "calibrate", "--camera", "frames:.", "--board", "chessboard:9x6",
                   "--square", "20mm", "--views", "12", "--out", "cam.toml"},
                  folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("cam.toml: 320x240 pixels"));
  const camera::Calibration truth = camera::testing::bent_webcam();
  const camera::Calibration lens = camera::read_calibration(folder.path() + "/cam.toml");
  EXPECT_NEAR(lens.fx, truth.fx, 0.01 * truth.fx);
  EXPECT_NEAR(lens.fy, truth.fy, 0.01 * truth.fy);
  EXPECT_NEAR(lens.distortion[0], truth.distortion[0], 0.04);

  const ProgramRun shown = run_command(
      {"camera", "show", "--camera", "frames:.?calibration=cam.toml", "--out", "straight.png"},
      folder.path());
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_EQ(camera::read_png(folder.path() + "/straight.png").width, 320);
}

TEST(CalibrateCommand, ReplacesOnlyACalibration) {
  const ScratchFolder folder;
  const std::string work = folder.write("work.toml", "mine = true\n");
  const ProgramRun run = run_command({"camera", "calibrate", "--camera", "pattern", "--board",
                                      "chessboard:9x6", "--square", "20mm", "--out", "work.toml"},
                                     folder.path());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("--out: cannot write work.toml: found another kind of file"));
  EXPECT_EQ(testing::file_text(work), "mine = true\n");
}

}  // namespace
}  // namespace eyebridge
