#include "vision/board_finder.hpp"

#include <algorithm>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "vision/aruco.hpp"

namespace eyebridge::camera {
namespace {

/// Fewer corners of a ChArUco board say little about the lens.
constexpr std::size_t kFewest = 8;

std::optional<BoardCorners> find_chessboard(const Board& board, const cv::Mat& grey) {
  const cv::Size size(board.columns, board.rows);
  BoardCorners found;
  // Not with CALIB_CB_FAST_CHECK: it misses upright boards whose squares are 12 pixels large.
  if (!cv::findChessboardCorners(grey, size, found.pixels,
                                 cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE)) {
    return std::nullopt;
  }
  // Half the way to the next corner, where they are nearest to each other.
  double nearest = 1e9;
  for (std::size_t i = 1; i < found.pixels.size(); ++i) {
    nearest = std::min(nearest, cv::norm(found.pixels[i] - found.pixels[i - 1]));
  }
  const int window = std::clamp(static_cast<int>(0.4 * nearest), 2, 11);
  cv::cornerSubPix(grey, found.pixels, {window, window}, {-1, -1},
                   {cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 30, 0.01});
  for (int row = 0; row < board.rows; ++row) {
    for (int column = 0; column < board.columns; ++column) {
      found.on_board.emplace_back(static_cast<float>(column * board.square),
                                  static_cast<float>(row * board.square), 0.0F);
    }
  }
  return found;
}

std::optional<BoardCorners> find_charuco(const Board& board, const cv::Mat& grey) {
  BoardCorners found = charuco_corners(board, grey);
  if (found.pixels.size() < kFewest) return std::nullopt;
  const cv::Point3f first = found.on_board.front();
  // Corners on a line determine no plane.
  if (std::all_of(found.on_board.begin(), found.on_board.end(), [&](const cv::Point3f& corner) {
        return corner.x == first.x || corner.y == first.y;
      })) {
    return std::nullopt;
  }
  return found;
}

}  // namespace

std::optional<BoardCorners> find_board(const Board& board, const cv::Mat& grey) {
  return board.kind == Board::Kind::Chessboard ? find_chessboard(board, grey)
                                               : find_charuco(board, grey);
}

std::vector<cv::Point2f> outline_of(const Board& board) {
  const bool chessboard = board.kind == Board::Kind::Chessboard;
  const auto square = static_cast<float>(board.square);
  const float low = chessboard ? 0.0F : square;
  const float right = static_cast<float>(board.columns - 1) * square;
  const float far = static_cast<float>(board.rows - 1) * square;
  return {{low, low}, {right, low}, {right, far}, {low, far}};
}

}  // namespace eyebridge::camera
