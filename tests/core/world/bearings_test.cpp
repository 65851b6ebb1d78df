// How far off the bearings are by which sweeps pick rays: what they add for that has to suffice.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"
#include "eyebridge/base/units.hpp"
#include "geometry.hpp"
#include "instruction_sets.hpp"
#include "sweep.hpp"
#include "sweep_bearings.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bearings_test.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#ifndef EYEBRIDGE_BEARING_ERRORS
#define EYEBRIDGE_BEARING_ERRORS
namespace eyebridge::world {

/// Of rsqrtps, Intel's and AMD's manuals: 1.5 * 2^-12, and its rounding.
constexpr float kMostRoot = 3.67e-4F;

/// The largest ones: of bearings and rough bearings, radians, and of inverse roots, relative.
struct BearingErrors {
  double exact = 0.0, rough = 0.0, root = 0.0;
};

/// From `a` to `b` on the shorter way round, radians.
inline double between(double a, double b) { return std::fabs(std::remainder(a - b, 2 * kPi)); }

}  // namespace eyebridge::world
#endif

HWY_BEFORE_NAMESPACE();
namespace eyebridge::world::HWY_NAMESPACE {
namespace {

#include "lanes.ipp"
#include "lanes_bearings.ipp"

BearingErrors bearing_errors() {
  Random random(98);
  BearingErrors worst;
  for (int i = 0; i < 400000; ++i) {
    const double start = 2 * kPi * random.uniform();
    const double turn = i % 2 == 0 ? 1.0 : -1.0;
    const double bearing = 2 * kPi * random.uniform();
    const double distance = std::pow(10.0, 6 * random.uniform() - 3);
    const double angle = start + turn * bearing;
    const Directions ahead = directions({std::cos(start), std::sin(start)}, turn);
    const Floats x = filled(static_cast<float>(distance * std::cos(angle)));
    const Floats y = filled(static_cast<float>(distance * std::sin(angle)));
    const Floats inverse = inverse_root_of(x * x + y * y);
    const double exact = double{hn::GetLane(bearing_of(x, y, ahead).angle)};
    worst.exact = std::max(worst.exact, between(exact, bearing));
    const auto try_root = [&](Floats root) HWY_ATTR {
      const double rough = double{hn::GetLane(rough_bearing_of(x, y, root, ahead))};
      worst.rough = std::max(worst.rough, between(rough, bearing));
    };
    try_root(inverse);
    // What the architecture permits is more than what this processor's root is off by.
    for (const float off : {-kMostRoot, kMostRoot}) {
      try_root(filled(static_cast<float>(1.0 / distance) * (1.0F + off)));
    }
    const double root = double{hn::GetLane(inverse)};
    worst.root = std::max(worst.root, std::fabs(distance * root - 1.0));
  }
  return worst;
}

}  // namespace
}  // namespace eyebridge::world::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace eyebridge::world {
namespace {

TEST(Bearings, AreWithinWhatSweepsAddForTheirErrors) {
  in_every_instruction_set([](const std::string& name) {
    const BearingErrors worst = EYEBRIDGE_BEST(bearing_errors)();
    EXPECT_LT(worst.exact, kBearingError) << name;
    EXPECT_LT(worst.rough, kRoughError) << name;
    EXPECT_LT(worst.root, double{kMostRoot}) << name;
    EXPECT_GT(worst.rough, kRoughError / 10) << "what is added is not ten times as much";
  });
}

}  // namespace
}  // namespace eyebridge::world
#endif
