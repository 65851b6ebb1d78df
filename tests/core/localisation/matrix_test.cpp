#include "eyebridge/localisation/matrix.hpp"

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::localisation {
namespace {

TEST(Matrix, MultipliesAddsAndTransposes) {
  const Matrix<2, 3> a{{1, 2, 3, 4, 5, 6}};
  const Matrix<3, 2> b{{7, 8, 9, 10, 11, 12}};
  EXPECT_EQ(a * b, (Matrix2{{58, 64, 139, 154}}));
  EXPECT_EQ(transposed(a), (Matrix<3, 2>{{1, 4, 2, 5, 3, 6}}));
  EXPECT_EQ(a + a, 2.0 * a);
  EXPECT_EQ(a - a, (Matrix<2, 3>{}));
  EXPECT_EQ(diagonal<2>({3, 4}), (Matrix2{{3, 0, 0, 4}}));
}

TEST(Matrix, TimesItsInverseIsOne) {
  Random random(6);
  for (int round = 0; round < 500; ++round) {
    Matrix3 root;
    for (double& cell : root.cells) cell = random.gaussian();
    const Matrix3 a = root * transposed(root) + diagonal<3>({0.1, 0.1, 0.1});
    const auto inverse = inverse_of(a);
    ASSERT_TRUE(inverse);
    const Matrix3 product = a * *inverse;
    for (std::size_t i = 0; i < 9; ++i) {
      ASSERT_NEAR(product.cells[i], i % 4 == 0 ? 1.0 : 0.0, 1e-11);
    }
  }
}

TEST(Matrix, HasNoInverseUnlessItIsPositiveDefinite) {
  EXPECT_FALSE(inverse_of(Matrix2{{1, 2, 2, 4}}));
  EXPECT_FALSE(inverse_of(Matrix2{{1, 2, 2, 1}}));
  EXPECT_FALSE(inverse_of(Matrix3{}));
}

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
