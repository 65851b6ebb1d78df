#include "vision/aruco.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#if EYEBRIDGE_NEW_ARUCO
#include <opencv2/objdetect/charuco_detector.hpp>
#else
#include <opencv2/aruco/charuco.hpp>
#endif

namespace eyebridge::camera {
namespace {

/// AprilTags are upside down in OpenCV's dictionaries: half a turn makes them as they are printed.
bool is_turned(FiducialFamily family) { return family != FiducialFamily::Aruco5x5; }

/// As OpenCV's functions take it: an object, before 4.7 a pointer to one.
const auto& dictionary(FiducialFamily family = FiducialFamily::Aruco5x5) {
  static const auto kAruco = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_5X5_1000);
  static const auto k36h11 = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_36h11);
  static const auto k25h9 = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_25h9);
  static const auto k16h5 = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_16h5);
  switch (family) {
    case FiducialFamily::Tag36h11:
      return k36h11;
    case FiducialFamily::Tag25h9:
      return k25h9;
    case FiducialFamily::Tag16h5:
      return k16h5;
    case FiducialFamily::Aruco5x5:
      break;
  }
  return kAruco;
}

#if EYEBRIDGE_NEW_ARUCO

const cv::aruco::Dictionary& codes(FiducialFamily family) { return dictionary(family); }

cv::aruco::CharucoBoard charuco(const Board& board) {
  cv::aruco::CharucoBoard pattern({board.columns, board.rows}, static_cast<float>(board.square),
                                  static_cast<float>(kCharucoFiducial * board.square),
                                  dictionary());
  pattern.setLegacyPattern(true);  // the square at the lower left is black, as before 4.7
  return pattern;
}

std::vector<cv::Point3f> corners_of(const cv::aruco::CharucoBoard& pattern) {
  return pattern.getChessboardCorners();
}

void detect_board(const cv::aruco::CharucoBoard& pattern, const cv::Mat& grey,
                  std::vector<cv::Point2f>& pixels, std::vector<int>& ids) {
  cv::aruco::CharucoDetector(pattern).detectBoard(grey, pixels, ids);
}

#else

const cv::aruco::Dictionary& codes(FiducialFamily family) { return *dictionary(family); }

cv::Ptr<cv::aruco::CharucoBoard> charuco(const Board& board) {
  return cv::aruco::CharucoBoard::create(
      board.columns, board.rows, static_cast<float>(board.square),
      static_cast<float>(kCharucoFiducial * board.square), dictionary());
}

std::vector<cv::Point3f> corners_of(const cv::Ptr<cv::aruco::CharucoBoard>& pattern) {
  return pattern->chessboardCorners;
}

void detect_board(const cv::Ptr<cv::aruco::CharucoBoard>& pattern, const cv::Mat& grey,
                  std::vector<cv::Point2f>& pixels, std::vector<int>& ids) {
  const Squares squares = find_squares(grey, {}, FiducialFamily::Aruco5x5);
  if (squares.ids.empty()) return;
  cv::aruco::interpolateCornersCharuco(squares.corners, squares.ids, grey, pattern, pixels, ids);
}

#endif

}  // namespace

FiducialBits bits_of(FiducialFamily family, int id) {
  if (id < 0 || id >= count_of(family)) {
    throw std::out_of_range("no fiducial " + std::to_string(id) + ", expected 0 to " +
                            std::to_string(count_of(family) - 1));
  }
  const int cells = cells_of(family);
  const int code_cells = cells - 2;
  const cv::Mat code =
      cv::aruco::Dictionary::getBitsFromByteList(codes(family).bytesList.row(id), code_cells);
  FiducialBits bits(static_cast<std::size_t>(cells * cells));
  for (int row = 0; row < code_cells; ++row) {
    for (int column = 0; column < code_cells; ++column) {
      bits[static_cast<std::size_t>((row + 1) * cells + column + 1)] =
          is_turned(family) ? code.at<std::uint8_t>(code_cells - 1 - row, code_cells - 1 - column)
                            : code.at<std::uint8_t>(row, column);
    }
  }
  return bits;
}

Squares find_squares(const cv::Mat& grey, const cv::aruco::DetectorParameters& parameters,
                     FiducialFamily family) {
  Squares found;
#if EYEBRIDGE_NEW_ARUCO
  cv::aruco::ArucoDetector(dictionary(family), parameters)
      .detectMarkers(grey, found.corners, found.ids);
#else
  cv::aruco::detectMarkers(grey, dictionary(family), found.corners, found.ids,
                           cv::makePtr<cv::aruco::DetectorParameters>(parameters));
#endif
  if (is_turned(family)) {
    for (auto& corners : found.corners)
      std::rotate(corners.begin(), corners.begin() + 2, corners.end());
  }
  return found;
}

BoardCorners charuco_corners(const Board& board, const cv::Mat& grey) {
  const auto pattern = charuco(board);
  BoardCorners found;
  std::vector<int> ids;
  detect_board(pattern, grey, found.pixels, ids);
  const std::vector<cv::Point3f> corners = corners_of(pattern);
  for (const int id : ids) found.on_board.push_back(corners[static_cast<std::size_t>(id)]);
  return found;
}

}  // namespace eyebridge::camera
