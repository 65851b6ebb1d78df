#pragma once

#include <QString>
#include <array>

#include "eyebridge/base/pose.hpp"
#include "plan/viewport.hpp"

class QPainter;

namespace eyebridge::gui {

/// Of x, y and heading, row by row: m^2, m rad, rad^2; see hal::HandLook.
using PoseCovariance = std::array<double, 9>;

/// Half axes of the ellipse that holds the true place in 95 of 100 cases, and where its longer one
/// points.
struct UncertaintyEllipse {
  double major = 0.0;    ///< Metres.
  double minor = 0.0;    ///< Metres.
  double heading = 0.0;  ///< Of the longer one in the world, radians.
};

/// A covariance that is none (not finite, negative) gives no ellipse: all is 0.
UncertaintyEllipse ellipse_of(const PoseCovariance& covariance);

/// Draws that ellipse round `pose`, and the wedge of headings that are as likely. One that is
/// smaller than some pixels is drawn as big as that: it is to be seen.
void paint_uncertainty(QPainter& painter, const Viewport& view, const Pose& pose,
                       const PoseCovariance& covariance);

/// "x 1200 ± 3 mm, y 350 ± 2 mm, 45.0 ± 0.5°": two standard deviations each.
QString pose_text(const Pose& pose, const PoseCovariance& covariance);

}  // namespace eyebridge::gui
