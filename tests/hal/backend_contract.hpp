#pragma once

#include <gtest/gtest.h>

#include "rigs.hpp"

namespace eyebridge::hal {

/// What every backend owes a robot program: one suite, one row a backend.
class BackendContract : public testing::TestWithParam<RigCase> {
 protected:
  static Rig make(double wall) { return GetParam().make(wall); }
  static double range_tolerance() { return GetParam().range_tolerance; }
  static double drive_tolerance() { return GetParam().drive_tolerance; }

  /// The front sensor's reading.
  static double front(const Rig& rig) { return rig.backend->range_sensor(1)->read().value(); }
  static Pose odometry(const Rig& rig) { return rig.backend->drive()->odometry().value(); }
};

}  // namespace eyebridge::hal
