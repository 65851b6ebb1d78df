#pragma once

#include "eyebridge/hal/drive.hpp"
#include "sim/repeats.hpp"
#include "sim/sim_device.hpp"

namespace eyebridge::hal {

/// The v-omega drive of a simulated robot. Numbers that are not finite are OutOfRange.
class SimDrive final : public Drive, private SimDevice {
 public:
  using SimDevice::SimDevice;

  Result<void> set_speed(const Twist& twist) override;
  Result<void> start(const DriveGoal& goal) override;
  Result<DriveStatus> status() override;
  Result<Twist> measured_twist() override;
  Result<Pose> odometry() override;
  Result<void> set_odometry(const Pose& pose) override;

 private:
  /// A command comes: looks whether the program does the same for ever. The world is locked.
  void look_for_repeats(const robot::Simulation& simulation);

  Repeats repeats_;  ///< Guarded by the world's lock.
};

}  // namespace eyebridge::hal
