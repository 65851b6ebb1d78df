#include <cmath>

#include <gtest/gtest.h>

#include "eyebridge/hal/environment.hpp"
#include "eyebridge/hal/registry.hpp"
#include "eyebridge/hal/shared_world.hpp"
#include "rigs.hpp"
#include "shared/open_only.hpp"
#include "shared/shared_sim.hpp"

namespace eyebridge::hal {
namespace {

class SimEnvironmentTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const Config config = rig_config({{"fast", "true"}});
    backend_ = open_scenario(rig_scenario(1.0), {"rig"}, {config, log_});
    environment_ = backend_->environment();
    ASSERT_NE(environment_, nullptr);
  }
  const WorldLook& look() {
    environment_->look(look_);
    return look_;
  }

  struct NoTurns final : Turns {
    [[nodiscard]] const Time& limit_of(std::size_t) const override { return never; }
    void wait(std::size_t, Time) override {}
    Time never = Time::max();
  };

  KeepingLog log_;
  NoTurns turns_;
  std::unique_ptr<Backend> backend_;
  Environment* environment_ = nullptr;
  WorldLook look_;
};

TEST_F(SimEnvironmentTest, ShowsRobotsAndThings) {
  ASSERT_TRUE(backend_->drive()->set_speed({0.2, 0.0}));
  backend_->clock().wait_until(from_seconds(1.0));
  ASSERT_EQ(look().robots.size(), 2U);
  EXPECT_EQ(look().scene.bodies.size(), 3U);
  EXPECT_DOUBLE_EQ(look().scene.time, 1.0);
  const RobotLook& robot = look().robots[0];
  EXPECT_EQ(robot.model->name, rig_model().name);
  EXPECT_EQ(robot.pose, must(environment_->control().robot_pose(1)));
  EXPECT_NEAR(robot.odometry.x, 0.18, 0.02);
  EXPECT_NEAR(robot.twist.linear, 0.2, 1e-6);
  EXPECT_EQ(robot.body, 1U);
  EXPECT_EQ(look().robots[0].model, robot.model) << "models are not copied for each look";
}

TEST_F(SimEnvironmentTest, TellsOfEachCollisionOnce) {
  ASSERT_TRUE(backend_->drive()->set_speed({0.5, 0.0}));
  EXPECT_TRUE(look().collisions.empty());
  backend_->clock().wait_until(from_seconds(4.0));
  ASSERT_EQ(look().collisions.size(), 1U);
  EXPECT_TRUE(look_.collisions[0].with_wall());
  EXPECT_NE(look_.robots[0].stalled, robot::kStallNone);
  EXPECT_TRUE(look().collisions.empty());
  WorldLook other;  // who begins to look later sees what was before
  environment_->look(other);
  EXPECT_EQ(other.collisions.size(), 1U);
}

TEST_F(SimEnvironmentTest, ALookChangesNothing) {
  const auto pose_after = [](bool looks) {
    KeepingLog log;
    const Config config = rig_config({{"fast", "true"}, {"errors", "realistic"}});
    auto backend = open_scenario(rig_scenario(1.0), {"rig"}, {config, log});
    EXPECT_TRUE(backend->drive()->set_speed({0.1, 0.3}));
    WorldLook look;
    double ranges = 0.0;
    for (int i = 1; i <= 50; ++i) {
      backend->clock().wait_until(i * from_seconds(0.05));
      if (looks) backend->environment()->look(look);
      ranges += must(backend->range_sensor(1)->read());
    }
    return std::pair(must(backend->world()->robot_pose(1)), ranges);
  };
  EXPECT_EQ(pose_after(false), pose_after(true));
}

TEST_F(SimEnvironmentTest, DrivesARobotAsItsProgramWould) {
  ASSERT_TRUE(environment_->drive(1, {0.1, 0.0}));
  backend_->clock().wait_until(from_seconds(1.0));
  EXPECT_NEAR(look().robots[1].twist.linear, 0.1, 1e-6);
  EXPECT_EQ(look().robots[0].twist.linear, 0.0);
  const auto nobody = environment_->drive(2, {0.1, 0.0});
  ASSERT_FALSE(nobody);
  EXPECT_EQ(nobody.error().code, Errc::OutOfRange);
  EXPECT_EQ(nobody.error().what, "no robot 3, the world has 2");
  EXPECT_FALSE(environment_->drive(0, {std::nan(""), 0.0}));
}

