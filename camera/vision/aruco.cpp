#include "vision/aruco.hpp"

#include <stdexcept>
#include <string>

#if EYEBRIDGE_NEW_ARUCO
#include <opencv2/objdetect/charuco_detector.hpp>
#else
#include <opencv2/aruco/charuco.hpp>
#endif

namespace eyebridge::camera {
namespace {

/// As OpenCV's functions take it: an object, before 4.7 a pointer to one.
const auto& dictionary() {
  static const auto kDictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_5X5_1000);
  return kDictionary;
}

#if EYEBRIDGE_NEW_ARUCO

const cv::aruco::Dictionary& codes() { return dictionary(); }

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

const cv::aruco::Dictionary& codes() { return *dictionary(); }

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
  const Squares squares = find_squares(grey, {});
  if (squares.ids.empty()) return;
  cv::aruco::interpolateCornersCharuco(squares.corners, squares.ids, grey, pattern, pixels, ids);
}

#endif

}  // namespace

FiducialBits bits_of(int id) {
  if (id < 0 || id >= kFiducials) {
    throw std::out_of_range("no fiducial " + std::to_string(id) + ", expected 0 to " +
                            std::to_string(kFiducials - 1));
  }
  constexpr int kCode = kFiducialCells - 2;
  const cv::Mat code = cv::aruco::Dictionary::getBitsFromByteList(codes().bytesList.row(id), kCode);
  FiducialBits bits{};
  for (int row = 0; row < kCode; ++row) {
    for (int column = 0; column < kCode; ++column) {
      bits[static_cast<std::size_t>((row + 1) * kFiducialCells + column + 1)] =
          code.at<std::uint8_t>(row, column);
    }
  }
  return bits;
}

Squares find_squares(const cv::Mat& grey, const cv::aruco::DetectorParameters& parameters) {
  Squares found;
#if EYEBRIDGE_NEW_ARUCO
  cv::aruco::ArucoDetector(dictionary(), parameters).detectMarkers(grey, found.corners, found.ids);
#else
  cv::aruco::detectMarkers(grey, dictionary(), found.corners, found.ids,
                           cv::makePtr<cv::aruco::DetectorParameters>(parameters));
#endif
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
