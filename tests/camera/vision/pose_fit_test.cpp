#include "fiducials/pose_fit.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"
#include "eyebridge/base/units.hpp"
#include "fiducials/localise.hpp"
#include "fiducials/pose_filter.hpp"

namespace eyebridge::camera::testing {
namespace {

const Calibration kLens = pinhole({640, 480}, deg_to_rad(60.0));
const EyePose kEye{{0.2, 0.1, 0.12, 0.3, -0.05, 0.04}};

/// Fiducials of a corner that kEye looks into.
std::vector<Fiducial> corner_of_walls() {
  return {{0, {0.8, 0.35}, 0.1, kPi, 0.08},
          {1, {0.8, 0.1}, 0.1, kPi, 0.08},
          {2, {0.6, 0.5}, 0.1, -kPi / 2, 0.08}};
}

Sighting seen_from(const EyePose& eye, const Fiducial& fiducial) {
  Sighting sighting{fiducial.id, corners_of(fiducial), {}};
  for (std::size_t i = 0; i < 4; ++i) {
    sighting.pixels[i] = project(eye, kLens, sighting.corners[i])->pixel;
  }
  return sighting;
}

std::vector<Sighting> all_seen_from(const EyePose& eye) {
  std::vector<Sighting> sightings;
  for (const Fiducial& fiducial : corner_of_walls()) sightings.push_back(seen_from(eye, fiducial));
  return sightings;
}

double distance(const EyePose& a, const EyePose& b) {
  double sum = 0.0;
  for (const double d : difference(a, b)) sum += d * d;
  return std::sqrt(sum);
}

TEST(Projection, WhatIsAheadIsInTheMiddleAndWhatIsLeftIsLeft) {
  const EyePose eye{{1.0, 1.0, 0.1, 0.0, 0.0, 0.0}};
  const auto ahead = project(eye, kLens, {2.0, 1.0, 0.1});
  EXPECT_NEAR(ahead->pixel.x, 319.5, 1e-9);
  EXPECT_NEAR(ahead->pixel.y, 239.5, 1e-9);
  // At 30 degrees to the left: the left edge of the first pixel.
  EXPECT_NEAR(project(eye, kLens, {2.0, 1.0 + std::tan(kPi / 6), 0.1})->pixel.x, -0.5, 1e-9);
  EXPECT_LT(project(eye, kLens, {2.0, 1.0, 0.2})->pixel.y, 239.5);
  EXPECT_FALSE(project(eye, kLens, {0.5, 1.0, 0.1}));
}

TEST(Projection, PitchLooksUpAndRollTurnsClockwise) {
  const EyePose up{{0.0, 0.0, 0.0, 0.0, 0.1, 0.0}};
  EXPECT_GT(project(up, kLens, {1.0, 0.0, 0.0})->pixel.y, 240.0);
  // A camera that is turned clockwise sees what is above turned counter-clockwise: to the left.
  const EyePose rolled{{0.0, 0.0, 0.0, 0.0, 0.0, 0.1}};
  EXPECT_LT(project(rolled, kLens, {1.0, 0.0, 0.1})->pixel.x, 319.0);
}

TEST(Projection, ItsDerivativesAreThoseOfFiniteDifferences) {
  const Vec3 point{0.9, 0.3, 0.15};
  const auto seen = project(kEye, kLens, point);
  for (std::size_t i = 0; i < 6; ++i) {
    Vector<6> step{};
    step[i] = 1e-6;
    const Vec2 plus = project(moved(kEye, step), kLens, point)->pixel;
    step[i] = -1e-6;
    const Vec2 minus = project(moved(kEye, step), kLens, point)->pixel;
    EXPECT_NEAR(seen->jacobian(0, i), (plus.x - minus.x) / 2e-6, 1e-3) << i;
    EXPECT_NEAR(seen->jacobian(1, i), (plus.y - minus.y) / 2e-6, 1e-3) << i;
  }
}

TEST(EyePoseOfAxes, IsThePoseThatHasThem) {
  const SinCos h = sin_cos(0.3);
  const SinCos p = sin_cos(-0.05);
  const SinCos r = sin_cos(0.04);
  const Vec3 forward{h.cos * p.cos, h.sin * p.cos, p.sin};
  const Vec3 right{r.cos * h.sin + r.sin * h.cos * p.sin, -r.cos * h.cos + r.sin * h.sin * p.sin,
                   -r.sin * p.cos};
  EXPECT_LT(distance(eye_pose({0.2, 0.1, 0.12}, right, forward), kEye), 1e-12);
}

TEST(CornersOf, AreClockwiseFromTheTopLeftAsOneFacesTheWall) {
  // A wall in the east, seen from the west: left is north.
  const auto corners = corners_of({0, {1.0, 2.0}, 0.1, kPi, 0.08});
  EXPECT_NEAR(corners[0].y, 2.04, 1e-12);
  EXPECT_NEAR(corners[0].z, 0.14, 1e-12);
  EXPECT_NEAR(corners[1].y, 1.96, 1e-12);
  EXPECT_NEAR(corners[2].z, 0.06, 1e-12);
}

TEST(FitPose, FindsThePoseFromOneThatIsOff) {
  const auto fit =
      fit_pose(all_seen_from(kEye), kLens, {}, moved(kEye, {0.05, -0.04, 0.03, 0.15, 0.05, -0.05}));
  ASSERT_TRUE(fit);
  EXPECT_LT(distance(fit->pose, kEye), 1e-6);
  EXPECT_LT(fit->cost, 1e-6);
}

TEST(FitPose, ItsCovarianceIsThatOfManyFits) {
  Random random(3);
  const auto exact = all_seen_from(kEye);
  Vector<6> squares{};
  Matrix<6, 6> covariance;
  constexpr int kTimes = 400;
  for (int i = 0; i < kTimes; ++i) {
    auto noisy = exact;
    for (Sighting& sighting : noisy) {
      for (Vec2& pixel : sighting.pixels) {
        pixel = pixel + kCornerDeviation * Vec2{random.gaussian(), random.gaussian()};
      }
    }
    const auto fit = fit_pose(noisy, kLens, {}, kEye);
    ASSERT_TRUE(fit);
    covariance = fit->covariance;
    const Vector<6> off = difference(fit->pose, kEye);
    for (std::size_t k = 0; k < 6; ++k) squares[k] += off[k] * off[k] / kTimes;
  }
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_NEAR(squares[k] / covariance(k, k), 1.0, 0.35) << k;
  }
}

TEST(FitPose, AFarOffCornerPullsLittle) {
  auto sightings = all_seen_from(kEye);
  sightings[0].pixels[0] = sightings[0].pixels[0] + Vec2{30.0, 0.0};
  const auto fit = fit_pose(sightings, kLens, {}, kEye);
  ASSERT_TRUE(fit);
  EXPECT_LT(distance(fit->pose, kEye), 0.05);
}

TEST(FitPose, WhatDeterminesNothingIsNoPose) { EXPECT_FALSE(fit_pose({}, kLens, {}, kEye)); }

TEST(FitPose, ThePriorHoldsWhatIsNotSeen) {
  PosePrior prior{kEye, diagonal(Vector<6>{1e4, 1e4, 1e4, 1e4, 1e4, 1e4})};
  const auto fit = fit_pose({}, kLens, prior, moved(kEye, {0.1, 0.1, 0.0, 0.1, 0.0, 0.0}));
  ASSERT_TRUE(fit);
  EXPECT_LT(distance(fit->pose, kEye), 1e-6);
}

TEST(Localise, FindsThePoseFromNothing) {
  const auto found = localise(all_seen_from(kEye), kLens, nullptr, vision());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->inliers.size(), 3U);
  EXPECT_LT(distance(found->fit.pose, kEye), 0.01);
}

