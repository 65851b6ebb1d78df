#include "eyebridge/camera/calibrator.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "board_painter.hpp"
#include "board_views.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/convert.hpp"
#include "eyebridge/camera/sheet.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::HasSubstr;

constexpr double kPixelsPerMillimetre = 4.0;

Result<Calibration> measured(const Board& board, const Calibration& lens, double distance) {
  const Frame page = draw_page(board, kPixelsPerMillimetre);
  const auto calibrator = make_calibrator(board);
  for (const EyePose& eye : board_views(distance)) {
    const auto view = calibrator->take(look_at_page(page, kPixelsPerMillimetre, lens, eye));
    if (!view) return tl::unexpected(view.error());
  }
  return calibrator->solve();
}

class Boards : public ::testing::TestWithParam<Board> {};

TEST_P(Boards, GiveBackTheLensTheyAreSeenThrough) {
  // The fiducials of a ChArUco board are smaller than the squares of a chessboard.
  const bool charuco = GetParam().kind == Board::Kind::Charuco;
  const Calibration truth = charuco ? scaled(bent_webcam(), {640, 480}) : bent_webcam();
  const auto lens = measured(GetParam(), truth, 0.4);
  ASSERT_TRUE(lens) << lens.error().what;
  EXPECT_NEAR(lens->fx, truth.fx, 0.01 * truth.fx);
  EXPECT_NEAR(lens->fy, truth.fy, 0.01 * truth.fy);
  EXPECT_NEAR(lens->cx, truth.cx, 0.01 * truth.size.width);
  EXPECT_NEAR(lens->cy, truth.cy, 0.01 * truth.size.width);
  EXPECT_NEAR(lens->distortion[0], truth.distortion[0], 0.04);
  EXPECT_LT(lens->error, 0.5);
  EXPECT_EQ(lens->size, truth.size);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Boards,
                         ::testing::Values(Board{Board::Kind::Chessboard, 6, 9, 0.02},
                                           Board{Board::Kind::Charuco, 5, 7, 0.03}),
                         [](const auto& test) {
                           return test.param.kind == Board::Kind::Charuco ? "Charuco"
                                                                          : "Chessboard";
                         });

TEST(Calibrator, KeepsAViewOnce) {
  const Board board{Board::Kind::Chessboard, 6, 9, 0.02};
  const Frame page = draw_page(board, kPixelsPerMillimetre);
  const auto calibrator = make_calibrator(board);
  const EyePose eye = board_views(0.4)[5];
  const Frame frame = look_at_page(page, kPixelsPerMillimetre, bent_webcam(), eye);
  EXPECT_EQ(*calibrator->take(frame), BoardView::Kept);
  EXPECT_EQ(*calibrator->take(frame), BoardView::Same);
  EXPECT_EQ(calibrator->views(), 1);
  EXPECT_GT(calibrator->coverage(), 0.1);
  const Frame empty = make_frame(320, 240, PixelFormat::Grey8);
  EXPECT_EQ(*calibrator->take(empty), BoardView::None);
  const auto other = calibrator->take(make_frame(640, 480, PixelFormat::Grey8));
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().what, HasSubstr("640x480"));
}

TEST(Calibrator, RefusesWhatDeterminesNoLens) {
  const Board board{Board::Kind::Chessboard, 6, 9, 0.02};
  const Frame page = draw_page(board, kPixelsPerMillimetre);
  const auto calibrator = make_calibrator(board);
  EXPECT_THAT(calibrator->solve().error().what, HasSubstr("found 0 different views"));
  for (const std::size_t i : {1U, 5U, 9U}) {
    calibrator->take(look_at_page(page, kPixelsPerMillimetre, bent_webcam(), board_views(0.4)[i]));
  }
  const auto lens = calibrator->solve();
  ASSERT_FALSE(lens);
  EXPECT_THAT(lens.error().what, HasSubstr("found 3 different views"));
}

TEST(ParseBoard, TakesBothKinds) {
  EXPECT_EQ(parse_board("chessboard:9x6", 0.025), (Board{Board::Kind::Chessboard, 9, 6, 0.025}));
  EXPECT_EQ(parse_board("charuco:5x7", 0.03), (Board{Board::Kind::Charuco, 5, 7, 0.03}));
}

TEST(ParseBoard, RefusesAllElse) {
  for (const char* text : {"", "chessboard", "chessboard:", "chessboard:9", "chessboard:9x",
                           "chessboard:x6", "chessboard:2x6", "chessboard:9x99", "circles:9x6",
                           "chessboard:9x6x3", "chessboard:-9x6"}) {
    EXPECT_THROW(parse_board(text, 0.025), ConfigError) << text;
  }
  EXPECT_THROW(parse_board("chessboard:9x6", 0.0), ConfigError);
  EXPECT_THROW(parse_board("chessboard:9x6", 2.0), ConfigError);
}

}  // namespace
}  // namespace eyebridge::camera::testing
