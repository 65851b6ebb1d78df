#include "vision/fiducial_detector.hpp"

#include <opencv2/imgproc.hpp>

#include "vision/aruco.hpp"
#include "vision/edge_refinement.hpp"
#include "vision/grey.hpp"

namespace eyebridge::camera {
namespace {

cv::aruco::DetectorParameters parameters() {
  cv::aruco::DetectorParameters p;
  // One threshold instead of three: the others find nothing more (docs/camera.md has figures).
  p.adaptiveThreshWinSizeMin = 15;
  p.adaptiveThreshWinSizeMax = 15;
  p.adaptiveThreshConstant = 5;
  p.minMarkerPerimeterRate = 0.08;
  p.perspectiveRemovePixelPerCell = 4;
  p.errorCorrectionRate = 0.5;
  p.cornerRefinementMethod = cv::aruco::CORNER_REFINE_NONE;  // ours follows
  return p;
}

}  // namespace

std::vector<SeenFiducial> find_fiducials(const Frame& frame, FiducialFamily family) {
  static const auto kParameters = parameters();
  const cv::Mat grey = grey_of(frame);
  // Noise makes thousands of specks, each looked at for a square, and in the dark drowns the edges;
  // their exact places are taken from the picture as it is.
  cv::Mat smooth;
  cv::GaussianBlur(grey, smooth, {3, 3}, 0.0);
  const auto [ids, squares] = find_squares(smooth, kParameters, family);
  std::vector<SeenFiducial> seen;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    SeenFiducial fiducial;
    fiducial.id = ids[i];
    for (std::size_t k = 0; k < 4; ++k) fiducial.corners[k] = {squares[i][k].x, squares[i][k].y};
    fiducial.corners = refined(grey, fiducial.corners, cells_of(family));
    seen.push_back(fiducial);
  }
  return seen;
}

}  // namespace eyebridge::camera
