#pragma once

#include <gtest/gtest.h>

#include "rigs.hpp"

namespace eyebridge::hal {

/// What every backend owes a robot program: one suite, one row a backend.
class BackendContract : public testing::TestWithParam<RigCase> {
 public:
  ~BackendContract() override;

 protected:
  using Lidars = RigTraits::LidarKind;

  /// Where a row is replayed the test's first run, which is recorded.
  void SetUp() override;

  Rig make(double wall) { return make_at(facing(wall)); }
  Rig make_at(const Pose& start);
  /// What the rigs of make() have.
  [[nodiscard]] const RigTraits& traits() const;

  /// The front sensor's reading.
  static double front(const Rig& rig) { return must(rig.backend->range_sensor(1)->read()); }
  static Pose odometry(const Rig& rig) { return must(rig.backend->drive()->odometry()); }
  /// Expects the robot at `pose`, where anybody knows.
  void expect_truly_at(const Rig& rig, const Pose& pose) const;

 private:
  // Declared here, so that SetUp() may call it.
  void TestBody() override = 0;
  /// The recording of the test's rig number `rigs_`.
  [[nodiscard]] std::string recording() const;

  bool rehearsing_ = false;
  int rigs_ = 0;  ///< Made in this run.
  int recordings_ = 0;
};

}  // namespace eyebridge::hal
