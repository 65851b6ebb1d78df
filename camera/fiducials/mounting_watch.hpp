#pragma once

#include <string>
#include <vector>

#include "eyebridge/camera/fiducials.hpp"
#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

class Vision;

/// Notices by the fiducials that a camera is mounted upside down or on its side, or that its
/// pictures are mirrored.
class MountingWatch {
 public:
  /// What to say after this frame, in which `seen`, of `family`, was found: once, after some frames
  /// that agree. Empty: nothing.
  std::string look(const Frame& frame, const std::vector<SeenFiducial>& seen, const Vision& vision,
                   FiducialFamily family);

 private:
  std::string count_turn(const std::vector<SeenFiducial>& seen);
  std::string look_mirrored(const Frame& frame, const Vision& vision, FiducialFamily family);

  int turn_ = 0;  ///< Quarters clockwise that all fiducials of a frame were turned by last.
  int agreeing_ =
      0;           ///< Frames in a row that showed them so. One that shows two ways does not count.
  int empty_ = 0;  ///< Frames without a fiducial, as long as there was no other one.
  int mirrored_ = 0;      ///< Of them, those with one in their mirror image.
  bool is_over_ = false;  ///< It was said, or the pictures are right.
};

}  // namespace eyebridge::camera
