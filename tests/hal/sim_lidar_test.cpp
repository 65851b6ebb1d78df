// The lidar of a simulated robot: what a tilted model and noise do to its scans.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "rigs.hpp"
#include "shared/open_only.hpp"

namespace eyebridge::hal {
namespace {

using testing::DoubleNear;
using testing::Each;

constexpr double kTilt = kPi / 6;

/// The rig's backend with a lidar that its model tilts down, and with `bias` and `sigma` metres.
Rig tilted_rig(double bias, double sigma) {
  files::Scenario scenario = rig_scenario(0.5);
  robot::LidarModel& model = *scenario.models.front().lidar;
  model.tilt = kTilt;
  model.error = {{bias, sigma, 0.0}};
  Rig rig;
  rig.log = std::make_unique<KeepingLog>();
  const Config config = rig_config({{"fast", "true"}});
  rig.backend = open_scenario(std::move(scenario), {"rig"}, {config, *rig.log});
  return rig;
}

TEST(SimLidar, TiltsOnceWhatItsModelTilts) {
  const Rig rig = tilted_rig(0.0, 0.0);
  Lidar* lidar = rig.backend->lidar();
  EXPECT_EQ(lidar->shape().tilt, kTilt);
  std::vector<double> ranges(8);
  ASSERT_TRUE(lidar->read(ranges));
  EXPECT_THAT(ranges, Each(DoubleNear(2 * rig_model().lidar->height, 1e-9)));
}

TEST(SimLidar, ATiltOfItsModelCanBeUndone) {
  const Rig rig = tilted_rig(0.0, 0.0);
  Lidar* lidar = rig.backend->lidar();
  ASSERT_TRUE(lidar->configure(1.0, 0.0, 1));
  double range = 0.0;
  ASSERT_TRUE(lidar->read({&range, 1}));
  EXPECT_NEAR(range, 0.5 + kFrontOffset, 1e-9);
}

TEST(SimLidar, AddsItsErrorToTheTiltedRangeUnchanged) {
  const Rig biased = tilted_rig(0.05, 0.0);
  std::vector<double> ranges(8);
  ASSERT_TRUE(biased.backend->lidar()->read(ranges));
  EXPECT_THAT(ranges, Each(DoubleNear(2 * rig_model().lidar->height + 0.05, 1e-9)));

  const Rig noisy = tilted_rig(0.0, 0.01);
  constexpr int kCount = 4000;
  std::vector<double> many(kCount);
  ASSERT_TRUE(noisy.backend->lidar()->configure(2 * kPi, kTilt, kCount));
  ASSERT_TRUE(noisy.backend->lidar()->read(many));
  double sum = 0.0;
  double squares = 0.0;
  for (const double range : many) {
    const double off = range - 2 * rig_model().lidar->height;
    sum += off;
    squares += off * off;
  }
  EXPECT_NEAR(sum / kCount, 0.0, 0.001);  // neither the floor nor a second tilt clips the noise
  EXPECT_NEAR(std::sqrt(squares / kCount), 0.01, 0.001);
}

TEST(SimLidar, MessagesSayTheValueAsItIs) {
  const Rig rig = tilted_rig(0.0, 0.0);
  EXPECT_EQ(rig.backend->servo(1)->set(-1e-9).error().what,
            "servo: got -1e-09, expected a position of 0 … 1");
  EXPECT_EQ(rig.backend->lidar()->configure(1.0, 0.0, 0).error().what,
            "lidar: got 0, expected 1 … 36000 points");
}

}  // namespace
}  // namespace eyebridge::hal
