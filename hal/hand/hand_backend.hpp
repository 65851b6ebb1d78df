#pragma once

#include <memory>

#include "eyebridge/camera/pose_finder.hpp"
#include "eyebridge/camera/source.hpp"
#include "eyebridge/hal/backend.hpp"
#include "hand/instruction.hpp"

namespace eyebridge::hal {

/// What makes a robot one that a person carries.
struct HandParts {
  std::unique_ptr<camera::Source> camera;      ///< On the backend's clock.
  std::unique_ptr<camera::PoseFinder> finder;  ///< Of that camera.
  std::unique_ptr<InstructionSink> display;
};

/// `inner`, a simulated robot, whose place is that of the camera in a person's hand: with every
/// frame it is put where the camera is, less the camera's mounting on the robot (that with servos
/// in their middle, which is where they must be now), so that its other sensors see what is there.
///
/// The drive gives instructions to the person (see HandDrive); there are no motors and no encoders.
/// Devices wait for a robot that is lost within kHandPatience, then fail with Timeout or
/// Disconnected; those of `inner` itself never do. camera_source() gives the program the camera's
/// frames.
/// `inner` has a world and a camera.
std::unique_ptr<Backend> make_hand(std::unique_ptr<Backend> inner, HandParts parts);

}  // namespace eyebridge::hal
