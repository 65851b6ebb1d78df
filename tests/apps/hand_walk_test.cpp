// A film of a marked world, and the robot that follows it: renderer, recorder, pose finder and hand
// drive together, as a user would type it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>
#include <vector>

#include <gtest/gtest.h>

#include "command.hpp"
#include "eyebridge/base/math.hpp"
#include "eyebridge/base/pose.hpp"
#include "eyebridge/base/units.hpp"
#include "running_program.hpp"

namespace eyebridge {
namespace {

using testing::ProgramRun;
using testing::ScratchFolder;

/// Where the robot was, by milliseconds, as a trace.csv has it.
std::map<long, Pose> way_of(const std::string& trace) {
  std::map<long, Pose> way;
  std::istringstream lines(testing::file_text(trace));
  for (std::string line; std::getline(lines, line);) {
    double t = 0.0;
    Pose pose;
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &t, &pose.x, &pose.y, &pose.theta) == 4) {
      way[std::lround(t * 1000.0)] = pose;
    }
  }
  return way;
}

double at(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

TEST(HandWalk, TheRobotGoesWhereTheCameraWasThatFilmedAMarkedWorld) {
  const ScratchFolder folder;
  const std::string world = EYEBRIDGE_SOURCE_DIR "/worlds/empty-room.wld";
  const ProgramRun filmed =
      testing::run_command({"run", "--fast", "--world", world, "--camera", "render:?fiducials=on",
                            "--record", "walk.ebrec", "--out", "truth", EYEBRIDGE_TEST_FILMS},
                           folder.path());
  ASSERT_EQ(filmed.exit_code, 0) << filmed.err;
  const ProgramRun followed = testing::run_command(
      {"run", "--fast", "--time-limit", "19s", "--world", world, "--camera", "frames:walk.ebrec",
       "--drive", "hand?fov=60", "--out", "followed", EYEBRIDGE_TEST_ENDLESS},
      folder.path());
  ASSERT_EQ(followed.exit_code, 0) << followed.err;

  const auto truth = way_of(folder.path() + "/truth/trace.csv");
  std::vector<double> off;
  std::vector<double> turned;
  for (const auto& [ms, pose] : way_of(folder.path() + "/followed/trace.csv")) {
    const auto there = truth.find(ms);
    if (ms < 1000 || there == truth.end()) continue;
    off.push_back(std::hypot(pose.x - there->second.x, pose.y - there->second.y));
    turned.push_back(std::abs(wrap_angle(pose.theta - there->second.theta)));
  }
  ASSERT_GT(off.size(), 300U);
  // The project's measure, and what the robot does in the 33 ms until the next frame.
  EXPECT_LT(at(off, 0.5), 0.010);
  EXPECT_LT(at(off, 0.95), 0.030);
  EXPECT_LT(at(turned, 0.5), deg_to_rad(1.0));
  EXPECT_LT(at(turned, 0.95), deg_to_rad(3.0));
}

}  // namespace
}  // namespace eyebridge
