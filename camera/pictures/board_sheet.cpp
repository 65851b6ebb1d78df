#include <utility>

#include <fmt/format.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/sheet.hpp"
#include "pictures/paper.hpp"

namespace eyebridge::camera {
namespace {

constexpr Rgb kBoardInk{0, 0, 0};

/// Squares of a board along and down the paper.
struct Squares {
  int columns;
  int rows;
};

Squares squares_of(const Board& board) {
  // A chessboard is counted by its inner corners.
  const int more = board.kind == Board::Kind::Chessboard ? 1 : 0;
  return {board.columns + more, board.rows + more};
}

/// `board` as it lies on the paper: a chessboard that is too broad is turned.
Board laid_out(const Board& board) {
  Board turned = board;
  std::swap(turned.columns, turned.rows);
  const double square = m_to_mm(board.square);
  const double width = Paper::kWidth - 2.0 * Paper::kMargin;
  const double height = Paper::kHeight - 4.0 * Paper::kMargin;
  const auto fits = [&](const Board& way) {
    return squares_of(way).columns * square <= width && squares_of(way).rows * square <= height;
  };
  if (fits(board)) return board;
  if (board.kind == Board::Kind::Chessboard && fits(turned)) return turned;
  const auto [columns, rows] = squares_of(board);
  throw ConfigError(
      {"--board"},
      fmt::format("{} x {} squares of {:g} mm do not fit on A4 paper, expected at most "
                  "{:.0f} x {:.0f} mm: try smaller squares, or fewer columns than rows",
                  columns, rows, square, width, height));
}

void draw(Paper& paper, const Board& board) {
  const auto [columns, rows] = squares_of(laid_out(board));
  const bool charuco = board.kind == Board::Kind::Charuco;
  const double square = m_to_mm(board.square);
  paper.text({Paper::kMargin, 14.0},
             fmt::format("eyebridge camera calibrate --board {}:{}x{} --square {:g}mm",
                         charuco ? "charuco" : "chessboard", board.columns, board.rows, square),
             4.0, kBoardInk);
  const Vec2 corner{0.5 * (Paper::kWidth - columns * square),
                    20.0 + 0.5 * (Paper::kHeight - 40.0 - rows * square)};
  int id = 0;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Vec2 at = corner + Vec2{column * square, row * square};
      // OpenCV counts rows from below: the square at the lower left is black.
      if ((rows - 1 - row) % 2 == column % 2) {
        paper.fill(at, {square, square}, kBoardInk);
      } else if (charuco) {
        const double margin = 0.5 * (1.0 - kCharucoFiducial) * square;
        paper.fiducial(at + Vec2{margin, margin}, kCharucoFiducial * square,
                       FiducialFamily::Aruco5x5, id++);
      }
    }
  }
  paper.ruler();
}

}  // namespace

void write_pdf(const Board& board, const std::filesystem::path& path) {
  laid_out(board);  // before there is a file
  Paper paper(path);
  draw(paper, board);
  paper.next_page();
  paper.finish();
}

Frame draw_page(const Board& board, double pixels_per_mm) {
  Paper paper(pixels_per_mm);
  draw(paper, board);
  return paper.picture();
}

}  // namespace eyebridge::camera
