#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "lost_robot.hpp"

namespace eyebridge::localisation {
namespace {

using namespace testing;

/// With no more rays than the filter looks at.
robot::RobotModel realistic_scanner() {
  robot::RobotModel model = scanner("realistic");
  model.lidar->points = static_cast<int>(kBeams);
  return model;
}

TEST(MonteCarloSeeds, NinetyFiveOfAHundredLostRobotsKnowWhereTheyAreAfterATour) {
  const robot::RobotModel model = realistic_scanner();
  int found = 0;
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const std::vector<Stop> stops = tour_of(model, seed);
    MonteCarlo filter = lost_in_the_flat(model, seed);
    follow(filter, stops);
    if (!knows(filter, stops.back().truth)) continue;
    ++found;
    worst = std::max(worst, distance(filter.estimate().estimate.pose, stops.back().truth));
  }
  RecordProperty("found_of_100", found);
  RecordProperty("worst_of_them_mm", std::to_string(1000 * worst));
  EXPECT_GE(found, 95);
}

TEST(MonteCarloSeeds, NineOfTenRobotsThatSomebodyCarriedAwayAreFoundAgain) {
  const robot::RobotModel model = realistic_scanner();
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const std::vector<Stop> stops = tour_of(model, seed);
    MonteCarlo filter = lost_in_the_flat(model, seed);
    filter.start_at(stops[0].truth, 0.05, 0.05);
    follow(filter, {stops.begin(), stops.begin() + 30});
    // From the 30th stop to the 60th in no time; odometry does not notice.
    follow(filter, stops, 60);
    found += knows(filter, stops.back().truth) ? 1 : 0;
  }
  RecordProperty("found_of_20", found);
  EXPECT_GE(found, 18);
}

}  // namespace
}  // namespace eyebridge::localisation
