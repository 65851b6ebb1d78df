#include "eyebridge/localisation/pose_estimate.hpp"

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"

namespace eyebridge::localisation {
namespace {

TEST(NormalisedErrorSquared, IsMahalanobissDistanceSquaredOverTheShorterWayRound) {
  PoseEstimate estimate;
  estimate.pose = {1, 2, kPi - 0.01};
  estimate.covariance = diagonal<3>({0.01, 0.04, 0.0001});
  const auto nees = normalised_error_squared(estimate, {1.1, 2.4, -kPi + 0.01});
  ASSERT_TRUE(nees);
  EXPECT_NEAR(*nees, 1 + 4 + 4, 1e-9);
  EXPECT_FALSE(normalised_error_squared({}, {}));
}

}  // namespace
}  // namespace eyebridge::localisation
