#pragma once

#include <vector>

// The ArUco interface of OpenCV 4.7 and newer, or the older one of its contrib package. Only
// aruco.* knows which of them it is.
#if __has_include(<opencv2/objdetect/aruco_detector.hpp>)
#include <opencv2/objdetect/aruco_detector.hpp>
#define EYEBRIDGE_NEW_ARUCO 1
#else
#include <opencv2/aruco.hpp>
#define EYEBRIDGE_NEW_ARUCO 0
#endif

#include "eyebridge/camera/fiducials.hpp"
#include "vision/board_finder.hpp"

namespace eyebridge::camera {

/// As fiducial_bits().
FiducialBits bits_of(FiducialFamily family, int id);

/// Fiducials in a picture: four corners each, clockwise from their own upper left one.
struct Squares {
  std::vector<int> ids;
  std::vector<std::vector<cv::Point2f>> corners;
};

Squares find_squares(const cv::Mat& grey, const cv::aruco::DetectorParameters& parameters,
                     FiducialFamily family);

/// The inner corners of a ChArUco board that the picture shows.
BoardCorners charuco_corners(const Board& board, const cv::Mat& grey);

}  // namespace eyebridge::camera