TEST(Localise, OneThatWasMovedIsLeftOut) {
  auto sightings = all_seen_from(kEye);
  Fiducial elsewhere = corner_of_walls()[1];
  elsewhere.centre = elsewhere.centre + Vec2{0.0, 0.1};
  sightings[1] = seen_from(kEye, elsewhere);
  sightings[1].corners = corners_of(corner_of_walls()[1]);
  const auto found = localise(sightings, kLens, nullptr, vision());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->inliers.size(), 2U);
  EXPECT_LT(distance(found->fit.pose, kEye), 0.02);
}

TEST(Localise, ASmallFiducialSeenAlmostFromTheFrontNeedsToKnowWhereTheCameraWas) {
  // 1.5 m away and 5 degrees aside: as good from 5 degrees to the other side.
  const Fiducial far{0, {1.5, 0.0}, 0.1, kPi, 0.08};
  const EyePose eye{{0.0, 0.13, 0.1, -0.09, 0.0, 0.0}};
  auto sighting = seen_from(eye, far);
  sighting.pixels[0] = sighting.pixels[0] + Vec2{0.2, -0.1};
  EXPECT_FALSE(localise(std::vector{sighting}, kLens, nullptr, vision()));
  const auto found = localise(std::vector{sighting}, kLens, &eye, vision());
  ASSERT_TRUE(found);
  EXPECT_GT(found->fit.pose.values[kY], 0.0);
}

