#include <gtest/gtest.h>

#include "eyebridge/robot/simulation.hpp"
#include "rig.hpp"

namespace eyebridge::robot {
namespace {

world::ObjectSpec can_at(double x, double y) {
  world::ObjectSpec spec;
  spec.kind = world::ObjectKind::Can;
  spec.name = "can";
  spec.pose = {x, y, 0};
  spec.radius = 0.05;
  spec.matter.fixed = true;
  return spec;
}

/// An empty room with robot 0 at (1, 1), then a can at (3, 3), then robot 1 at (1, 2).
class LiveObjectsTest : public ::testing::Test {
 protected:
  static std::shared_ptr<const world::WorldModel> room() {
    world::WorldModel model;
    model.width = model.height = 4;
    model.walls = world::walls_around(4, 4);
    return std::make_shared<const world::WorldModel>(std::move(model));
  }
  void run(double seconds) {
    const double end = sim_.time() + seconds - 1e-9;
    while (sim_.time() < end) sim_.step();
  }

  Simulation sim_{room(), {}};
  RobotIndex first_ = sim_.add_robot(RobotModel{}, {1, 1, 0});
  world::BodyId can_ = sim_.world().add_object(can_at(3, 3));
  RobotIndex second_ = sim_.add_robot(RobotModel{}, {1, 2, 0});
};

TEST_F(LiveObjectsTest, CollisionsNameRobotsAndObjectsInWhateverOrderTheyCame) {
  sim_.world().set_pose(can_, {2, 2, 0});
  sim_.set_speed(second_, {0.3, 0});
  run(5);
  ASSERT_EQ(sim_.collisions().size(), 1u);
  const CollisionEvent& event = sim_.collisions()[0];
  EXPECT_EQ(event.robot, second_);
  EXPECT_EQ(event.object, std::nullopt);
  EXPECT_EQ(event.with_body, can_);
  EXPECT_EQ(event.with_robot, std::nullopt);
  EXPECT_EQ(event.with_object, 0u);
}

TEST_F(LiveObjectsTest, OneThatIsPressedGoesOnWhenWhatHeldItIsRemoved) {
  sim_.world().set_pose(can_, {2, 1, 0});
  sim_.set_speed(first_, {0.3, 0});
  run(5);
  EXPECT_NE(sim_.stalled(first_), kStallNone);
  const double held = sim_.pose(first_).x;
  sim_.world().remove(can_);
  run(1);
  EXPECT_NEAR(sim_.pose(first_).x, held + 0.3, 0.06);
  EXPECT_EQ(sim_.stalled(first_), kStallNone);
}

TEST_F(LiveObjectsTest, ACruisingRobotMeetsWhatIsPutInItsWay) {
  sim_.set_speed(first_, {0.3, 0});
  run(2);
  sim_.world().add_object(can_at(2.5, 1));
  run(6);
  EXPECT_NEAR(sim_.pose(first_).x, 2.5 - 0.05 - sim_.model(first_).radius(), 1e-5);
}

}  // namespace
}  // namespace eyebridge::robot
