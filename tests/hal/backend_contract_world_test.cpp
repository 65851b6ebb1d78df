// The central test: the world around the robot, and what its camera looks at, where they are
// simulated. Its rows are in backend_contract_test.cpp.
#include <cmath>

#include <gmock/gmock.h>

#include "backend_contract.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/view.hpp"

namespace eyebridge::hal {
namespace {

TEST_P(BackendContract, TheRobotHasANumber) { EXPECT_EQ(make(0.5).backend->robot_id(), 1); }

TEST_P(BackendContract, TheCameraLooksWhereTheRobotIs) {
  const Rig rig = make_at({1.0, 0.5, kPi / 2});
  const camera::View* view = rig.backend->camera_view();
  ASSERT_EQ(view != nullptr, traits().world);
  if (view == nullptr) return;
  const camera::Eye eye = view->eye();
  EXPECT_NEAR(eye.x, 1.0, 1e-9);
  EXPECT_NEAR(eye.y, 0.5 + rig_model().camera->x, 1e-9);
  EXPECT_NEAR(eye.z, rig_model().camera->z, 1e-9);
  EXPECT_NEAR(eye.heading, kPi / 2, 1e-9);
  EXPECT_NEAR(eye.pitch, 0.0, 1e-9);
}

TEST_P(BackendContract, TheCameraMovesWithTheRobot) {
  const Rig rig = make(0.5);
  WorldControl* world = rig.backend->world();
  ASSERT_EQ(world != nullptr, traits().world);
  if (world == nullptr) return;
  ASSERT_TRUE(world->set_robot_pose(0, {1.0, 0.5, kPi / 2}));
  const camera::Eye eye = rig.backend->camera_view()->eye();
  EXPECT_NEAR(eye.x, 1.0, 1e-9);
  EXPECT_NEAR(eye.y, 0.5 + rig_model().camera->x, 1e-9);
  EXPECT_NEAR(eye.heading, kPi / 2, 1e-9);
}

TEST_P(BackendContract, TheCameraSeesAllBodiesAndKnowsItsCarrier) {
  const Rig rig = make(0.5);
  const camera::View* view = rig.backend->camera_view();
  ASSERT_EQ(view != nullptr, traits().world);
  if (view == nullptr) return;
  const world::Scene scene = view->scene();
  ASSERT_EQ(scene.bodies.size(), 3u);
  EXPECT_EQ(scene.model->walls.size(), 5u);
  EXPECT_EQ(scene.bodies.at(view->carrier()).pose, must(rig.backend->world()->robot_pose(0)));
}

TEST_P(BackendContract, WorldControlCountsFromOneAndKnowsItsOwnRobotAsZero) {
  const Rig rig = make(0.5);
  WorldControl* world = rig.backend->world();
  ASSERT_EQ(world != nullptr, traits().world);
  if (world == nullptr) return;
  EXPECT_EQ(world->robot_count(), 2);
  EXPECT_EQ(world->object_count(), 1);
  EXPECT_EQ(must(world->robot_pose(0)), must(world->robot_pose(1)));
  EXPECT_NEAR(must(world->robot_pose(2)).y, 1.5, 1e-9);
  EXPECT_NEAR(must(world->object_pose(1)).y, 0.5, 1e-9);
}

TEST_P(BackendContract, WorldControlRefusesUnknownIdsAndPoses) {
  const Rig rig = make(0.5);
  WorldControl* world = rig.backend->world();
  ASSERT_EQ(world != nullptr, traits().world);
  if (world == nullptr) return;
  EXPECT_EQ(world->robot_pose(3).error().what, "no robot 3, the world has 2");
  EXPECT_EQ(world->robot_pose(-1).error().code, Errc::OutOfRange);
  EXPECT_EQ(world->object_pose(0).error().what, "no object 0, the world has 1");
  EXPECT_EQ(world->set_object_pose(2, {}).error().code, Errc::OutOfRange);
  EXPECT_EQ(world->set_robot_pose(1, {std::nan(""), 0, 0}).error().code, Errc::OutOfRange);
}

TEST_P(BackendContract, RobotsWithWheelsStayOnTheFloor) {
  const Rig rig = make(0.5);
  WorldControl* world = rig.backend->world();
  ASSERT_EQ(world != nullptr, traits().world);
  if (world == nullptr) return;
  ASSERT_TRUE(world->set_robot_altitude(0, 1.0));
  EXPECT_EQ(must(world->robot_altitude(0)), 0.0);
  EXPECT_EQ(world->robot_altitude(3).error().what, "no robot 3, the world has 2");
  EXPECT_EQ(world->set_robot_altitude(3, 0.0).error().code, Errc::OutOfRange);
  EXPECT_EQ(world->set_robot_altitude(0, std::nan("")).error().code, Errc::OutOfRange);
}

TEST_P(BackendContract, WorldControlMovesRobotsAndObjects) {
  const Rig rig = make(0.5);
  WorldControl* world = rig.backend->world();
  ASSERT_EQ(world != nullptr, traits().world);
  if (world == nullptr) return;
  ASSERT_TRUE(world->set_robot_pose(0, facing(1.0)));
  EXPECT_NEAR(front(rig), 1.0, traits().range);
  const double at = facing(0.3).x + kFrontOffset;
  ASSERT_TRUE(world->set_object_pose(1, {at, kSideWall, 0.0}));
  EXPECT_NEAR(front(rig), 0.7 - world::ObjectSpec{}.radius, traits().range);
}

TEST_P(BackendContract, WorldControlAddsChangesAndRemovesObjects) {
  const Rig rig = make(1.0);
  WorldControl* world = rig.backend->world();
  ASSERT_EQ(world != nullptr, traits().world);
  if (world == nullptr) return;
  world::ObjectSpec can;
  can.kind = world::ObjectKind::Can;
  can.name = "can";
  can.radius = 0.033;
  can.height = 0.115;
  can.colour = {200, 30, 30};
  can.matter.friction = 0.3;
  can.pose = {facing(1.0).x + kFrontOffset + 0.5, kSideWall, 0.25};
  EXPECT_EQ(must(world->add_object(can)), 2);
  EXPECT_EQ(world->object_count(), 2);
  EXPECT_EQ(must(world->object_pose(2)), can.pose);
  EXPECT_NEAR(front(rig), 0.5 - can.radius, traits().range);
  EXPECT_TRUE(world->set_object_velocity(2, {0.1, 0.0}));
  EXPECT_TRUE(world->set_object_fixed(2, true));
  EXPECT_EQ(world->set_object_velocity(2, {0.1, 0.0}).error().what,
            "object 2 does not roll or slide: expected a ball, or one with a friction, that is not "
            "fixed");
  EXPECT_EQ(world->add_object(can).error().code, Errc::OutOfRange) << "one stands there";
  ASSERT_TRUE(world->remove_object(2));
  EXPECT_NEAR(front(rig), 1.0, traits().range);
  EXPECT_EQ(world->object_count(), 2) << "numbers stay";
  EXPECT_EQ(world->object_pose(2).error().what, "object 2 has been removed");
  EXPECT_EQ(world->remove_object(2).error().code, Errc::OutOfRange);
  EXPECT_EQ(world->remove_object(3).error().what, "no object 3, the world has 2");
}

TEST_P(BackendContract, APolygonIsMetAndSeenAndTakesAnotherWay) {
  const Rig rig = make(1.0);
  WorldControl* world = rig.backend->world();
  ASSERT_EQ(world != nullptr, traits().world);
  if (world == nullptr) return;
  world::ObjectSpec wedge;
  wedge.kind = world::ObjectKind::Polygon;
  wedge.name = "polygon";
  wedge.corners = {{0.1, 0.0}, {-0.05, 0.1}, {-0.05, -0.1}};
  wedge.pose = {facing(1.0).x + kFrontOffset + 0.5, kSideWall, kPi};
  const int id = must(world->add_object(wedge));
  EXPECT_NEAR(front(rig), 0.4, traits().range) << "its tip points here";
  if (traits().one_world) {
    const world::Scene scene = rig.backend->camera_view()->scene();
    const auto polygon =
        std::ranges::find(scene.bodies, world::BodyShape::Polygon, &world::BodyView::shape);
    ASSERT_NE(polygon, scene.bodies.end());
    ASSERT_NE(polygon->corners, nullptr);
    EXPECT_EQ(*polygon->corners, wedge.corners);
  }
  EXPECT_TRUE(world->set_object_velocity(id, {0.1, 0.0}).error().code == Errc::OutOfRange);
  ASSERT_TRUE(world->change_object(id, "friction 0.2\nmass 3"));
  EXPECT_TRUE(world->set_object_velocity(id, {0.0, 0.0}));
  ASSERT_TRUE(world->change_object(id, "wander 100"));
  EXPECT_EQ(world->set_object_fixed(id, true).error().what,
            "object " + std::to_string(id) + " moves by itself");
  ASSERT_TRUE(world->change_object(id, "still\nfixed"));
  EXPECT_TRUE(world->set_object_fixed(id, false));
  EXPECT_EQ(world->change_object(id, "mass -1").error().code, Errc::OutOfRange);
  EXPECT_EQ(world->change_object(id, "can 1 2 3").error().what,
            "object:1:1: 'can' found: expected what may follow the line of an object");
  EXPECT_EQ(world->change_object(id + 1, "fixed").error().code, Errc::OutOfRange);
}

}  // namespace
}  // namespace eyebridge::hal
