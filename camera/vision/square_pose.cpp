#include <cmath>

#include <opencv2/calib3d.hpp>

#include "vision/fiducial_detector.hpp"

namespace eyebridge::camera {

std::vector<SquarePose> square_poses(const Corners& corners, double size) {
  const double half = 0.5 * size;
  // The order that the method asks for.
  const std::vector<cv::Point3d> square{
      {-half, half, 0.0}, {half, half, 0.0}, {half, -half, 0.0}, {-half, -half, 0.0}};
  std::vector<cv::Point2d> seen;
  for (const Vec2 corner : corners) seen.emplace_back(corner.x, corner.y);
  std::vector<cv::Mat> rotations;
  std::vector<cv::Mat> translations;
  std::vector<double> errors;
  try {
    cv::solvePnPGeneric(square, seen, cv::Matx33d::eye(), cv::noArray(), rotations, translations,
                        false, cv::SOLVEPNP_IPPE_SQUARE, cv::noArray(), cv::noArray(), errors);
  } catch (const cv::Exception&) {
    return {};  // corners on a line: no square
  }
  std::vector<SquarePose> poses;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    cv::Matx33d r;
    cv::Rodrigues(rotations[i], r);
    const cv::Vec3d t(translations[i]);
    const cv::Vec3d at = -(r.t() * t);
    if (!std::isfinite(cv::norm(at))) continue;
    poses.push_back({{at[0], at[1], at[2]},
                     {r(0, 0), r(0, 1), r(0, 2)},
                     {r(2, 0), r(2, 1), r(2, 2)},
                     errors[i]});
  }
  return poses;
}

}  // namespace eyebridge::camera