TEST(Localise, NothingSeenIsNoPose) { EXPECT_FALSE(localise({}, kLens, nullptr, vision())); }

PoseFit exactly(const EyePose& pose) {
  return {pose, diagonal(Vector<6>{1e-6, 1e-6, 1e-6, 1e-6, 1e-6, 1e-6}), 0.0};
}

TEST(PoseFilter, LearnsTheSpeedAndGoesOnWithIt) {
  EyePose pose = kEye;
  PoseFilter filter(exactly(pose), Time(0));
  for (int i = 1; i <= 30; ++i) {
    pose = moved(pose, {0.01, 0.0, 0.0, 0.02, 0.0, 0.0});
    filter.predict(Time(i * 33'000'000));
    filter.update(exactly(pose));
  }
  EXPECT_NEAR(filter.speed()[kX], 0.01 / 0.033, 0.02);
  EXPECT_NEAR(filter.speed()[kHeading], 0.02 / 0.033, 0.04);
  filter.predict(Time(30 * 33'000'000 + 165'000'000));
  EXPECT_LT(distance(filter.pose(), moved(pose, {0.05, 0.0, 0.0, 0.1, 0.0, 0.0})), 0.01);
}

TEST(PoseFilter, IsLessSureTheLongerNothingIsSeen) {
  PoseFilter filter(exactly(kEye), Time(0));
  double before = 0.0;
  for (int i = 1; i <= 10; ++i) {
    filter.predict(Time(i * 33'000'000));
    EXPECT_GT(filter.covariance()(kX, kX), before);
    before = filter.covariance()(kX, kX);
  }
  // White acceleration alone: q t^3 / 3 with q = 1.
  EXPECT_GT(before, 0.33 * 0.33 * 0.33 / 3.0);
}

TEST(PoseFilter, TheHeadingGoesRoundWithoutAJump) {
  EyePose pose{{0.0, 0.0, 0.1, kPi - 0.01, 0.0, 0.0}};
  PoseFilter filter(exactly(pose), Time(0));
  filter.predict(Time(33'000'000));
  filter.update(exactly(moved(pose, {0.0, 0.0, 0.0, 0.02, 0.0, 0.0})));
  EXPECT_NEAR(filter.pose().values[kHeading], -kPi + 0.01, 1e-3);
  EXPECT_GT(filter.speed()[kHeading], 0.0);
}

}  // namespace
}  // namespace eyebridge::camera::testing
