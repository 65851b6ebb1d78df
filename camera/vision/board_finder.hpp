#pragma once

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

#include "eyebridge/camera/calibrator.hpp"

namespace eyebridge::camera {

/// Corners of a board and where a picture shows them.
struct BoardCorners {
  std::vector<cv::Point3f> on_board;  ///< Metres, z = 0.
  std::vector<cv::Point2f> pixels;
};

/// The board in a picture, corners to a fraction of a pixel; none when it is not there, or too
/// little of it.
std::optional<BoardCorners> find_board(const Board& board, const cv::Mat& grey);

/// The four outermost corners that find_board() may give, going round.
std::vector<cv::Point2f> outline_of(const Board& board);

}  // namespace eyebridge::camera
