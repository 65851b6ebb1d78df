#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "eyebridge/base/log.hpp"
#include "eyebridge/base/pose.hpp"
#include "eyebridge/camera/calibration.hpp"
#include "eyebridge/camera/fiducials.hpp"

namespace eyebridge::camera {

/// Where a camera stood when a frame was taken.
struct FoundPose {
  Time time{0};    ///< Of that frame.
  Pose pose;       ///< Below the camera on the floor; heading of its axis. World, m and radians.
  double z = 0.0;  ///< Of the camera above the floor, metres.
  double pitch = 0.0;                  ///< Of its axis, radians, up positive.
  double roll = 0.0;                   ///< About its axis, radians, clockwise positive.
  std::array<double, 9> covariance{};  ///< Of x, y and heading, row by row; m^2, m rad, rad^2.
  int fiducials = 0;                   ///< How many it was found by; 0: carried on from before.
};

/// Finds a camera's pose in the world from what it sees. One thread at a time.
class PoseFinder {
 public:
  virtual ~PoseFinder() = default;

  /// The next frame; frames come in the order of their times. The pose after it, smoothed; none
  /// while the camera is lost.
  virtual std::optional<FoundPose> take(const Frame& frame) = 0;
  /// All fiducials in the last frame, those of other worlds, too. Valid until the next one.
  [[nodiscard]] virtual const std::vector<SeenFiducial>& seen() const = 0;
};

/// By the fiducials `map`, seen through `lens` (scaled to each frame's size; a pinhole for frames
/// that are undistorted already). Loads the vision library. The camera is held about upright, and
/// is lost when no usable fiducial was seen for 0.3 s; until then its motion is carried on.
/// Fiducials that do not fit together (of another world, or moved) are said once to `log`, which
/// outlives the finder; `world` is what they should fit, as messages name it. Throws ConfigError
/// for an empty map or lens.
std::unique_ptr<PoseFinder> make_fiducial_finder(const std::vector<Fiducial>& map,
                                                 const Calibration& lens, LogSink& log,
                                                 std::string_view world = "this world");

}  // namespace eyebridge::camera
