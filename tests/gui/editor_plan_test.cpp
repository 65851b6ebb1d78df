// What the world editor does to plans, without a window.
#include <QImage>
#include <QPainter>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document.hpp"
#include "editor/edits.hpp"
#include "editor/floor_plan.hpp"
#include "editor/maze_fit.hpp"
#include "editor/pick.hpp"
#include "eyebridge/base/config_error.hpp"

namespace eyebridge::gui {
namespace {

using ::testing::HasSubstr;

bool is_s4(const std::string& model) { return model == "S4"; }
bool is_can_file(const std::string& model) { return !is_s4(model); }

Plan plan_with_robots(int count) {
  Plan plan = empty_plan(4, 4);
  for (int i = 0; i < count; ++i) add_robot(plan, "S4", {0.5 * (i + 1), 1});
  return plan;
}

TEST(EditorPlan, StepsAreUndoneToTheLastBit) {
  Document document(plan_with_robots(2));
  const Plan first = document.plan();
  document.edit("a", [](Plan& plan) {
    plan.width = 5;
    plan.texture = "grass.png";
    add_thing(plan, "box", {1, 2});
    remove_items(plan, {{Kind::Wall, 1}, {Kind::Robot, 0}}, is_can_file);
    plan.rest.show_trail = true;
  });
  const Plan second = document.plan();
  document.edit("b", [](Plan& plan) { move_items(plan, all_items(plan), {0.3, 0.1}); });
  const Plan third = document.plan();
  document.history().undo();
  EXPECT_TRUE(same_plan(document.plan(), second));
  document.history().undo();
  EXPECT_TRUE(same_plan(document.plan(), first));
  document.history().redo();
  document.history().redo();
  EXPECT_TRUE(same_plan(document.plan(), third));
}

TEST(EditorPlan, WaterStaysInItsWorld) {
  Plan plan = plan_with_robots(1);
  const Plan dry = plan;
  plan.water = 1.5;
  EXPECT_FALSE(same_plan(plan, dry));
  EXPECT_EQ(ground_of(plan, false).water, 1.5);
}

TEST(EditorPlan, WhatChangesNothingIsNoStep) {
  Document document(empty_plan(4, 4));
  document.edit("nothing", [](Plan& plan) { move_items(plan, {{Kind::Wall, 0}}, {0, 0}); });
  EXPECT_EQ(document.history().count(), 0);
  document.preview([](Plan& plan) { plan.width = 9; });
  EXPECT_EQ(document.plan().width, 9.0);
  EXPECT_EQ(document.settled().width, 4.0);
  document.cancel();
  EXPECT_EQ(document.plan().width, 4.0);
}

TEST(EditorPlan, SumsOfLengthsStayDecimal) {
  Plan plan = empty_plan(4, 4);
  add_marker(plan, {0.1, 0.7});
  move_items(plan, {{Kind::Marker, 0}}, {0.2, 0.1});
  EXPECT_EQ(plan.markers[0].position, (Vec2{0.3, 0.8})) << "not 0.30000000000000004";
}

TEST(EditorPlan, ErrorsFollowTheNumbersOfTheirRobots) {
  Plan plan = plan_with_robots(4);
  plan.robots[0].enters = 5;  // so it is number 4
  std::vector<Warning> warnings;
  plan.rest = files::read_sim(
      "error robot:1 harsh\nerror robot:2 harsh\nerror robot:4 harsh\nerror realistic\n", "s",
      warnings);
  remove_items(plan, {{Kind::Robot, 1}}, is_can_file);  // number 1
  std::vector<int> numbers;
  for (const auto& rule : plan.rest.errors) numbers.push_back(rule.robot.value_or(0));
  EXPECT_EQ(numbers, (std::vector<int>{1, 3, 0}));
}

TEST(EditorPlan, ErrorsStayWithTheirRobotsWhenOthersCome) {
  Plan plan = plan_with_robots(2);
  plan.robots[1].enters = 5;
  std::vector<Warning> warnings;
  plan.rest = files::read_sim("error robot:1 harsh\nerror robot:2 harsh\n", "s", warnings);
  keep_numbers(plan, is_can_file, [&] { add_robot(plan, "S4", {3, 3}); });
  EXPECT_EQ(plan.rest.errors[1].robot, 3) << "who enters later comes after the new one";
  keep_numbers(plan, is_can_file, [&] { plan.robots[0].enters = 9; });
  EXPECT_EQ(plan.rest.errors[0].robot, 3);
  EXPECT_EQ(plan.rest.errors[1].robot, 2);
}

TEST(EditorPlan, ARobotAtALetterLeavesItWhenItIsMoved) {
  Plan plan = empty_plan(4, 4);
  plan.starts.push_back({'S', {1, 1, kPi / 2}});
  add_robot(plan, "S4", {3, 3});
  plan.robots[0].start = 'S';
  plan.robots[0].pose.reset();
  EXPECT_EQ(pose_of_robot(plan, 0), (Pose{1, 1, kPi / 2}));
  turn_item(plan, {Kind::Robot, 0}, 0.0);
  EXPECT_EQ(plan.robots[0].start, 'S') << "only its heading is its own";
  move_items(plan, {{Kind::Robot, 0}}, {1, 0});
  EXPECT_FALSE(plan.robots[0].start);
  EXPECT_EQ(plan.robots[0].pose, (Pose{2, 1, 0}));
}

TEST(EditorPlan, WhereTwoWayPointsBecomeOneTheSecondOnesSpeedGoes) {
  Plan plan = empty_plan(4, 4);
  const Item can = add_thing(plan, "can", {1, 1});
  add_way_point(plan, can, 0, {2, 1});
  make_way(plan, can)->points = {{2, 1}, {3, 1}, {2, 1}, {2, 3}};
  make_way(plan, can)->leg_speeds = {0.1, 0.2, 0.3, 0.4};
  make_way(plan, can)->waits = {1, 2, 3, 4};
  remove_way_point(plan, can, 1);
  EXPECT_EQ(way_of(plan, can)->points, (std::vector<Vec2>{{2, 1}, {2, 3}}));
  EXPECT_EQ(way_of(plan, can)->leg_speeds, (std::vector<double>{0.1, 0.4}));
  EXPECT_EQ(way_of(plan, can)->waits, (std::vector<double>{1, 4}));
}

TEST(EditorPlan, SpeedsAndWaitsStayWithTheirWayPoints) {
  Plan plan = empty_plan(4, 4);
  const Item can = add_thing(plan, "can", {1, 1});
  add_way_point(plan, can, 0, {2, 1});
  add_way_point(plan, can, 1, {3, 1});
  make_way(plan, can)->leg_speeds = {0.1, 0.2};
  make_way(plan, can)->waits = {1, 2};
  add_way_point(plan, can, 1, {2, 2});
  EXPECT_EQ(way_of(plan, can)->leg_speeds, (std::vector<double>{0.1, 0.2, 0.2}));
  EXPECT_EQ(way_of(plan, can)->waits, (std::vector<double>{1, 0, 2}));
  remove_way_point(plan, can, 0);
  EXPECT_EQ(way_of(plan, can)->leg_speeds, (std::vector<double>{0.2, 0.2}));
  EXPECT_EQ(way_of(plan, can)->waits, (std::vector<double>{0, 2}));
  world::Path& way = *make_way(plan, can);
  way.waits = {1, 2, 3};
  way.loop = false;
  fit_profile(way);
  EXPECT_EQ(way.waits, (std::vector<double>{1, 2}));
}

TEST(EditorPlan, SeveralThingsTakeTheirWaysAlong) {
  Plan plan = empty_plan(4, 4);
  const Item can = add_thing(plan, "can", {1, 1});
  add_way_point(plan, can, 0, {2, 1});
  EXPECT_FALSE(add_way_point(plan, can, 1, {2, 1})) << "twice the same place is no way";
  move_items(plan, {can}, {0, 1});
  EXPECT_EQ(way_of(plan, can)->points[0], (Vec2{2, 1}));
  move_items(plan, {can, add_marker(plan, {3, 3})}, {0, 1});
  EXPECT_EQ(way_of(plan, can)->points[0], (Vec2{2, 2}));
  remove_way_point(plan, can, 0);
  EXPECT_EQ(way_of(plan, can), nullptr);
}

TEST(EditorPlan, PlacesSnapToVerticesBeforeTheGrid) {
  Plan plan = empty_plan(4, 4);
  plan.walls[0].b = {3.97, 0.02};
  EXPECT_EQ(on_vertex_or_grid(plan, {3.95, 0}, 0.1, 0.05), (Vec2{3.97, 0.02}));
  EXPECT_EQ(on_vertex_or_grid(plan, {2.04, 1.96}, 0.1, 0.05), (Vec2{2.0, 2.0}));
  EXPECT_EQ(on_grid({0.299, 0.7004}, 0.1), (Vec2{0.3, 0.7}));
  EXPECT_EQ(on_grid({0.12345, 0}, 0.0), (Vec2{0.123, 0}));
  EXPECT_EQ(straightened({1, 1}, {1.1, 3}), (Vec2{1, 3}));
}

TEST(EditorPlan, WhatIsPointedAtIsTheTopmost) {
  Plan plan = empty_plan(4, 4);
  const Catalogue catalogue;
  add_thing(plan, "crate", {2, 2});
  add_robot(plan, "S4", {2.1, 2});
  const auto hold = [&](double x, double y) { return pick(plan, catalogue, {x, y}, 0.01).value(); };
  EXPECT_EQ(hold(2.1, 2).item.kind, Kind::Robot);
  EXPECT_EQ(hold(2.1, 2).part, Hold::Part::Body);
  EXPECT_EQ(hold(2.185, 2).part, Hold::Part::Rim);
  EXPECT_EQ(hold(1.9, 2).item.kind, Kind::Thing);
  EXPECT_EQ(hold(4, 4.005).part, Hold::Part::Vertex);
  EXPECT_EQ(hold(4, 2).item, (Item{Kind::Wall, 1}));
  EXPECT_FALSE(pick(plan, catalogue, {3, 3}, 0.01));
}

TEST(EditorMaze, AWorldOnAGridIsAMaze) {
  Plan plan = empty_plan(1.8, 1.08);
  add_wall(plan, {0.36, 0}, {0.36, 0.72}, {});
  add_start(plan, {0.18, 0.18});
  plan.starts[0].pose.theta = kPi / 2;
  add_thing(plan, "golf", {0.9, 0.54});
  const MazeFit fit = fit_maze(plan, true);
  ASSERT_TRUE(fit.maze) << fit.why.toStdString();
  EXPECT_EQ(fit.maze->maze->cell, 0.36);
  EXPECT_EQ(fit.maze->maze->columns, 5);
  EXPECT_EQ(fit.maze->walls.size(), 16U + 2U);
  EXPECT_EQ(fit.maze->starts[0].letter, 'U');
}

TEST(EditorMaze, AFinerGridIsTakenWhereStartsNeedIt) {
  Plan plan = empty_plan(4, 4);
  add_start(plan, {0.25, 0.25});
  const MazeFit fit = fit_maze(plan, true);
  ASSERT_TRUE(fit.maze) << fit.why.toStdString();
  EXPECT_EQ(fit.maze->maze->cell, 0.5);
}

std::string why_no_maze(const std::function<void(Plan&)>& change) {
  Plan plan = empty_plan(1.8, 1.8);
  plan.cell = 0.36;
  change(plan);
  return fit_maze(plan, true).why.toStdString();
}

TEST(EditorMaze, SaysPreciselyWhatDoesNotFit) {
  const auto wall = [](Vec2 a, Vec2 b) { return [=](Plan& plan) { add_wall(plan, a, b, {}); }; };
  EXPECT_EQ(why_no_maze(wall({0.36, 0}, {0.4, 0.36})),
            "the wall from (360, 0) mm to (400, 360) mm is slanted");
  EXPECT_EQ(why_no_maze(wall({0.36, 0}, {0.36, 0.4})),
            "the wall from (360, 0) mm to (360, 400) mm does not lie between cells of 360 mm");
  EXPECT_EQ(why_no_maze(wall({1.8, 0}, {2.16, 0})),
            "the wall from (1800, 0) mm to (2160, 0) mm leaves the floor");
  EXPECT_THAT(why_no_maze([](Plan& plan) { plan.walls[0].thickness = 0.02; }),
              HasSubstr("the wall from (0, 0) mm to (1800, 0) mm has a thickness"));
  EXPECT_EQ(why_no_maze([](Plan& plan) { plan.width = 1.9; }),
            "its floor of 1900 mm x 1800 mm is no whole number of cells of 360 mm");
  EXPECT_THAT(why_no_maze([](Plan& plan) { plan.texture = "x.png"; }), HasSubstr("floor texture"));
  EXPECT_THAT(why_no_maze([](Plan& plan) { plan.water = 2; }), HasSubstr("it has water"));
  EXPECT_THAT(why_no_maze([](Plan& plan) {
                add_marker(plan, {1, 1});
              }),
              HasSubstr("a marker at (1000, 1000) mm"));
  EXPECT_THAT(why_no_maze([](Plan& plan) {
                add_robot(plan, "S4", {1, 1});
              }),
              HasSubstr("it has robots"));
  EXPECT_THAT(why_no_maze([](Plan& plan) {
                add_thing(plan, "can", {0.18, 0.18});
              }),
              HasSubstr("a can at (180, 180) mm"));
  EXPECT_THAT(why_no_maze([](Plan& plan) {
                add_start(plan, {0.18, 0.18});
                plan.starts[0].pose.theta = 0.3;
              }),
              HasSubstr("faces 17.1887 degrees"));
  EXPECT_EQ(why_no_maze([](Plan& plan) {
              add_start(plan, {0.2, 0.2});
            }),
            "a start at (200, 200) mm does not stand in the middle of one of its cells of 360 mm");
  EXPECT_THAT(why_no_maze([](Plan& plan) { plan.walls.clear(); }), HasSubstr("no wall"));
}

QImage paper(int width, int height) {
  QImage image(width, height, QImage::Format_RGB32);
  image.fill(Qt::white);
  return image;
}

TEST(EditorFloorPlan, OutlinesAreThoseOfThePixels) {
  QImage image = paper(40, 30);
  QPainter(&image).fillRect(10, 5, 20, 10, Qt::black);
  const files::FloorPlan plan = read_floor_plan(image, {0.01, {}, 1.0});
  EXPECT_EQ(plan.width, 0.4);
  EXPECT_EQ(plan.height, 0.3);
  ASSERT_EQ(plan.walls.size(), 4U);
  EXPECT_EQ(plan.walls[0].a, (Vec2{0.1, 0.25}));
  EXPECT_EQ(plan.walls[0].b, (Vec2{0.3, 0.25}));
  EXPECT_EQ(plan.walls[1].b, (Vec2{0.3, 0.15}));
}

TEST(EditorFloorPlan, ARoomHasAnOuterAndAnInnerOutline) {
  QImage image = paper(100, 100);
  QPainter painter(&image);
  painter.fillRect(0, 0, 100, 100, QColor(40, 40, 60));
  painter.fillRect(5, 5, 90, 90, QColor(230, 230, 210));
  painter.end();
  EXPECT_EQ(read_floor_plan(image, {0.05, {}, 1.0}).walls.size(), 8U);
}

TEST(EditorFloorPlan, SlantedEdgesBecomeOneWall) {
  QImage image = paper(200, 200);
  QPainter painter(&image);
  painter.setBrush(Qt::black);
  painter.setPen(Qt::NoPen);
  painter.drawPolygon(QPolygon({QPoint(20, 20), QPoint(180, 60), QPoint(60, 180)}));
  painter.end();
  const files::FloorPlan plan = read_floor_plan(image, {0.01, 128, 1.5});
  EXPECT_GE(plan.walls.size(), 3U);
  EXPECT_LE(plan.walls.size(), 5U);
}

TEST(EditorFloorPlan, SaysWhatIsWrongWithAPicture) {
  const auto why = [](const QImage& image, std::optional<int> threshold) -> std::string {
    try {
      static_cast<void>(read_floor_plan(image, {0.01, threshold, 1.0}));
    } catch (const ConfigError& error) {
      return error.text();
    }
    return "";
  };
  EXPECT_THAT(why(QImage(), {}), HasSubstr("no picture"));
  EXPECT_THAT(why(paper(9, 9), {}), HasSubstr("nothing in it is dark"));
}

}  // namespace
}  // namespace eyebridge::gui
