#include "eyebridge/base/pose.hpp"

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"

namespace eyebridge {
namespace {

TEST(Pose, TransformTurnsThenShifts) {
  const Pose frame{1.0, 2.0, kPi / 2};
  const Pose world = transform(frame, {0.5, 0.25, kPi});
  EXPECT_NEAR(world.x, 0.75, 1e-15);
  EXPECT_NEAR(world.y, 2.5, 1e-15);
  EXPECT_NEAR(world.theta, -kPi / 2, 1e-15);
}

TEST(Heading, TurningAddsAngles) {
  const Heading h = Heading::from_angle(deg_to_rad(170)).turned(Heading::from_angle(0.5));
  EXPECT_NEAR(h.angle(), deg_to_rad(170) + 0.5 - 2 * kPi, 1e-15);
}

TEST(Heading, RotateTakesForwardToTheHeading) {
  const Heading h = Heading::from_angle(2.0);
  EXPECT_EQ(h.rotate({1, 0}), h.forward());
}

}  // namespace
}  // namespace eyebridge
