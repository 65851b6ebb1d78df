// How far off the bearings are by which sweeps pick rays: what they add for that has to suffice.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"
#include "eyebridge/base/units.hpp"
#include "geometry.hpp"
#include "sweep.hpp"
#include "sweep_bearings.hpp"

#define EYEBRIDGE_RAY_TARGET
#define EYEBRIDGE_RAY_LANES 2

namespace eyebridge::world {

#include "bearing_lanes.ipp"

namespace {

/// Of rsqrtps, Intel's and AMD's manuals: 1.5 * 2^-12, and its rounding.
constexpr float kMostRoot = 3.67e-4F;

/// From `a` to `b` on the shorter way round, radians.
double between(double a, double b) { return std::fabs(std::remainder(a - b, 2 * kPi)); }

TEST(Bearings, AreWithinWhatSweepsAddForTheirErrors) {
  Random random(98);
  double worst = 0.0;
  double worst_rough = 0.0;
  double worst_root = 0.0;
  for (int i = 0; i < 400000; ++i) {
    const double start = 2 * kPi * random.uniform();
    const double turn = i % 2 == 0 ? 1.0 : -1.0;
    const double bearing = 2 * kPi * random.uniform();
    const double distance = std::pow(10.0, 6 * random.uniform() - 3);
    const double angle = start + turn * bearing;
    const Directions ahead = directions({std::cos(start), std::sin(start)}, turn);
    const Floats x = Floats{} + static_cast<float>(distance * std::cos(angle));
    const Floats y = Floats{} + static_cast<float>(distance * std::sin(angle));
    const Floats inverse = inverse_root_of(x * x + y * y);
    worst = std::max(worst, between(bearing_of(x, y, ahead).angle[0], bearing));
    worst_rough =
        std::max(worst_rough, between(rough_bearing_of(x, y, inverse, ahead)[0], bearing));
    // What the architecture permits is more than what this processor's root is off by.
    for (const float off : {-kMostRoot, kMostRoot}) {
      const Floats bad = Floats{} + static_cast<float>(1.0 / distance) * (1.0F + off);
      worst_rough = std::max(worst_rough, between(rough_bearing_of(x, y, bad, ahead)[0], bearing));
    }
    worst_root = std::max(worst_root, std::fabs(distance * double{inverse[0]} - 1.0));
  }
  EXPECT_LT(worst, kBearingError);
  EXPECT_LT(worst_rough, double{kRoughError});
  EXPECT_LT(worst_root, double{kMostRoot});
  EXPECT_GT(worst_rough, double{kRoughError} / 10) << "what is added is not ten times as much";
}

}  // namespace
}  // namespace eyebridge::world

#undef EYEBRIDGE_RAY_TARGET
#undef EYEBRIDGE_RAY_LANES
