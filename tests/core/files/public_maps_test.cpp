// The measure of issue 13: in public maps, followed along their walls, what a LIDAR with realistic
// errors believes agrees with the map.
#include <algorithm>
#include <cmath>
#include <memory>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/load.hpp"
#include "eyebridge/mapping/ground_truth.hpp"
#include "eyebridge/mapping/robot_mapper.hpp"
#include "eyebridge/robot/error_presets.hpp"
#include "eyebridge/robot/simulation.hpp"
#include "reading.hpp"

namespace eyebridge::files {
namespace {

constexpr int kBeams = 360;
constexpr double kKeep = 0.35;   // metres from the wall on the left
constexpr double kSpeed = 0.4;   // metres per second
constexpr double kPeriod = 0.1;  // seconds

/// The nearest range of the beams within `half` of `bearing`, radians to the left of the front.
double nearest(const std::vector<double>& ranges, double bearing, double half) {
  double least = 100;
  for (int i = 0; i < kBeams; ++i) {
    const double beam = kPi - 2 * kPi * i / kBeams;  // as read_lidar() has them
    if (std::fabs(wrap_angle(beam - bearing)) <= half) {
      least = std::min(least, ranges[static_cast<std::size_t>(i)]);
    }
  }
  return least;
}

/// Where it is a tenth of a second later.
Pose follow_wall(const Pose& pose, const std::vector<double>& ranges) {
  const double ahead = nearest(ranges, 0, 0.5);
  const double left = nearest(ranges, kPi / 2, 0.7);
  if (ahead < kKeep) return {pose.x, pose.y, wrap_angle(pose.theta - 0.15)};
  const double turn = std::clamp(1.5 * (left - kKeep), -0.8, 0.8) * kPeriod;
  const double theta = wrap_angle(pose.theta + turn);
  const Vec2 step = kSpeed * kPeriod * Heading::from_angle(theta).forward();
  return {pose.x + step.x, pose.y + step.y, theta};
}

class PublicMap : public testing::TestWithParam<const char*> {};

TEST_P(PublicMap, TheBeliefOfAWallFollowerAgreesWithIt) {
  LoadOptions options;
  options.robot.clear();
  const Scenario scenario = load_scenario(std::string(EYEBRIDGE_SHARED_DIR) + GetParam(), options);
  const auto world = std::make_shared<const world::WorldModel>(scenario.world);
  const auto truth = mapping::truth_of(*world);
  mapping::OccupancyGrid belief(truth.geometry());
  robot::RobotModel model = named_robot("S4", {"test"});
  model.diameter = 0.1;
  model.lidar.emplace();
  model.lidar->max_range = 6.0;
  robot::set_errors(model, robot::error_preset("realistic").value());
  robot::Simulation simulation(world, {});
  Pose pose = scenario.world.starts.at(0).pose;
  simulation.add_robot(model, pose);
  mapping::RobotMapper mapper(model);
  std::vector<double> ranges(kBeams);
  double way = 0;
  for (int step = 0; step < 1500; ++step) {
    simulation.set_pose(0, pose);
    simulation.read_lidar(0, 2 * kPi, ranges);
    ASSERT_TRUE(mapper.insert_lidar(belief, pose, 2 * kPi, ranges));
    const Pose next = follow_wall(pose, ranges);
    way += norm(next.position() - pose.position());
    pose = next;
    ASSERT_TRUE(scenario.world.has_floor_at(pose.position())) << "it went through a wall";
  }
  const auto close = mapping::agreement(belief, truth);
  RecordProperty("agreement", std::to_string(close.share()));
  RecordProperty("observed", static_cast<int>(close.observed));
  EXPECT_GE(close.share(), 0.97) << close.observed << " cells";
  EXPECT_GT(close.observed, 500U);
  EXPECT_GT(way, 5) << "it stood";
}

INSTANTIATE_TEST_SUITE_P(Files, PublicMap,
                         testing::Values("/data/maps/turtlebot3.yaml", "/data/maps/lse_arena.world",
                                         "/cases/maps/lab.yaml", "/cases/maps/yaw.yaml"));

}  // namespace
}  // namespace eyebridge::files
