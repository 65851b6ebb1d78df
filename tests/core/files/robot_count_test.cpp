#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/files/load.hpp"
#include "reading.hpp"

namespace eyebridge::files {
namespace {

using ::testing::HasSubstr;

Scenario own(const std::string& name) { return load_scenario(own_worlds() / name); }

TEST(RobotCount, FewerAreTheFirstOnes) {
  Scenario scenario = own("two-robots.sim");
  const Pose first = scenario.robots.at(0).pose;
  set_robot_count(scenario, 1, {"here"});
  ASSERT_EQ(scenario.robots.size(), 1U);
  EXPECT_EQ(scenario.robots[0].pose, first);
}

TEST(RobotCount, MoreAreLikeTheLastOneAndStandApart) {
  Scenario scenario = own("rooms.wld");
  scenario.robots.back().program = "explorer";
  set_robot_count(scenario, 20, {"here"});
  ASSERT_EQ(scenario.robots.size(), 20U);
  const double diameter = scenario.models.at(scenario.robots[0].model).diameter;
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(scenario.robots[i].program, "explorer");
    for (std::size_t k = 0; k < i; ++k) {
      const Vec2 apart = scenario.robots[i].pose.position() - scenario.robots[k].pose.position();
      EXPECT_GE(norm(apart), diameter) << i << " and " << k;
    }
  }
}

TEST(RobotCount, FreeStartsComeFirst) {
  Scenario scenario = own("maze-5.maz");
  scenario.world.starts.resize(1);
  scenario.world.starts.push_back({'S', scenario.world.starts[0].pose});
  Vec2 elsewhere = scenario.robots.at(0).pose.position();
  elsewhere.y += 2 * scenario.world.maze->cell;
  scenario.world.starts.back().pose = {elsewhere.x, elsewhere.y, 1.5};
  EXPECT_EQ(robots_meant(scenario), 2U);
  set_robot_count(scenario, 2, {"here"});
  EXPECT_EQ(scenario.robots.at(1).pose, scenario.world.starts.back().pose);
}

TEST(RobotCount, SaysHowManyThereIsRoomFor) {
  Scenario scenario = default_scenario();
  try {
    set_robot_count(scenario, 1000, {"--robots"});
    FAIL() << "1000 robots stand in 2 m x 2 m";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("--robots: found 1000 robots, but this world has room for "));
  }
}

}  // namespace
}  // namespace eyebridge::files
