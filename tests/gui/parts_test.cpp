#include <QImage>
#include <QPainter>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "environment/trails.hpp"
#include "plan/grip.hpp"
#include "plan/mirror.hpp"
#include "plan/paint_world.hpp"
#include "room.hpp"

namespace eyebridge::gui {
namespace {

using ::testing::Each;

hal::WorldLook look_at(testing::Room& room) {
  hal::WorldLook look;
  room.environment().look(look);
  return look;
}

TEST(Mirror, SeesWhatTheRobotsSee) {
  testing::Room room;
  Mirror mirror;
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(room.robot().drive()->set_speed({0.1, 0.8}));
    room.pass(0.3);
    const hal::WorldLook look = look_at(room);
    mirror.follow(look);
    const auto rays = mirror.distance_rays(0);
    ASSERT_FALSE(rays.empty());
    for (std::size_t k = 0; k < rays.size(); ++k) {
      const int id = look.robots[0].model->range_sensors[k].id;
      const double read = room.robot().range_sensor(id)->read().value();
      EXPECT_NEAR(rays[k].range, read, 1e-6) << "sensor " << id;
      EXPECT_NEAR(norm(rays[k].to - rays[k].from), rays[k].range, 1e-6);
    }
  }
}

TEST(Mirror, KnowsWhatIsFree) {
  testing::Room room;
  Mirror mirror;
  const hal::WorldLook look = look_at(room);
  mirror.follow(look);
  const world::BodyId first = look.robots[0].body;
  EXPECT_TRUE(mirror.is_free(first, {0.5, 0.5})) << "its own place";
  EXPECT_TRUE(mirror.is_free(first, {0.2, 0.8}));
  EXPECT_FALSE(mirror.is_free(first, {1.5, 0.5})) << "another robot";
  EXPECT_FALSE(mirror.is_free(first, {1.0, 0.2})) << "a can";
  EXPECT_FALSE(mirror.is_free(first, {0.05, 0.5})) << "a wall";
  EXPECT_THAT(mirror.bumpers(0), Each(false));
}

world::ObjectSpec long_polygon(double reach) {
  world::ObjectSpec out;
  out.kind = world::ObjectKind::Polygon;
  out.name = "polygon";
  out.corners = {{reach, 0.0}, {-0.05, 0.02}, {-0.05, -0.02}};
  return out;
}

TEST(Mirror, HasRoomForLargeNewcomersOfOneLook) {
  testing::Room room;
  Mirror mirror;
  mirror.follow(look_at(room));
  hal::WorldControl& control = room.environment().control();
  for (const double theta : {0.0, kPi}) {  // they reach over the room's walls, far outside of it
    world::ObjectSpec object = long_polygon(9.9);
    object.pose = {theta == 0.0 ? 50.0 : -50.0, 0.5, theta};
    ASSERT_TRUE(control.add_object(object));
  }
  EXPECT_NO_THROW(mirror.follow(look_at(room)));
}

TEST(Mirror, TheOutlineOfAThingCountsAndNotTheDiscAroundIt) {
  testing::Room room;
  Mirror mirror;
  world::ObjectSpec object = long_polygon(0.3);
  object.pose = {0.9, 0.8, 0.0};
  ASSERT_TRUE(room.environment().control().add_object(object));
  const hal::WorldLook look = look_at(room);
  mirror.follow(look);
  EXPECT_TRUE(grip_at(look, {1.0, 0.8}, 0.005));
  EXPECT_FALSE(grip_at(look, {0.9, 0.7}, 0.005)) << "beside it, within the disc that covers it";
  EXPECT_TRUE(mirror.is_free(look.objects.at(1), {0.9, 0.9})) << "nearer to the wall than its tip";
  EXPECT_FALSE(mirror.is_free(look.objects.at(1), {1.8, 0.8})) << "its tip in the wall";
}

TEST(Mirror, FollowsWhatComesAndGoes) {
  testing::Room room;
  Mirror mirror;
  mirror.follow(look_at(room));
  world::ObjectSpec box;
  box.kind = world::ObjectKind::Box;
  box.name = "box";
  box.size = {0.1, 0.2};
  box.pose = {0.9, 0.5, 0.0};
  hal::WorldControl& control = room.environment().control();
  ASSERT_EQ(control.add_object(box).value(), 2);
  const hal::WorldLook look = look_at(room);
  const world::BodyId body = look.objects.at(1);
  mirror.follow(look);
  EXPECT_FALSE(mirror.is_free(look.robots[0].body, {0.9, 0.5}));
  const auto rays = mirror.distance_rays(0);
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const int id = look.robots[0].model->range_sensors[k].id;
    EXPECT_NEAR(rays[k].range, room.robot().range_sensor(id)->read().value(), 1e-6);
  }
  const auto grip = grip_at(look, {0.9, 0.5}, 0.0);
  ASSERT_TRUE(grip);
  EXPECT_EQ(grip->body, body);
  EXPECT_EQ(grip->object, 1U);
  ASSERT_TRUE(control.remove_object(1));
  ASSERT_TRUE(control.remove_object(2));
  mirror.follow(look_at(room));
  EXPECT_TRUE(mirror.is_free(look.robots[0].body, {0.9, 0.5}));
  EXPECT_TRUE(mirror.is_free(look.robots[0].body, {1.0, 0.2})) << "where the can was";
  ASSERT_EQ(control.add_object(box).value(), 3);
  mirror.follow(look_at(room));
  EXPECT_FALSE(mirror.is_free(look.robots[0].body, {0.9, 0.5}));
  Mirror late;
  late.follow(look_at(room));
  EXPECT_FALSE(late.is_free(look.robots[0].body, {0.9, 0.5}));
  EXPECT_TRUE(late.is_free(look.robots[0].body, {1.0, 0.2}));
}

