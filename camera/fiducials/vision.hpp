#pragma once

#include <array>
#include <memory>
#include <vector>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/camera/calibrator.hpp"
#include "eyebridge/camera/fiducials.hpp"
#include "eyebridge/camera/frame.hpp"
#include "optics/lens.hpp"

namespace eyebridge::camera {

/// Where a camera is as a square sees it: origin in the square's centre, x to the right and y up as
/// one faces it, z towards the viewer; metres.
struct SquarePose {
  Vec3 position;
  Vec3 right;          ///< Of the picture, unit vector.
  Vec3 forward;        ///< The camera's axis, unit vector.
  double error = 0.0;  ///< Root mean square of the corners' miss on the plane 1 m ahead.
};

/// All that needs OpenCV, behind one table: implemented in ../vision, a library that is opened when
/// it is first asked for, so that programs which see no fiducials load no OpenCV. Any thread.
class Vision {
 public:
  virtual ~Vision() = default;

  /// As fiducial_bits().
  [[nodiscard]] virtual FiducialBits fiducial_bits(FiducialFamily family, int id) const = 0;

  /// All fiducials of `family` in a frame of any format, corners to a fraction of a pixel.
  [[nodiscard]] virtual std::vector<SeenFiducial> find_fiducials(const Frame& frame,
                                                                 FiducialFamily family) const = 0;

  /// The one or two poses from which a square of edge `size` has its corners at `corners`, points
  /// on the plane 1 m in front of the camera (x right, y down); the better first (Collins and
  /// Bartoli, Infinitesimal Plane-Based Pose Estimation, 2014).
  [[nodiscard]] virtual std::vector<SquarePose> square_poses(const Corners& corners,
                                                             double size) const = 0;

  /// As make_calibrator().
  [[nodiscard]] virtual std::unique_ptr<Calibrator> make_calibrator(const Board& board) const = 0;
};

/// The vision library, opened once. Throws ConfigError when it cannot be.
const Vision& vision();

/// What that library exports, as "eyebridge_vision".
using VisionEntry = const Vision*();

}  // namespace eyebridge::camera
