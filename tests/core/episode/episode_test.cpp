// A scenario that is run again and again in one process.

#include "eyebridge/episode/episode.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "eyebridge/files/load.hpp"
#include "rooms.hpp"

namespace eyebridge::episode {
namespace {

TEST(Episode, StepsUntilAConditionHolds) {
  Episode episode(room());
  episode.simulation().set_speed(0, {0.3, 0.0});
  const auto arrived = [](const Episode& e) { return e.simulation().pose(0).x > 1.2; };
  EXPECT_FALSE(episode.step_until(arrived, 0.3));
  EXPECT_NEAR(episode.time(), 0.3, 1e-9) << "the seconds are over";
  EXPECT_TRUE(episode.step_until(arrived, 10));
  EXPECT_GT(episode.simulation().pose(0).x, 1.2);
  EXPECT_LT(episode.simulation().pose(0).x, 1.2 + 0.3 * 0.01 + 1e-9) << "not a step too many";
}

TEST(Episode, StepsOnceAtLeast) {
  Episode episode(room());
  episode.run(0);
  EXPECT_NEAR(episode.time(), 0.01, 1e-12);
  EXPECT_THROW(episode.run(-1), std::invalid_argument);
  EXPECT_THROW(episode.run(2e9), std::invalid_argument);
}

TEST(Episode, AddsUpTheRewardOfEveryStep) {
  Episode episode(room());
  episode.set_reward([](const Episode& e) { return e.time() > 0.255 ? 10.0 : 1.0; });
  episode.run(0.3);
  EXPECT_DOUBLE_EQ(episode.total_reward(), 25 + 5 * 10.0);
  episode.reset(2);
  EXPECT_EQ(episode.total_reward(), 0.0);
  episode.run(0.1);
  EXPECT_DOUBLE_EQ(episode.total_reward(), 10.0) << "the reward stays after a reset";
}

TEST(Episode, CountsWaysAndCollisions) {
  Episode episode(room());
  episode.simulation().set_speed(0, {0.5, 0.0});
  episode.run(5);
  const double to_the_wall = 0.995 - episode.simulation().model(0).radius();
  EXPECT_NEAR(episode.tally().distance(0), to_the_wall, 1e-6);
  EXPECT_EQ(episode.tally().collisions(0), 1U);
  episode.simulation().set_speed(0, {-0.5, 0.0});
  episode.run(1);
  EXPECT_GT(episode.tally().distance(0), to_the_wall + 0.3) << "backwards counts, too";
  EXPECT_EQ(episode.tally().distance(), episode.tally().distance(0)) << "the only robot";
  EXPECT_EQ(episode.tally().distance(7), 0.0) << "a robot that is not there";
  episode.reset(1);
  EXPECT_EQ(episode.tally().distance(), 0.0);
  EXPECT_EQ(episode.tally().collisions(), 0U);
}

TEST(Episode, SameSeedSameBitsWhateverCameBefore) {
  const auto hash_of = [](Episode& episode, std::uint64_t seed) {
    episode.reset(seed);
    episode.simulation().set_speed(0, {0.3, 0.4});
    episode.run(3);
    return episode.simulation().state_hash();
  };
  Episode fresh(rough_room());
  const auto seven = hash_of(fresh, 7);
  Episode used(rough_room());
  EXPECT_NE(hash_of(used, 8), seven);
  EXPECT_EQ(hash_of(used, 7), seven);
}

TEST(Episode, StartsAnywhereThatIsFree) {
  auto scenario = std::make_shared<files::Scenario>(
      files::load_scenario(std::string(EYEBRIDGE_SOURCE_DIR) + "/worlds/corridor.wld"));
  Episode episode(scenario, {}, Start::Anywhere);
  Vec2 last;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    episode.reset(seed);
    const robot::Simulation& sim = episode.simulation();
    const Pose pose = sim.pose(0);
    EXPECT_TRUE(sim.world().is_free(pose.position(), sim.model(0).radius(), sim.body(0)));
    EXPECT_NE(pose.x, last.x) << "another seed, another place";
    last = pose.position();
    episode.reset(seed);
    EXPECT_EQ(episode.simulation().pose(0), pose);
  }
}

TEST(Episode, RefusesToStartWhereThereIsNoRoom) {
  auto crowded = room();
  crowded->world.width = 0.05;
  EXPECT_THROW(Episode(crowded, {}, Start::Anywhere), std::invalid_argument);
  auto empty = room();
  empty->robots.clear();
  EXPECT_THROW(Episode(empty, {}, Start::Anywhere), std::invalid_argument);
}

}  // namespace
}  // namespace eyebridge::episode