/// A submarine in the middle of a pool of 4 m x 4 m, as far below the surface.
hal::WorldLook dived(double depth) {
  auto pool = std::make_shared<world::WorldModel>();
  pool->width = pool->height = 4.0;
  robot::RobotModel model;
  model.diameter = model.height = 0.4;
  model.drive.kind = robot::DriveKind::Submarine;
  model.range_sensors.emplace_back().kind = robot::RangeKind::Down;
  robot::Simulation sim(pool, {});
  const robot::RobotIndex robot = sim.add_robot(model, {2.0, 2.0, 0.0});
  sim.set_altitude(robot, sim.altitude(robot) - depth);
  hal::WorldLook look;
  look.scene = sim.world().scene(0.0);
  hal::RobotLook& seen = look.robots.emplace_back();
  seen.model = std::make_shared<const robot::RobotModel>(model);
  seen.body = sim.body(robot);
  seen.pose = sim.pose(robot);
  seen.altitude = sim.altitude(robot);
  seen.depth = sim.depth(robot);
  return look;
}

TEST(Mirror, KnowsHowDeepASubmarineIs) {
  Mirror mirror;
  mirror.follow(dived(0.5));
  const auto rays = mirror.distance_rays(0);
  ASSERT_EQ(rays.size(), 1U);
  EXPECT_NEAR(rays[0].range, 1.6 - 0.5 + robot::RangeSensorModel{}.height, 1e-12);
  EXPECT_EQ(rays[0].from, rays[0].to) << "it looks down";
}

TEST(PaintWorld, AGaugeBesideASubmarineSaysHowDeepItIs) {
  Viewport view;
  view.resize({400, 400});
  view.fit({}, {4.0, 4.0});
  // Rows of the bar's column in the colour of the water above the mark.
  const auto blue = [&](double depth) {
    QImage picture(400, 400, QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    paint_bodies(painter, view, dived(depth), std::nullopt);
    painter.end();
    const int x = qRound(200 + 0.2 * view.pixels_per_metre() + 12);
    int rows = 0;
    for (int y = 0; y < 400; ++y) rows += picture.pixelColor(x, y) == QColor(40, 120, 190);
    return rows;
  };
  EXPECT_EQ(blue(0.0), 0);
  EXPECT_NEAR(blue(0.8), 20, 2) << "of 40 pixels the half";
  EXPECT_NEAR(blue(1.6), 40, 2);
}

TEST(Grip, TakesRobotsByMiddleAndRimAndThings) {
  testing::Room room;
  const hal::WorldLook look = look_at(room);
  const auto middle = grip_at(look, {0.52, 0.5}, 0.0);
  ASSERT_TRUE(middle);
  EXPECT_EQ(middle->robot, 0U);
  EXPECT_FALSE(middle->turns);
  EXPECT_EQ(moved(*middle, {0.72, 0.4}), (Pose{0.7, 0.4, 0.0}));
  const auto rim = grip_at(look, {0.5, 0.58}, 0.0);
  ASSERT_TRUE(rim);
  EXPECT_TRUE(rim->turns);
  EXPECT_NEAR(moved(*rim, {-3.0, 0.5}).theta, kPi / 2, 1e-6);
  const auto can = grip_at(look, {1.0, 0.2}, 0.0);
  ASSERT_TRUE(can);
  EXPECT_FALSE(can->robot);
  EXPECT_FALSE(can->turns);
  EXPECT_FALSE(grip_at(look, {1.0, 0.7}, 0.0));
  EXPECT_FALSE(grip_at(look, {0.5, 0.61}, 0.0));
  EXPECT_TRUE(grip_at(look, {0.5, 0.61}, 0.02)) << "who points beside it by less than that";
}

TEST(Trails, GrowWithTheWayAndBreakWhereARobotIsCarried) {
  testing::Room room;
  Trails trails;
  trails.add(look_at(room));
  trails.add(look_at(room));
  EXPECT_EQ(trails.of(0).points.size(), 1U) << "nobody moved";
  ASSERT_TRUE(room.robot().drive()->set_speed({0.2, 0.0}));
  for (int i = 0; i < 10; ++i) {
    room.pass(0.1);
    trails.add(look_at(room));
  }
  EXPECT_GT(trails.of(0).points.size(), 8U);
  EXPECT_FALSE(trails.of(0).points.back().begins);
  ASSERT_TRUE(room.environment().control().set_robot_pose(1, {0.3, 0.8, 0.0}));
  trails.add(look_at(room));
  EXPECT_TRUE(trails.of(0).points.back().begins);
  EXPECT_EQ(trails.of(1).points.size(), 1U);
  EXPECT_TRUE(trails.of(7).points.empty());
  trails.clear();
  EXPECT_TRUE(trails.of(0).points.empty());
}

}  // namespace
}  // namespace eyebridge::gui
