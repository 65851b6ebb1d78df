// The central test: scans, and matrices of ranges. Its rows are in backend_contract_test.cpp.
#include <cmath>

#include <gmock/gmock.h>

#include "backend_contract.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {
namespace {

using testing::DoubleNear;
using testing::Each;

// A robot without a lidar is checked in DevicesThatTheRobotHasAreThere. One that scans as it was
// built takes no tilt but its own.

TEST_P(BackendContract, LidarScansAFullCircleClockwiseFromStraightBehind) {
  const Rig rig = make_at({1.0, 0.7, 0.0});
  Lidar* lidar = rig.backend->lidar();
  ASSERT_EQ(lidar != nullptr, traits().lidar != Lidars::None);
  if (lidar == nullptr) return;
  ASSERT_TRUE(lidar->configure(2 * kPi, 0.0, 4));
  std::vector<double> ranges(static_cast<std::size_t>(lidar->points()));
  ASSERT_TRUE(lidar->read(ranges));
  // Behind, left, ahead, right.
  EXPECT_THAT(ranges,
              testing::Pointwise(DoubleNear(traits().range), {1.0, 2 * kSideWall - 0.7, 2.0, 0.7}));
}

TEST_P(BackendContract, LidarScansASectorFromLeftToRight) {
  const Rig rig = make_at({1.0, 0.7, 0.0});
  Lidar* lidar = rig.backend->lidar();
  ASSERT_EQ(lidar != nullptr, traits().lidar != Lidars::None);
  if (lidar == nullptr) return;
  ASSERT_TRUE(lidar->configure(kPi, 0.0, 3));
  std::vector<double> ranges(3);
  ASSERT_TRUE(lidar->read(ranges));
  EXPECT_THAT(ranges,
              testing::Pointwise(DoubleNear(traits().range), {2 * kSideWall - 0.7, 2.0, 0.7}));
}

TEST_P(BackendContract, LidarTiltedDownEndsAtTheFloor) {
  const Rig rig = make(0.5);
  Lidar* lidar = rig.backend->lidar();
  ASSERT_EQ(lidar != nullptr, traits().lidar != Lidars::None);
  if (lidar == nullptr) return;
  const auto tilted = lidar->configure(2 * kPi, kPi / 6, 8);
  ASSERT_EQ(tilted.has_value(), traits().lidar == Lidars::Free);
  if (!tilted) {
    EXPECT_EQ(tilted.error().code, Errc::OutOfRange);
    return;
  }
  std::vector<double> ranges(8);
  ASSERT_TRUE(lidar->read(ranges));
  EXPECT_THAT(ranges, Each(DoubleNear(2 * rig_model().lidar->height, 1e-9)));  // 1 / sin 30° = 2
}

TEST_P(BackendContract, LidarRefusesShapesThatCannotBe) {
  const Rig rig = make(0.5);
  Lidar* lidar = rig.backend->lidar();
  ASSERT_EQ(lidar != nullptr, traits().lidar != Lidars::None);
  if (lidar == nullptr) return;
  const LidarShape before = lidar->shape();
  EXPECT_EQ(lidar->configure(7.0, 0.0, 10).error().code, Errc::OutOfRange);
  EXPECT_EQ(lidar->configure(0.0, 0.0, 10).error().code, Errc::OutOfRange);
  EXPECT_EQ(lidar->configure(1.0, 2.0, 10).error().code, Errc::OutOfRange);
  EXPECT_EQ(lidar->configure(1.0, 0.0, 0).error().code, Errc::OutOfRange);
  EXPECT_EQ(lidar->configure(std::nan(""), 0.0, 10).error().code, Errc::OutOfRange);
  EXPECT_EQ(lidar->shape(), before);
  std::vector<double> too_few(static_cast<std::size_t>(before.points) - 1);
  EXPECT_EQ(lidar->read(too_few).error().code, Errc::OutOfRange);
}

TEST_P(BackendContract, LidarTellsItsShapeAndTakesItBack) {
  const Rig rig = make(0.5);
  Lidar* lidar = rig.backend->lidar();
  ASSERT_EQ(lidar != nullptr, traits().lidar != Lidars::None);
  if (lidar == nullptr) return;
  const LidarShape first = lidar->shape();
  EXPECT_EQ(first, (LidarShape{2 * kPi, rig_model().lidar->tilt, rig_model().lidar->points}));
  const bool free = traits().lidar == Lidars::Free;
  const LidarShape other = free ? LidarShape{1.0, -0.25, 17} : LidarShape{1.0, 0.0, 5};
  ASSERT_TRUE(lidar->configure(other.field_of_view, other.tilt, other.points));
  EXPECT_EQ(lidar->shape(), other);
  EXPECT_EQ(lidar->points(), other.points);
  EXPECT_EQ(lidar->configure(1.0, 0.0, 9).has_value(), free);  // more rays than it was built with
  ASSERT_TRUE(lidar->configure(first.field_of_view, first.tilt, first.points));
  EXPECT_EQ(lidar->shape(), first);
}

TEST_P(BackendContract, LidarOfOnePointLooksAhead) {
  const Rig rig = make(0.5);
  Lidar* lidar = rig.backend->lidar();
  ASSERT_EQ(lidar != nullptr, traits().lidar != Lidars::None);
  if (lidar == nullptr) return;
  ASSERT_TRUE(lidar->configure(1.0, 0.0, 1));
  double range = 0.0;
  ASSERT_TRUE(lidar->read({&range, 1}));
  EXPECT_NEAR(range, 0.5 + kFrontOffset, traits().range);
}

TEST_P(BackendContract, LidarLooksStraightDownAndUp) {
  const Rig rig = make(0.5);
  Lidar* lidar = rig.backend->lidar();
  ASSERT_EQ(lidar != nullptr, traits().lidar != Lidars::None);
  if (lidar == nullptr) return;
  std::vector<double> ranges(4);
  for (const double tilt : {kPi / 2, -kPi / 2}) {
    const auto tilted = lidar->configure(2 * kPi, tilt, 4);
    ASSERT_EQ(tilted.has_value(), traits().lidar == Lidars::Free);
    if (!tilted) continue;
    ASSERT_TRUE(lidar->read(ranges));
    const double seen = tilt > 0 ? rig_model().lidar->height : lidar->max_range();
    EXPECT_THAT(ranges, Each(DoubleNear(seen, 1e-9)));
  }
}

TEST_P(BackendContract, ARangeMatrixMeasuresAlongItsAxis) {
  const Rig rig = make(0.1);
  RangeMatrix* matrix = rig.backend->range_matrix(3);
  ASSERT_EQ(matrix != nullptr, traits().range_matrix);
  EXPECT_EQ(rig.backend->range_matrix(1), nullptr);
  EXPECT_EQ(rig.backend->range_matrix(0), nullptr);
  EXPECT_EQ(rig.backend->range_matrix(9), nullptr);
  if (matrix == nullptr) return;
  EXPECT_EQ(matrix->out_of_range(), 9.999);
  const Result<RangeMatrix::Ranges> ranges = matrix->read();
  ASSERT_TRUE(ranges) << ranges.error().what;
  // The sensor is 50 mm high: its lowest row would see the floor 121 mm ahead.
  EXPECT_THAT(*ranges, Each(DoubleNear(0.1, traits().range)));
}

TEST_P(BackendContract, ARangeMatrixGoesFromTheTopLeftToTheBottomRight) {
  // The wall on the left is nearer than the one ahead, and the floor than both.
  const Rig rig = make_at({1.0, 2 * kSideWall - 0.2, 0.5});
  RangeMatrix* matrix = rig.backend->range_matrix(3);
  ASSERT_EQ(matrix != nullptr, traits().range_matrix);
  if (matrix == nullptr) return;
  const Result<RangeMatrix::Ranges> ranges = matrix->read();
  ASSERT_TRUE(ranges) << ranges.error().what;
  EXPECT_LT(ranges->at(0), ranges->at(RangeMatrix::kSize - 1));
  EXPECT_NEAR(ranges->back(), 0.05 / std::tan(kPi / 8), traits().range);
}

}  // namespace
}  // namespace eyebridge::hal
