#include "eyebridge/base/matrix.hpp"

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"

namespace eyebridge {
namespace {

TEST(Matrix, MultipliesAddsAndTransposes) {
  const Matrix<2, 3> a{{1, 2, 3, 4, 5, 6}};
  const Matrix<3, 2> b{{7, 8, 9, 10, 11, 12}};
  EXPECT_EQ(a * b, (Matrix<2, 2>{{58, 64, 139, 154}}));
  EXPECT_EQ(transposed(a), (Matrix<3, 2>{{1, 4, 2, 5, 3, 6}}));
  EXPECT_EQ(a + a, 2.0 * a);
  EXPECT_EQ(a - a, (Matrix<2, 3>{}));
  EXPECT_EQ(a * (Vector<3>{1, 0, -1}), (Vector<2>{-2, -2}));
  EXPECT_EQ(diagonal<2>({3, 4}), (Matrix<2, 2>{{3, 0, 0, 4}}));
}

TEST(Matrix, TimesItsInverseIsOne) {
  Random random(6);
  for (int round = 0; round < 500; ++round) {
    Matrix<3, 3> root;
    for (double& cell : root.values) cell = random.gaussian();
    const Matrix<3, 3> a = root * transposed(root) + diagonal<3>({0.1, 0.1, 0.1});
    const auto inverse = inverse_of(a);
    ASSERT_TRUE(inverse);
    const Matrix<3, 3> product = a * *inverse;
    for (std::size_t i = 0; i < 9; ++i) {
      ASSERT_NEAR(product.values[i], i % 4 == 0 ? 1.0 : 0.0, 1e-11);
    }
  }
}

TEST(Matrix, HasNoInverseUnlessItIsPositiveDefinite) {
  EXPECT_FALSE(inverse_of(Matrix<2, 2>{{1, 2, 2, 4}}));
  EXPECT_FALSE(inverse_of(Matrix<2, 2>{{1, 2, 2, 1}}));
  EXPECT_FALSE(inverse_of(Matrix<3, 3>{}));
  const Matrix<2, 2> nearly{{1, 1, 1, 1 + 1e-9}};
  EXPECT_TRUE(inverse_of(nearly));
  EXPECT_FALSE(inverse_of(nearly, 1e-6));
}

}  // namespace
}  // namespace eyebridge
