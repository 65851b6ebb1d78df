#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/world/world.hpp"
#include "scenes.hpp"

namespace eyebridge::world {
namespace {

constexpr double kRemovalStep = 0.01;

StateHash hash_of(const World& world) {
  StateHash hash;
  world.add_to(hash);
  return hash;
}

/// Few bodies are met one by one, many by a grid.
class Removal : public ::testing::TestWithParam<int> {
 protected:
  Removal() {
    mover_ = world_.add_robot({1, 1, 0}, 0.1, 0.1, {});
    in_the_way_ = world_.add_robot({2, 1, 0}, 0.1, 0.1, {});
    add_rows_of_ten(GetParam(), 3);
  }
  void add_rows_of_ten(int count, int y) {
    for (int i = 0; i < count; ++i) {
      const int row = i / 10;
      world_.add_robot({0.5 + i % 10, static_cast<double>(y + row), 0}, 0.1, 0.1, {});
    }
  }
  double ray() { return world_.cast_ray({1, 1}, {1, 0}, 20.0, mover_); }

  World world_{shared(room(12, 12))};
  BodyId mover_ = kNoBody;
  BodyId in_the_way_ = kNoBody;
};

TEST_P(Removal, NoRayMeetsWhoHasLeft) {
  ASSERT_NEAR(ray(), 0.9, 1e-12);
  world_.remove(in_the_way_);
  EXPECT_NEAR(ray(), 11.0, 1e-12);
  const std::vector<Vec2> directions{{1, 0}, {0, -1}, {-1, 0}};
  std::vector<double> ranges(3);
  world_.cast_fan({1, 1}, directions, 20.0, mover_, ranges);
  EXPECT_NEAR(ranges[0], 11.0, 1e-12);
  world_.cast_sweep({2, 1.5}, std::vector<Vec2>{{1, 0}, {0, -1}, {-1, 0}}, -kPi / 2, 20.0, mover_,
                    ranges);
  EXPECT_NEAR(ranges[1], 1.5, 1e-12);
}

TEST_P(Removal, NobodyRunsIntoWhoHasLeft) {
  const auto drive = [&] { return world_.move(mover_, {{0.9, 0.0}, Heading{}}, kRemovalStep); };
  ASSERT_EQ(drive().hit_body, in_the_way_);
  world_.step_objects(kRemovalStep);
  world_.remove(in_the_way_);
  EXPECT_FALSE(drive().blocked());
  EXPECT_TRUE(world_.is_free({2, 1}, 0.05, mover_));
  std::vector<Vec2> contacts;
  world_.contacts(mover_, 0.2, contacts);
  EXPECT_TRUE(contacts.empty());
}

TEST_P(Removal, ItsPlaceIsFreeForAnotherWhoGetsTheNextId) {
  const std::size_t before = world_.body_count();
  EXPECT_THROW(world_.add_robot({2, 1, 0}, 0.1, 0.1, {}), std::invalid_argument);
  world_.remove(in_the_way_);
  EXPECT_EQ(world_.add_robot({2, 1, 0}, 0.1, 0.1, {}), before);
  EXPECT_NEAR(ray(), 0.9, 1e-12);
  EXPECT_FALSE(world_.is_there(in_the_way_));
  add_rows_of_ten(40, 8);
  world_.remove(static_cast<BodyId>(before));
  EXPECT_NEAR(ray(), 11.0, 1e-12) << "nor is it there once the grid was made anew";
}

TEST_P(Removal, NobodySeesItAndTheOthersKeepTheirIds) {
  world_.remove(in_the_way_);
  const Scene scene = world_.scene(0.0);
  ASSERT_EQ(scene.bodies.size(), world_.body_count() - 1);
  EXPECT_EQ(scene.bodies[0].id, mover_);
  for (const BodyView& body : scene.bodies) {
    EXPECT_NE(body.id, in_the_way_);
    EXPECT_EQ(body.pose, world_.pose(body.id));
  }
}

TEST_P(Removal, WhoHasLeftStaysAway) {
  world_.remove(in_the_way_);
  world_.remove(in_the_way_);
  world_.set_pose(in_the_way_, {1.5, 1, 0});
  EXPECT_NEAR(ray(), 11.0, 1e-12);
  EXPECT_EQ(world_.position(in_the_way_), (Vec2{2, 1})) << "where it was last";
}

TEST_P(Removal, IsAnotherState) {
  const StateHash before = hash_of(world_);
  world_.remove(in_the_way_);
  EXPECT_NE(hash_of(world_).value(), before.value());
}

INSTANTIATE_TEST_SUITE_P(Worlds, Removal, ::testing::Values(0, 40), [](const auto& others) {
  return std::string(others.index == 0 ? "Few" : "Many");
});

}  // namespace
}  // namespace eyebridge::world