TEST_F(SimEnvironmentTest, TakesErrorsFromAModelWithTheSameDevices) {
  robot::RobotModel erring = *look().robots[0].model;
  for (auto& sensor : erring.range_sensors) sensor.error.bias = -0.05;
  const double before = must(backend_->range_sensor(1)->read());
  EXPECT_NE(must(environment_->present_model(0)), erring);
  ASSERT_TRUE(environment_->set_errors(0, erring));
  EXPECT_EQ(must(environment_->present_model(0)), erring);
  EXPECT_EQ(environment_->present_model(7).error().code, Errc::OutOfRange);
  EXPECT_NEAR(must(backend_->range_sensor(1)->read()), before - 0.05, 1e-9);
  erring.range_sensors.pop_back();
  const auto refused = environment_->set_errors(0, erring);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Errc::OutOfRange);
}

TEST_F(SimEnvironmentTest, ObjectsHaveNumbersThatAreNotThoseOfBodies) {
  world::ObjectSpec post;
  post.kind = world::ObjectKind::Can;
  post.name = "can";
  post.radius = 0.05;
  post.matter.fixed = true;
  const Pose robot = must(environment_->control().robot_pose(1));
  post.pose = {robot.x + 0.4, robot.y, 0.0};
  ASSERT_EQ(must(environment_->control().add_object(post)), 2);
  EXPECT_EQ(look().objects, (std::vector<world::BodyId>{0, 3}));
  ASSERT_TRUE(backend_->drive()->set_speed({0.3, 0.0}));
  backend_->clock().wait_until(from_seconds(3.0));
  ASSERT_EQ(look().collisions.size(), 1U);
  EXPECT_EQ(look_.collisions[0].with_body, 3U);
  EXPECT_EQ(look_.collisions[0].with_object, 1U);
  const std::vector<std::string> told = log_.messages(Severity::Warning);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_TRUE(told[0].starts_with("robot 1 hit object 2 at")) << told[0];
}

TEST_F(SimEnvironmentTest, NobodyReachesARobotThatWasRemoved) {
  const Config config = rig_config({{"fast", "true"}, {"robots", "2"}});
  SharedSim shared(rig_scenario(1.0), config, &turns_, log_);
  Environment& environment = shared.environment();
  environment.look(look_);
  ASSERT_TRUE(look_.robots.at(1).is_there);
  const world::BodyId body = look_.robots[1].body;
  ASSERT_TRUE(shared.can_leave(1));
  ASSERT_TRUE(shared.leave(1));
  environment.look(look_);
  ASSERT_EQ(look_.robots.size(), 2U) << "numbers stay";
  EXPECT_FALSE(look_.robots[1].is_there);
  EXPECT_TRUE(look_.robots[0].is_there);
  for (const world::BodyView& seen : look_.scene.bodies) EXPECT_NE(seen.id, body);
  const Pose place{0.5, 0.5, 0.0};
  EXPECT_EQ(environment.drive(1, {0.1, 0.0}).error().what, "robot 2 has been removed");
  EXPECT_EQ(environment.set_errors(1, rig_model()).error().code, Errc::OutOfRange);
  EXPECT_EQ(environment.control().robot_pose(2).error().code, Errc::OutOfRange);
  EXPECT_EQ(environment.control().set_robot_pose(2, place).error().code, Errc::OutOfRange);
  EXPECT_EQ(shared.can_leave(1).error().what, "robot 2 has been removed");
  EXPECT_EQ(shared.leave(1).error().code, Errc::OutOfRange);
  EXPECT_EQ(shared.leave(7).error().what, "no robot 8, the world has 2");
}

TEST_F(SimEnvironmentTest, KnowsWhereACameraLooks) {
  ASSERT_TRUE(look().robots[0].eye);
  const double before = look().robots[0].eye->heading;
  ASSERT_TRUE(backend_->servo(1)->set(1.0));
  EXPECT_NEAR(wrap_angle(look().robots[0].eye->heading - before), rig_model().camera->max_pan,
              1e-6);
}

TEST(SharedEnvironment, IsOneForAllRobots) {
  KeepingLog log;
  const Config config = rig_config({{"robots", "2"}});
  const auto world = open_shared_world(config, log, nullptr);
  Environment& environment = world->environment();
  WorldLook look;
  environment.look(look);
  EXPECT_EQ(look.robots.size(), 2U);
  for (const std::size_t robot : {0U, 1U}) {
    const WorldSlot slot{world, robot};
    const auto backend = open_backend({config, log, &slot});
    EXPECT_EQ(backend->environment(), &environment);
  }
  environment.time().pause();
  world->begin_time();
  EXPECT_TRUE(environment.time().is_paused()) << "who begins does not undo what a person did";
}

}  // namespace
}  // namespace eyebridge::hal
