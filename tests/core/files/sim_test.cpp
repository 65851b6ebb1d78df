#include <gmock/gmock.h>

#include "eyebridge/base/units.hpp"
#include "reading.hpp"

namespace eyebridge::files {
namespace {

using testing::HasSubstr;

std::vector<Warning> sim_warnings;

SimFile sim_of(const std::string& text) {
  sim_warnings.clear();
  return read_sim(text, "s.sim", sim_warnings);
}

TEST(Sim, ReadsFilesAndSettings) {
  const auto sim = sim_of(
      "maze \"a b.maz\"\nrobi x.robi\nROBOT y.robi\nobj o.esObj\n"
      "object p.esObj\nsettings trace VIS # both");
  EXPECT_EQ(sim.world, "a b.maz");
  EXPECT_EQ(sim.world_where, (SourceLocation{"s.sim", 1, 6}));
  ASSERT_EQ(sim.robot_files.size(), 2u);
  EXPECT_EQ(sim.robot_files[1].first, "y.robi");
  EXPECT_EQ(sim.object_files.size(), 2u);
  EXPECT_TRUE(sim.show_sensors);
  EXPECT_TRUE(sim.show_trail);
}

TEST(Sim, ReadsRobotsAtPosesAndLetters) {
  const auto sim = sim_of("LabBot 400 500 90 go.x a 'b c'\nS4 S 100 p.py\ns4 u q.x\nlabbot d\n");
  ASSERT_EQ(sim.robots.size(), 4u);
  EXPECT_EQ(sim.robots[0].pose, (Pose{0.4, 0.5, kPi / 2}));
  EXPECT_EQ(sim.robots[0].program, "go.x");
  EXPECT_EQ(sim.robots[0].arguments, (std::vector<std::string>{"a", "b c"}));
  EXPECT_EQ(sim.robots[1].start, 'S');
  EXPECT_EQ(sim.robots[1].pose->theta, deg_to_rad(100));
  EXPECT_EQ(sim.robots[1].program, "p.py");
  EXPECT_FALSE(sim.robots[2].pose);
  EXPECT_EQ(sim.robots[2].program, "q.x");
  EXPECT_EQ(sim.robots[3].start, 'd');
  EXPECT_EQ(sim.robots[3].program, "");
}

TEST(Sim, ReadsTheOldFormThatNamesFileAndProgram) {
  const auto sim = sim_of(
      "robi a/S4.robi drive.dll 600 500 0\nrobi a/S4.robi maze.dll\n"
      "object 800 700 0 0.0 %sim%/objects/can/can.ms3d\n");
  ASSERT_EQ(sim.robots.size(), 2u);
  EXPECT_EQ(sim.robots[0].model, "a/S4.robi");
  EXPECT_EQ(sim.robots[0].program, "drive.dll");
  EXPECT_EQ(sim.robots[0].pose, (Pose{0.6, 0.5, 0}));
  EXPECT_FALSE(sim.robots[1].pose);
  ASSERT_EQ(sim.objects.size(), 1u);
  EXPECT_EQ(sim.objects[0].name, "can");
  EXPECT_EQ(sim.objects[0].pose, (Pose{0.8, 0.7, 0}));
}

TEST(Sim, ReadsObjectsAndMarkers) {
  const auto sim = sim_of(
      "CAN 1 2 90\nSoccer 3 4 0\ngolf 5 6 0\nCrate 7 8 0\nmarker 9 10\n"
      "marker 1 2 3 4 5\nmarker 1 2 3 4 5 255\n");
  ASSERT_EQ(sim.objects.size(), 4u);
  EXPECT_EQ(sim.objects[0].kind, world::ObjectKind::Can);
  EXPECT_EQ(sim.objects[1].kind, world::ObjectKind::Ball);
  EXPECT_EQ(sim.objects[3].name, "crate");
  ASSERT_EQ(sim.markers.size(), 3u);
  EXPECT_EQ(sim.markers[0].colour, (Rgb{255, 0, 0}));
  EXPECT_EQ(sim.markers[2].colour, (Rgb{3, 4, 5}));
}

TEST(Sim, ReadsBoxesOfAnySizeAndColour) {
  const auto sim = sim_of("box 1000 2000 90 300 200\nBOX 1 2 0 30 20 150\nbox 1 2 0 3 4 5 6 7 8\n");
  ASSERT_EQ(sim.objects.size(), 3u);
  const world::ObjectSpec& box = sim.objects[0];
  EXPECT_EQ(box.kind, world::ObjectKind::Box);
  EXPECT_EQ(box.pose, (Pose{1, 2, kPi / 2}));
  EXPECT_EQ(box.size, (Vec2{0.3, 0.2}));
  EXPECT_EQ(box.height, 0.2);
  EXPECT_EQ(box.radius, box.outer_radius());
  EXPECT_EQ(sim.objects[1].height, 0.15);
  EXPECT_EQ(sim.objects[2].colour, (Rgb{6, 7, 8}));
}

TEST(Sim, ReadsPolygonsRoundEitherWay) {
  const auto sim = sim_of(
      "polygon 1000 2000 90 200 0 -100 150 -100 -150\n"
      "POLYGON 1 2 0 -100 -150 -100 150 200 0 colour 1 2 3 height 50\nmass 3\n"
      "polygon 1 2 0\n");
  ASSERT_EQ(sim.objects.size(), 2u);
  const world::ObjectSpec& one = sim.objects[0];
  EXPECT_EQ(one.kind, world::ObjectKind::Polygon);
  EXPECT_EQ(one.pose, (Pose{1, 2, kPi / 2}));
  EXPECT_EQ(one.corners, (std::vector<Vec2>{{0.2, 0}, {-0.1, 0.15}, {-0.1, -0.15}}));
  EXPECT_EQ(one.height, 0.2);
  EXPECT_EQ(one.radius, 0.2);
  EXPECT_EQ(sim.objects[1].corners, one.corners) << "the second one goes round clockwise";
  EXPECT_EQ(sim.objects[1].colour, (Rgb{1, 2, 3}));
  EXPECT_EQ(sim.objects[1].height, 0.05);
  EXPECT_EQ(sim.objects[1].matter.mass, 3);
  EXPECT_EQ(sim.robots.size(), 1u) << "what a file calls so";
}

TEST(Sim, LaterLinesUndoEarlierOnes) {
  const auto sim = sim_of(
      "Can 1 2 0\nfixed\nloose\npath 100 loop 3 4\nyields 5\nstill\nCan 1 2 0\nwander 5\nstill\n"
      "path 100 back 3 4\nDog 1 2 0\nfixed\nloose\nstill\n");
  ASSERT_EQ(sim.objects.size(), 2u);
  EXPECT_FALSE(sim.objects[0].matter.fixed);
  EXPECT_EQ(sim.objects[0].path, std::nullopt);
  EXPECT_EQ(sim.objects[0].yields_within, 0.0);
  EXPECT_EQ(sim.objects[1].reaction, std::nullopt);
  ASSERT_TRUE(sim.objects[1].path);
  ASSERT_EQ(sim.robots.size(), 1u);
  EXPECT_TRUE(sim.robots[0].traits.loose && sim.robots[0].traits.still);
  EXPECT_FALSE(sim.robots[0].traits.fixed);
  EXPECT_THAT(error_of([&] { sim_of("Can 1 2 0\nwander 5\nstill\nyields 5\n"); }),
              HasSubstr("of what stands"));
}

TEST(Sim, WhatIsThereIsChangedByTheSameLines) {
  world::ObjectSpec can;
  can.path = world::Path{0.1, true, {{1, 1}}};
  const world::ObjectSpec changed = read_object_change(can, "mass 2\nspeeds 50", "it");
  EXPECT_EQ(changed.matter.mass, 2);
  EXPECT_EQ(changed.path->leg_speeds, std::vector<double>{0.05});
  EXPECT_EQ(read_object_change(can, "", "it"), can);
  const world::ObjectSpec other = read_object_change(can, "wander 100\nyields 0", "it");
  EXPECT_EQ(other.path, std::nullopt) << "it takes the path's place";
  EXPECT_EQ(read_object_change(other, "path 5 back 1 1", "it").reaction, std::nullopt);
  EXPECT_THAT(error_of([&] { read_object_change(can, "wander 100\npath 5 back 1 1", "it"); }),
              HasSubstr("expected one of them"));
  EXPECT_THAT(error_of([&] { read_object_change(can, "mass 2\nCan 1 2 3", "it"); }),
              HasSubstr("it:2:1: 'Can' found"));
  EXPECT_THAT(error_of([&] { read_object_change(can, "mass x", "it"); }), HasSubstr("it:1:6:"));
}

TEST(Sim, PointsAtTheCornerThatCannotBe) {
  const auto error = [](const char* text) { return error_of([&] { sim_of(text); }); };
  EXPECT_THAT(error("polygon 1 2 0 200 0 -100 150"), HasSubstr(":1:29: corner 3"));
  EXPECT_THAT(error("polygon 1 2 0 9 9 9 -9 -9 -9 -9 -9"), HasSubstr(":1:30: a corner where"));
  std::string many = "polygon 1 2 0";
  for (int i = 17; i > 0; --i) many += " " + std::to_string(i) + " " + std::to_string(i * i);
  EXPECT_THAT(error(many.c_str()), HasSubstr("more than 16 corners"));
  const auto alone = [](const char* text) {
    return error_of([&] { read_object_text(text, "it"); });
  };
  EXPECT_THAT(alone("polygon 1 2 3"), HasSubstr("it:1:1: the polygon has no corners"));
  EXPECT_THAT(alone("box 1 2 3"), HasSubstr("it:1:1: the box has no size"));
  EXPECT_THAT(error("polygon 1 2 0 200 0 -100 150 -100"), HasSubstr("without its y"));
  EXPECT_THAT(error("polygon 1 2 0 9 9 -9 9 -5 1 -9 -9"), HasSubstr(":1:29: corner 4"));
  EXPECT_THAT(error("polygon 1 2 0 -9 -9 -5 1 -9 9 9 9"), HasSubstr(":1:15: corner 1"))
      << "the same, clockwise";
  EXPECT_THAT(error("polygon 1 2 0 200 0 -100 150 -100 -150 heigt 3"), HasSubstr("'heigt' found"));
  EXPECT_THAT(error("polygon 1 2 0 200 0 -100 150 -100 -150 height"), HasSubstr("height"));
}

TEST(Sim, LinesAfterAnObjectSayHowItBehaves) {
  const auto sim = sim_of(
      "Can 1 2 0\nGolf 3 4 0\nmass 0.2\nFriction 0\nrestitution 0.9\nbox 1 2 0 3 4\nfixed\n"
      "Cone 1 2 0\nfriction 0.4\n");
  ASSERT_EQ(sim.objects.size(), 3u);
  EXPECT_EQ(sim.objects[0].matter.friction, std::nullopt);
  EXPECT_EQ(sim.objects[1].matter, (world::Matter{0.2, 0.0, 0.9, false}));
  EXPECT_TRUE(sim.objects[2].matter.fixed);
  EXPECT_TRUE(sim.robots[0].traits.any);
  EXPECT_EQ(sim.robots[0].traits.friction, 0.4);
}

TEST(Sim, ReadsPathsOfObjects) {
  const auto sim = sim_of(
      "Can 100 200 0\npath 150 loop 300 400\nbox 1 2 0 3 4\npath 0.5 BACK 1 2 3 4 1 2\nGolf 5 6 "
      "7\n");
  ASSERT_EQ(sim.objects.size(), 3u);
  EXPECT_EQ(sim.objects[0].path, (world::Path{0.15, true, {{0.3, 0.4}}}));
  EXPECT_EQ(sim.objects[1].path->loop, false);
  EXPECT_EQ(sim.objects[1].path->points.size(), 3u);
  EXPECT_EQ(sim.objects[2].path, std::nullopt);
  ASSERT_EQ(sim.path_places.size(), 3u);
  EXPECT_EQ(sim.path_places[1], (SourceLocation{"s.sim", 4, 1}));
}

TEST(Sim, ARobotMayEnterLater) {
  const auto sim = sim_of("S4 1 2 0 go enters 7\nenters 2.5\ns4 U\nS4 S 90 enters\nENTERS 1e3\n");
  ASSERT_EQ(sim.robots.size(), 3u);
  EXPECT_EQ(sim.robots[0].arguments, (std::vector<std::string>{"enters", "7"}));
  EXPECT_EQ(sim.robots[0].enters, 2.5);
  EXPECT_EQ(sim.robots[0].enters_where, (SourceLocation{"s.sim", 2, 1}));
  EXPECT_EQ(sim.robots[1].enters, std::nullopt);
  EXPECT_EQ(sim.robots[2].program, "enters");
  EXPECT_EQ(sim.robots[2].enters, 1000.0);
}

TEST(Sim, MistakesAboutEntriesAreNamed) {
  const auto error = [](const std::string& text) { return error_of([&] { sim_of(text); }); };
  EXPECT_EQ(error("enters 5"),
            "s.sim:1:1: 'enters' after no robot: expected the line of a robot before it");
  EXPECT_EQ(error("S4 1 2 0\nCan 1 2 0\n enters 5"),
            "s.sim:3:2: 'enters' after no robot: expected the line of a robot before it");
  EXPECT_EQ(error("S4 1 2 0\nenters"),
            "s.sim:2:7: 'enters' with 0 arguments: expected 'enters SECONDS'");
  EXPECT_EQ(error("S4 1 2 0\nenters 0"),
            "s.sim:2:8: the time in seconds is 0: expected 0.001 to 1000000");
  EXPECT_EQ(error("S4 1 2 0\nenters soon"),
            "s.sim:2:8: 'soon' found: expected the time in seconds, a number");
  EXPECT_EQ(error("S4 1 2 0\nenters 5\nenters 6"),
            "s.sim:3:1: a second 'enters' for this robot: expected one");
  EXPECT_EQ(error("S4 1 2 0\nenter 5"), "s.sim:2:1: unknown keyword 'enter': expected 'enters'?");
}

TEST(Sim, MistakesAboutPathsAreNamed) {
  const auto error = [](const std::string& line) {
    return error_of([&] { sim_of("Can 1 2 0\n" + line); });
  };
  const std::string form = "expected 'path MM_PER_SECOND loop|back x1 y1 [x2 y2 ...]'";
  EXPECT_EQ(error("path"), "s.sim:2:5: 'path' with 0 arguments: " + form);
  EXPECT_EQ(error("path 100 loop 1 2 3"), "s.sim:2:20: 'path' with 5 arguments: " + form);
  EXPECT_EQ(error("path 0 loop 1 2"), "s.sim:2:6: the speed is 0: expected 0.1 to 100000");
  EXPECT_EQ(error("path 100 round 1 2"), "s.sim:2:10: 'round' found: expected 'loop' or 'back'");
  EXPECT_EQ(error("path 100 loop 1 2 1 2"),
            "s.sim:2:19: a way-point where the one before it is: expected another place");
}

TEST(Sim, SaysHowThingsMoveByThemselves) {
  using Kind = world::Reaction::Kind;
  const SimFile sim = sim_of(
      "Can 1 2 0\npath 150 loop 300 400 500 600\nspeeds 100 200\nwaits 0 2.5 1\n"
      "acceleration 300\nyields 250\nCan 1 2 0\nfollow 200 1500\nGolf 1 2 0\nFLEE 100\n"
      "box 1 2 0 30 40\nwander 50\nyields 80\n");
  world::Path path{0.15, true, {{0.3, 0.4}, {0.5, 0.6}}};
  path.leg_speeds = {0.1, 0.2};
  path.waits = {0.0, 2.5, 1.0};
  path.acceleration = 0.3;
  EXPECT_EQ(sim.objects.at(0).path, path);
  EXPECT_EQ(sim.path_places.at(0), (SourceLocation{"s.sim", 2, 1}));
  EXPECT_EQ(sim.objects[0].yields_within, 0.25);
  EXPECT_EQ(sim.objects.at(1).reaction, (world::Reaction{Kind::Follow, 0.2, 1.5}));
  EXPECT_EQ(sim.objects.at(2).reaction, (world::Reaction{Kind::Flee, 0.1}));
  EXPECT_EQ(sim.objects.at(3).reaction, (world::Reaction{Kind::Wander, 0.05}));
  EXPECT_EQ(sim.objects[3].yields_within, 0.08);
}

TEST(Sim, MistakesAboutWhatMovesByItselfAreNamed) {
  const auto error = [](const std::string& line) {
    return error_of([&] { sim_of("Can 1 2 0\n" + line); });
  };
  EXPECT_EQ(error("speeds 100"), "s.sim:2:1: 'speeds' without a path: expected 'path' before it");
  EXPECT_EQ(error("path 1 back 3 4\nspeeds 5 6"),
            "s.sim:3:10: 2 numbers for a path of 1 legs: expected no more than that");
  EXPECT_EQ(error("path 1 back 3 4\nwaits -1"),
            "s.sim:3:7: the time in seconds is -1: expected 0 to 1000000");
  EXPECT_EQ(error("path 1 back 3 4\nacceleration 0"),
            "s.sim:3:14: the acceleration is 0: expected 1 to 100000");
  EXPECT_EQ(error("yields 100"),
            "s.sim:2:1: 'yields' of what stands: expected 'path', 'follow', 'flee' or 'wander' "
            "before it");
  EXPECT_EQ(error("path 1 back 3 4\nflee 5"),
            "s.sim:3:1: 'flee' for one on a path: expected one of them");
  EXPECT_EQ(error("wander 5\npath 1 back 3 4"),
            "s.sim:3:1: 'path' for one that moves otherwise: expected one of them");
  EXPECT_EQ(error("wander 5 6"),
            "s.sim:2:10: 'wander' with 2 arguments: expected 'wander "
            "MM_PER_SECOND'");
  EXPECT_EQ(error("follow fast"), "s.sim:2:8: 'fast' found: expected the speed, a number");
}

TEST(Sim, OneObjectIsReadAndWrittenByItself) {
  const std::string text = "Can 100 200 0\nfriction 0.5\nwander 300\n";
  const world::ObjectSpec can = read_object_text(text, "t");
  EXPECT_EQ(can.pose.position(), (Vec2{0.1, 0.2}));
  EXPECT_EQ(read_object_text(write_object_text(can), "t"), can);
  for (const char* wrong : {"", "Can 1 2 0\nCan 3 4 0", "S4 1 2 0", "Can 1 2 0\nworld w.wld"}) {
    EXPECT_THROW(read_object_text(wrong, "t"), ConfigError) << wrong;
  }
}

TEST(Sim, MistakesAboutObjectsAreNamed) {
  const auto error = [](const std::string& text) { return error_of([&] { sim_of(text); }); };
  EXPECT_EQ(error("fixed\n"),
            "s.sim:1:1: 'fixed' before any object: expected the line of an object first");
  EXPECT_EQ(error("Can 1 2 0\nfriction -1"),
            "s.sim:2:10: the coefficient of friction is -1: expected 0 to 100");
  EXPECT_EQ(error("Can 1 2 0\nrestitution 1.5"),
            "s.sim:2:13: the restitution is 1.5: expected 0 to 1");
  EXPECT_EQ(error("Can 1 2 0\nmass 0"),
            "s.sim:2:6: the mass in kilograms is 0: expected 0.001 to 10000");
  EXPECT_EQ(error("Can 1 2 0\nfixed yes"), "s.sim:2:7: 'fixed' with 1 argument: expected 'fixed'");
  EXPECT_EQ(error("box 1 2 0 0 4"), "s.sim:1:11: the length is 0: expected 1 to 10000");
  EXPECT_EQ(error("box 1 2 0 3"),
            "s.sim:1:12: 'box' with 4 arguments: expected 'box x y phi length width [height [red "
            "green blue]]'");
  EXPECT_EQ(error("Can 1 2 0\nfixd"), "s.sim:2:1: unknown keyword 'fixd': expected 'fixed'?");
}

TEST(Sim, EveryMistakeIsNamed) {
  const auto error = [](const std::string& text) { return error_of([&] { sim_of(text); }); };
  EXPECT_EQ(error(""), "s.sim:1:1: nothing in the file: expected 'world FILE' and robots");
  EXPECT_EQ(error("wrold a.wld"), "s.sim:1:1: unknown keyword 'wrold': expected 'world'?");
  EXPECT_EQ(error("world a.wld\nworld b.wld"),
            "s.sim:2:1: a second world: expected one 'world' or 'maze' line");
  EXPECT_EQ(error("S4 1 2"), "s.sim:1:7: line ends: expected phi");
  EXPECT_EQ(error("S4 1 inf 3"), "s.sim:1:6: 'inf' found: expected y, a number");
  EXPECT_EQ(error("marker 1 2 3"),
            "s.sim:1:13: 'marker' with 3 arguments: expected 'marker x y "
            "[red green blue [alpha]]'");
  EXPECT_THAT(error("xyzzy"), testing::HasSubstr("s.sim:1:1: unknown keyword 'xyzzy': expected"));
}

TEST(Sim, WarnsOfUnknownSettings) {
  sim_of("settings VIS FLY");
  ASSERT_EQ(sim_warnings.size(), 1u);
  EXPECT_EQ(sim_warnings[0].where.column, 14);
}

}  // namespace
}  // namespace eyebridge::files
