// The measure of the pose finder: pictures of a known walk through a marked maze, with all that a
// cheap camera does to them.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <optional>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/pose_finder.hpp"
#include "eyebridge/files/load.hpp"
#include "fiducials/vision.hpp"
#include "lens_effects.hpp"
#include "maze_walk.hpp"

namespace eyebridge::camera::testing {
namespace {

constexpr double kPeriod = 1.0 / 30.0;
constexpr double kExposure = 0.012;  // seconds
/// Nothing is shown for a second, now and then.
constexpr double kBlackoutEvery = 4.0;
constexpr double kBlackout = 1.0;

struct Walk {
  const char* name;
  Effects effects;
  bool distorted = false;
};
void PrintTo(const Walk& walk, std::ostream* out) { *out << walk.name; }

struct Errors {
  std::vector<double> place_mm;
  std::vector<double> heading_deg;
  std::vector<double> in_deviations;  ///< Squared Mahalanobis distances; 3 on average if honest.
  double longest_recovery = 0.0;      ///< Seconds.
  int seen = 0;                       ///< Frames that show a fiducial well enough to be read.
  int lost = 0;                       ///< Of these, without a pose.
  double finder_seconds = 0.0;        ///< CPU time.
};

double quantile(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Errors errors_of(const Walk& walk, double seconds) {
  const auto maze = files::load_scenario(EYEBRIDGE_SOURCE_DIR "/worlds/maze-5.maz").world;
  const auto fiducials = place_fiducials(maze);
  const WallPainter painter(maze, fiducials);
  Calibration lens = pinhole({640, 480}, deg_to_rad(60.0));
  if (walk.distorted) lens.distortion = {-0.28, 0.07, 0.0008, -0.0012, 0.0};
  const LensCamera camera(painter, lens);
  const MazeWalk path(maze, 0.25);
  NullLog log;
  const auto finder = make_fiducial_finder(fiducials, lens, log);
  Random random(7);
  std::vector<char> hidden;
  for (std::size_t i = 0; i < fiducials.size(); ++i) hidden.push_back(random.chance(0.3) ? 1 : 0);
  const std::vector<char> all_hidden(fiducials.size(), 1);

  Errors errors;
  std::optional<double> shown_again;
  for (double t = 0.0; t < std::min(seconds, path.duration()); t += kPeriod) {
    const bool dark = std::fmod(t, kBlackoutEvery) > kBlackoutEvery - kBlackout;
    Frame frame = camera.take(path.at(t - 0.5 * kExposure), path.at(t + 0.5 * kExposure),
                              walk.effects, random, dark ? all_hidden : hidden);
    frame.time = from_seconds(t);
    const double before = cpu_seconds();
    const auto found = finder->take(frame);
    errors.finder_seconds += cpu_seconds() - before;
    if (dark) {
      shown_again.reset();
      continue;
    }
    // A wall close by whose only fiducial is hidden tells nobody anything.
    if (vision().find_fiducials(frame, FiducialFamily::Aruco5x5).empty()) continue;
    if (!shown_again) shown_again = t;
    ++errors.seen;
    if (!found || found->fiducials == 0) {
      if (!found) ++errors.lost;
      continue;
    }
    if (*shown_again >= 0.0) {
      errors.longest_recovery = std::max(errors.longest_recovery, t - *shown_again);
      *shown_again = -1.0;
    }
    const EyePose truth = path.at(t);
    const double x = found->pose.x - truth.values[kX];
    const double y = found->pose.y - truth.values[kY];
    const double turn = wrap_angle(found->pose.theta - truth.values[kHeading]);
    errors.place_mm.push_back(1000.0 * std::hypot(x, y));
    errors.heading_deg.push_back(std::abs(rad_to_deg(turn)));
    const Matrix<3, 3> covariance{found->covariance};
    if (const auto information = inverse_of(covariance)) {
      const Vector<3> off{x, y, turn};
      const Vector<3> pull = *information * off;
      errors.in_deviations.push_back(off[0] * pull[0] + off[1] * pull[1] + off[2] * pull[2]);
    }
  }
  return errors;
}

class PoseMeasure : public ::testing::TestWithParam<Walk> {};

TEST_P(PoseMeasure, ThePoseIsWithinTheMeasureAllAlongTheWalk) {
  const Errors errors = errors_of(GetParam(), 14.0);
  ASSERT_GT(errors.place_mm.size(), 100U);
  const double place = quantile(errors.place_mm, 0.5);
  const double place95 = quantile(errors.place_mm, 0.95);
  const double heading = quantile(errors.heading_deg, 0.5);
  const double heading95 = quantile(errors.heading_deg, 0.95);
  std::printf(
      "%-18s %4d frames: median %4.1f mm %4.2f deg, p95 %4.1f mm %4.2f deg, max %5.1f mm, lost %d, "
      "recovery %.2f s, finder %.2f ms a frame, median NEES %.1f\n",
      GetParam().name, errors.seen, place, heading, place95, heading95,
      quantile(errors.place_mm, 1.0), errors.lost, errors.longest_recovery,
      1000.0 * errors.finder_seconds / errors.seen, quantile(errors.in_deviations, 0.5));
  EXPECT_LE(place, 10.0);
  EXPECT_LE(heading, 1.0);
  EXPECT_LE(place95, 30.0);
  EXPECT_LE(heading95, 3.0);
  EXPECT_LE(errors.longest_recovery, 0.5);
  EXPECT_LE(errors.lost, errors.seen / 20);
}

INSTANTIATE_TEST_SUITE_P(
    Walks, PoseMeasure,
    ::testing::Values(Walk{"Bright", {.light = 1.0}}, Walk{"Dim", {.light = 0.45, .noise = 5.0}},
                      Walk{"Dark", {.light = 0.2, .noise = 5.0}},
                      Walk{"OneSided", {.light = 0.8, .gradient = 1.2, .blur = 1.0}},
                      Walk{"BrightDistorted", {.light = 1.0}, true},
                      Walk{"DimDistorted", {.light = 0.45, .noise = 5.0}, true},
                      Walk{"DarkDistorted", {.light = 0.2, .noise = 5.0}, true},
                      Walk{
                          "OneSidedDistorted", {.light = 0.8, .gradient = 1.2, .blur = 1.0}, true}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace eyebridge::camera::testing
