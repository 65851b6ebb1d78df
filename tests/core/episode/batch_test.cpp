// Many episodes side by side.

#include "eyebridge/episode/batch.hpp"

#include <limits>
#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rooms.hpp"

namespace eyebridge::episode {
namespace {

using ::testing::ElementsAre;

struct Rig {
  explicit Rig(const BatchSettings& settings) : batch({room()}, settings) {
    actions.resize(2 * settings.worlds);
    resets.resize(settings.worlds);
  }
  void drive(std::size_t world, double first, double second) {
    actions[2 * world] = first;
    actions[2 * world + 1] = second;
  }
  void step(int times = 1) {
    for (int i = 0; i < times; ++i) batch.step(actions, resets);
  }
  const BatchRows& rows() { return batch.rows(); }

  EpisodeBatch batch;
  std::vector<double> actions;
  std::vector<std::uint8_t> resets;
};

TEST(EpisodeBatch, EachWorldDoesAsItIsTold) {
  Rig rig({.worlds = 3, .observation = "pose"});
  rig.drive(1, 0.3, 0.0);
  rig.drive(2, 0.0, 1.0);
  rig.step(5);
  EXPECT_THAT(rig.rows().times, ::testing::Each(::testing::DoubleNear(0.5, 1e-9)));
  EXPECT_EQ(rig.rows().poses[0], 1.0);
  EXPECT_GT(rig.rows().poses[3], 1.05);
  EXPECT_GT(rig.rows().poses[8], 0.3) << "theta of the last world";
  EXPECT_EQ(rig.rows().observations, rig.rows().poses);
}

TEST(EpisodeBatch, RewardsTheWayDrivenUntilToldOtherwise) {
  Rig rig({.worlds = 2, .period = 0.2});
  rig.drive(1, 0.3, 0.0);
  rig.step(3);
  EXPECT_NEAR(rig.rows().rewards[1], 0.06, 1e-9);
  EXPECT_EQ(rig.rows().rewards[1], rig.rows().distances[1]);
  EXPECT_EQ(rig.rows().rewards[0], 0.0);
  rig.batch.set_reward([](const Episode&) { return 2.0; });
  rig.step();
  EXPECT_THAT(rig.rows().rewards, ElementsAre(40.0, 40.0)) << "20 steps of the simulation";
  rig.step();
  EXPECT_THAT(rig.rows().rewards, ElementsAre(40.0, 40.0)) << "of the last period alone";
}

TEST(EpisodeBatch, ACollisionEndsAnEpisodeUnlessToldOtherwise) {
  Rig rig({.worlds = 2});
  rig.drive(0, 0.5, 0.0);
  int steps = 0;
  while (rig.rows().terminated[0] == 0 && steps++ < 100) rig.step();
  EXPECT_EQ(rig.rows().collisions[0], 1U);
  EXPECT_THAT(rig.rows().terminated, ElementsAre(1, 0));
  EXPECT_LT(rig.rows().times[0], rig.rows().times[1]) << "it stopped within the period";

  rig.batch.set_terminated([](const Episode& e) { return e.simulation().pose(0).theta > 0.2; });
  rig.drive(1, 0.0, 1.0);
  rig.step(4);
  EXPECT_THAT(rig.rows().terminated, ElementsAre(0, 1));
}

TEST(EpisodeBatch, TheTimeLimitTruncates) {
  Rig rig({.worlds = 1, .time_limit = 0.3});
  rig.step(2);
  EXPECT_EQ(rig.rows().truncated[0], 0);
  rig.step();
  EXPECT_EQ(rig.rows().truncated[0], 1);
  EXPECT_EQ(rig.rows().terminated[0], 0);
}

TEST(EpisodeBatch, BeginsAgainWhereItIsTold) {
  Rig rig({.worlds = 2});
  rig.drive(0, 0.3, 0.0);
  rig.drive(1, 0.3, 0.0);
  rig.step(4);
  rig.resets = {1, 0};
  rig.step();
  EXPECT_EQ(rig.rows().times[0], 0.0);
  EXPECT_NEAR(rig.rows().times[1], 0.5, 1e-9);
  EXPECT_EQ(rig.rows().poses[0], 1.0);
  EXPECT_EQ(rig.rows().rewards[0], 0.0);
  const std::vector<double> before = rig.rows().poses;
  rig.batch.reset(std::vector<std::uint8_t>{0, 1});
  EXPECT_EQ(rig.rows().times[1], 0.0);
  EXPECT_EQ(rig.rows().poses[0], before[0]);
}

TEST(EpisodeBatch, EveryEpisodeHasASeedOfItsOwnThatFollowsFromTheFirst) {
  const auto seeds_of = [](std::uint64_t first) {
    Rig rig({.worlds = 4});
    rig.batch.reset_all(first);
    std::vector<std::uint64_t> seeds = rig.rows().seeds;
    for (int i = 0; i < 5; ++i) {
      rig.batch.reset(std::vector<std::uint8_t>(4, 1));
      seeds.insert(seeds.end(), rig.rows().seeds.begin(), rig.rows().seeds.end());
    }
    return seeds;
  };
  const auto seeds = seeds_of(9);
  EXPECT_THAT(std::vector(seeds.begin(), seeds.begin() + 4), ElementsAre(9, 10, 11, 12));
  EXPECT_EQ(std::set(seeds.begin(), seeds.end()).size(), seeds.size());
  EXPECT_EQ(seeds_of(9), seeds);
}

TEST(EpisodeBatch, WheelsAreDrivenByDuty) {
  Rig rig({.worlds = 1, .action = Action::Wheels});
  EXPECT_EQ(rig.batch.action_high(), std::pair(1.0, 1.0));
  rig.drive(0, -0.1, 0.1);
  rig.step(2);
  EXPECT_GT(rig.rows().poses[2], 0.1) << "turned to the left";
  EXPECT_NEAR(rig.rows().poses[0], 1.0, 1e-9);
}

TEST(EpisodeBatch, KnowsWhatTheRobotCanDo) {
  Rig rig({.worlds = 1});
  const auto [linear, angular] = rig.batch.action_high();
  EXPECT_NEAR(linear, 0.6, 1e-9);
  EXPECT_NEAR(angular, 5.236, 1e-3);
  EXPECT_EQ(rig.batch.observation_size(), 10U);
}

TEST(EpisodeBatch, RefusesWhatCannotBe) {
  const auto refused = [](const BatchSettings& settings) {
    EXPECT_THROW(EpisodeBatch({room()}, settings), std::invalid_argument);
  };
  refused({.worlds = 0});
  refused({.worlds = 2'000'000});
  refused({.period = 0});
  refused({.period = std::numeric_limits<double>::quiet_NaN()});
  refused({.time_limit = 0});
  refused({.observation = "smell"});
  EXPECT_THROW(EpisodeBatch({}, {}), std::invalid_argument);
  auto other = room();
  other->models[0] = *files::builtin_robot("LabBot");
  EXPECT_THROW(EpisodeBatch({room(), other}, {}), std::invalid_argument);
  auto nobody = room();
  nobody->robots.clear();
  EXPECT_THROW(EpisodeBatch({nobody}, {}), std::invalid_argument);
  auto car = room();
  car->models[0] = *files::builtin_robot("Car");
  EXPECT_THROW(EpisodeBatch({car}, {.action = Action::Wheels}), std::invalid_argument);
  EXPECT_NO_THROW(EpisodeBatch({car}, {.action = Action::Speed}));
}

TEST(EpisodeBatch, RefusesActionsThatCannotBe) {
  Rig rig({.worlds = 2});
  const std::vector<std::uint8_t> two(2);
  EXPECT_THROW(rig.batch.step(std::vector<double>(3), two), std::invalid_argument);
  EXPECT_THROW(rig.batch.step(std::vector<double>(4), std::vector<std::uint8_t>(1)),
               std::invalid_argument);
  EXPECT_THROW(rig.batch.reset(std::vector<std::uint8_t>(1)), std::invalid_argument);
  rig.drive(1, 0.0, std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(rig.step(), std::invalid_argument);
}

}  // namespace
}  // namespace eyebridge::episode
