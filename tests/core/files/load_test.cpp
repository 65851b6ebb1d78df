#include <cmath>
#include <memory>
#include <stdexcept>

#include <gmock/gmock.h>

#include "eyebridge/world/world.hpp"
#include "reading.hpp"

namespace eyebridge::files {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kRoom =
    "floor 2000 2000\n0 0 2000 0\n2000 0 2000 2000\n2000 2000 0 2000\n"
    "0 2000 0 0\n";

std::string load_error(const std::filesystem::path& path, const std::string& robot = "S4") {
  return error_of([&] { load_scenario(path, {.robot = robot}); });
}

TEST(Load, AWorldGetsOneRobotAtItsFirstPosition) {
  const Folder folder;
  const auto path = folder.write("a.wld", std::string(kRoom) + "position 400 500 90\n");
  const auto scenario = load_scenario(path, {.robot = "labbot"});
  ASSERT_EQ(scenario.robots.size(), 1u);
  EXPECT_EQ(scenario.models.at(0).name, "LabBot");
  EXPECT_EQ(scenario.robots[0].pose.position(), (Vec2{0.4, 0.5}));
  EXPECT_EQ(scenario.directory, folder.path());
}

TEST(Load, AWorldWithoutPositionsGetsOneAtTheFreePlaceNearestToTheCentre) {
  const Folder folder;
  const auto free = load_scenario(folder.write("a.wld", kRoom));
  EXPECT_EQ(free.robots.at(0).pose, (Pose{1, 1, 0}));
  const auto blocked =
      load_scenario(folder.write("b.wld", std::string(kRoom) + "1000 900 1000 1100\n"));
  const Pose pose = blocked.robots.at(0).pose;
  EXPECT_NE(pose, (Pose{1, 1, 0}));
  EXPECT_LT(std::abs(pose.x - 1) + std::abs(pose.y - 1), 0.3);
}

TEST(Load, AMazeGetsOneRobotAtItsFirstLetterOnly) {
  const Folder folder;
  const auto scenario = load_scenario(folder.write("m.maz", " ___\n|u s|\n|___|\n"));
  EXPECT_EQ(scenario.robots.size(), 1u);
  EXPECT_EQ(scenario.world.starts.size(), 2u);
  EXPECT_EQ(scenario.robots[0].pose, scenario.world.starts[0].pose);
}

TEST(Load, ARobotInAWallIsAnErrorAtTheLineThatPlacesIt) {
  const Folder folder;
  folder.write("a.wld", kRoom);
  const auto path = folder.write("a.sim", "world a.wld\n  S4 50 1000 0\n");
  EXPECT_EQ(load_error(path), path.string() +
                                  ":2:3: S4 (186 mm across) at (50, 1000) mm stands in the "
                                  "wall from (0, 2000) mm to (0, 0) mm: expected a free "
                                  "place");
}

TEST(Load, RobotsThatEnterLaterComeInTheOrderOfTheirTimes) {
  const Folder folder;
  folder.write("a.wld", kRoom);
  const auto path = folder.write("a.sim",
                                 "world a.wld\nS4 500 500 0 late\nenters 9\nS4 500 500 0 there\n"
                                 "LabBot 500 500 90 early on\nenters 2\nS4 900 500 0\nenters 2\n"
                                 "error robot:3 psd:1 bias=5\n");
  const auto scenario = load_scenario(path);
  ASSERT_EQ(scenario.robots.size(), 1u);
  EXPECT_EQ(scenario.robots[0].program, "there");
  ASSERT_EQ(scenario.newcomers.size(), 3u);
  const Newcomer& first = scenario.newcomers[0];
  EXPECT_EQ(first.time, 2.0);
  EXPECT_EQ(scenario.models.at(first.robot.model).name, "LabBot");
  EXPECT_EQ(first.robot.pose.position(), (Vec2{0.5, 0.5}));
  EXPECT_EQ(first.robot.program, "early");
  EXPECT_EQ(first.robot.arguments, std::vector<std::string>{"on"});
  EXPECT_EQ(first.where, (SourceLocation{path.string(), 5, 1}));
  EXPECT_EQ(scenario.newcomers[1].robot.pose.x, 0.9);
  EXPECT_EQ(scenario.newcomers[2].time, 9.0);
  // The third by number is the second one that enters.
  const auto bias = [&](const RobotPlacement& robot) {
    return scenario.models.at(robot.model).range_sensors.at(0).error.bias;
  };
  EXPECT_EQ(bias(scenario.newcomers[1].robot), 0.005);
  EXPECT_EQ(bias(scenario.newcomers[2].robot), 0.0);
}

TEST(Load, MistakesAboutRobotsThatEnterLaterAreNamed) {
  const Folder folder;
  folder.write("a.wld", kRoom);
  folder.write("o.esObj", "obj cone.obj\nscale 10\ncollider capsule 0 10 0 5 20 y\n");
  const auto error = [&](const std::string& lines) {
    const auto path = folder.write("a.sim", "world a.wld\n" + lines);
    return load_error(path).substr(path.string().size() + 1);
  };
  EXPECT_EQ(error("S4 500 500 0\nS4 50 1000 0\nenters 1"),
            "3:1: S4 (186 mm across) at (50, 1000) mm stands in the wall from (0, 2000) mm to "
            "(0, 0) mm: expected a free place");
  EXPECT_EQ(error("S4 500 500 0\nenters 1"),
            "2:1: all robots enter later: expected one that is there from the start");
  EXPECT_EQ(error("S4 500 500 0\nrobi robots/S4.robi p.dll\nenters 1"),
            "3:1: a robot without a place enters later: expected x y phi");
  EXPECT_THAT(error("object o.esObj\nS4 500 500 0\no 900 900 0\nenters 1"),
              HasSubstr("5:1: an object stands before this: expected the line of a robot"));
}

TEST(Load, AStartInAWallIsAnErrorAtItsLineOrLetter) {
  const Folder folder;
  const auto world = folder.write("a.wld", std::string(kRoom) + " position 50 1000 0\n");
  EXPECT_THAT(load_error(world),
              HasSubstr(world.string() + ":6:2: S4 (186 mm across) at (50, 1000)"));
  folder.write("p.p", "diameter 200\nworld a.wld\n");
  EXPECT_THAT(load_error(folder.path() / "p.p"), HasSubstr("a.wld:6:2: "));
  const auto maze = folder.write("m.maz", " _\n|S|\n100\n");
  EXPECT_THAT(load_error(maze), HasSubstr(maze.string() + ":2:2: S4 (186 mm across) at (50, 50)"));
}

TEST(Load, ARobotTooBigForAMazeIsToldWhichOneFits) {
  const Folder folder;
  constexpr const char* kHint = "; a smaller robot fits: --robot Mouse";
  EXPECT_THAT(load_error(folder.write("m.maz", " _\n|S|\n100\n")), EndsWith(kHint));
  EXPECT_THAT(load_error(folder.write("n.maz", " _\n|_|\n100\n")), EndsWith(kHint));
  EXPECT_EQ(load_error(folder.path() / "m.maz", "Mouse"), "no error");
  EXPECT_THAT(load_error(folder.write("tiny.maz", " _\n|S|\n30\n")), Not(HasSubstr("Mouse")));
  EXPECT_THAT(load_error(folder.write("a.wld", "floor 100 100\n0 0 100 100\n")),
              Not(HasSubstr("--robot")));
}

TEST(Load, ARobotIsFreeWhereTheWorldTakesIt) {
  const Folder folder;
  // Two S4 whose rims meet at x = 500 mm, or overlap by a millionth of a millimetre.
  folder.write("a.wld", kRoom);
  const auto meet = folder.write("a.sim", "world a.wld\nS4 407 500 0\nS4 593 500 0\n");
  const auto overlap = folder.write("b.sim", "world a.wld\nS4 407 500 0\nS4 592.999999 500 0\n");
  for (const auto& path : {meet, overlap}) {
    std::string in_files = "taken";
    std::string in_world = "taken";
    try {
      load_scenario(path);
    } catch (const ConfigError&) {
      in_files = "refused";
    }
    const auto sim = load_scenario(folder.path() / "a.wld");
    world::World world(std::make_shared<const world::WorldModel>(sim.world));
    try {
      world.add_robot({0.407, 0.5, 0}, 0.093, 0.1, {});
      world.add_robot({path == meet ? 0.593 : 0.592999999, 0.5, 0}, 0.093, 0.1, {});
    } catch (const std::invalid_argument&) {
      in_world = "refused";
    }
    EXPECT_EQ(in_files, in_world) << path;
  }
}

TEST(Load, AFloorTextureLiesBesideItsWorld) {
  const Folder folder;
  folder.write("worlds/tiles.png", "picture");
  folder.write("worlds/a.wld", std::string(kRoom) + "floor_texture tiles.png\n");
  folder.write("worlds/b.wld", std::string(kRoom) + "floor_texture none.png\n");
  const auto found = load_scenario(folder.write("a.sim", "world worlds/a.wld\n"));
  EXPECT_EQ(found.world.floor_texture, (folder.path() / "worlds/tiles.png").string());
  const auto missing = load_scenario(folder.write("b.sim", "world worlds/b.wld\n"));
  EXPECT_EQ(missing.world.floor_texture, "none.png");
}

TEST(Load, ARobotInAnotherOneOrInACanIsAnError) {
  const Folder folder;
  folder.write("a.wld", kRoom);
  EXPECT_THAT(load_error(folder.write("a.sim", "world a.wld\nS4 500 500 0\nS4 600 500 0\n")),
              HasSubstr("a.sim:3:1: S4 (186 mm across) at (600, 500) mm stands in the S4 at"));
  EXPECT_THAT(load_error(folder.write("b.sim", "world a.wld\nS4 500 500 0\nCan 600 500 0\n")),
              HasSubstr("b.sim:2:1: S4 (186 mm across) at (500, 500) mm stands in the can at"));
}

TEST(Load, ASimTakesLettersFromItsMaze) {
  const Folder folder;
  folder.write("m.maz", " _____\n|u r S|\n|_____|\n");
  folder.write("b.robi", "name B\ndiameter 100\n");
  const auto scenario =
      load_scenario(folder.write("a.sim",
                                 "world m.maz\nS4 U 0 one.x\nS4 s two.x\n"
                                 "robi b.robi three.x\nsettings VIS\nmarker 1 2\n"));
  ASSERT_EQ(scenario.robots.size(), 3u);
  EXPECT_EQ(scenario.robots[0].pose, (Pose{0.18, 0.54, 0}));
  EXPECT_EQ(scenario.robots[1].pose, scenario.world.starts[2].pose);
  EXPECT_EQ(scenario.robots[2].pose, scenario.world.starts[1].pose);
  EXPECT_EQ(scenario.models[scenario.robots[2].model].name, "B");
  EXPECT_EQ(scenario.models[scenario.robots[0].model].name, "S4");
  EXPECT_EQ(scenario.robots[1].program, "two.x");
  EXPECT_TRUE(scenario.show_sensors);
  EXPECT_EQ(scenario.world.markers.size(), 1u);
}

TEST(Load, CustomObjectsArePlacedLikeRobots) {
  const Folder folder;
  folder.write("cone.esObj", "obj cone.obj\nscale 10\ncollider capsule 0 10 0 5 20 y\n");
  folder.write("a.wld", kRoom);
  const auto scenario = load_scenario(
      folder.write("a.sim", "world a.wld\nobject cone.esObj\nS4 500 500 0\nCone 1500 1500 0\n"));
  ASSERT_EQ(scenario.world.objects.size(), 1u);
  EXPECT_EQ(scenario.world.objects[0].name, "cone");
  EXPECT_EQ(scenario.world.objects[0].kind, world::ObjectKind::Can);
  EXPECT_DOUBLE_EQ(scenario.world.objects[0].radius, 0.05);
  EXPECT_DOUBLE_EQ(scenario.world.objects[0].height, 0.2);
  EXPECT_EQ(scenario.robots.size(), 1u);
}

TEST(Load, AnObjectOfOneBoxIsABoxAndBehavesAsItsFileAndItsLinesSay) {
  const Folder folder;
  folder.write("bin.esObj",
               "obj bin.obj\nmass 2 0 0 0\nfriction 0.3\nfixed\n"
               "collider box 0 100 0 300 200 500\n");
  folder.write("a.wld", kRoom);
  const auto scenario = load_scenario(folder.write(
      "a.sim", "world a.wld\nobject bin.esObj\nS4 500 500 0\nBin 1500 1500 90\nfriction 0.7\n"));
  ASSERT_EQ(scenario.world.objects.size(), 1u);
  const world::ObjectSpec& bin = scenario.world.objects[0];
  EXPECT_EQ(bin.kind, world::ObjectKind::Box);
  EXPECT_DOUBLE_EQ(bin.size.x, 0.5) << "z is ahead";
  EXPECT_DOUBLE_EQ(bin.size.y, 0.3);
  EXPECT_EQ(bin.matter, (world::Matter{2.0, 0.7, std::nullopt, true}));
}

TEST(Load, AnObjectsFileMaySayHowItMovesAndTheScenarioOtherwise) {
  const Folder folder;
  folder.write("pet.esObj",
               "obj pet.obj\ncollider capsule 0 100 0 50 20 y\nfollow 100 500\nyields 50\n");
  const auto scenario = load_scenario(folder.write("a.sim",
                                                   "world empty-room.wld\nobject pet.esObj\n"
                                                   "S4 500 500 0\nPet 1500 1500 0\n"
                                                   "Pet 500 1500 0\npath 100 back 1000 1500\n"));
  ASSERT_EQ(scenario.world.objects.size(), 2u);
  const world::ObjectSpec& pet = scenario.world.objects[0];
  ASSERT_TRUE(pet.reaction);
  EXPECT_DOUBLE_EQ(pet.reaction->range, 0.5);
  EXPECT_DOUBLE_EQ(pet.yields_within, 0.05);
  EXPECT_FALSE(scenario.world.objects[1].reaction);
  EXPECT_TRUE(scenario.world.objects[1].path);
  EXPECT_NO_THROW(world::World(std::make_shared<const world::WorldModel>(scenario.world)));
}

TEST(Load, APathMustBeFreeOfWalls) {
  const Folder folder;
  const std::string room = "world empty-room.wld\nS4 1800 1800 0\n";
  const auto error = [&](const std::string& lines) {
    return load_error(folder.write("a.sim", room + lines));
  };
  EXPECT_THAT(error("Can 500 500 0\npath 100 loop 500 1000 -500 1000\n"),
              HasSubstr("a.sim:4:1: the path leads the can into the wall from (0, "));
  EXPECT_THAT(error("box 500 500 45 200 100\npath 100 back 95 500\n"),
              HasSubstr("the path leads the box into the wall"));
  EXPECT_THAT(error("Can 500 500 0\npath 100 loop 500 500\n"),
              HasSubstr("a.sim:4:1: the only way-point is where the can stands"));
  const auto good = load_scenario(folder.write(
      "b.sim", room + "box 500 500 0 200 100\npath 100 back 110 500\nCan 900 900 0\n"));
  EXPECT_TRUE(good.world.objects[0].path);
}

TEST(Load, WhatIsSaidOfObjectsIsNotSaidOfRobots) {
  const Folder folder;
  EXPECT_THAT(load_error(folder.write("a.sim", "world empty-room.wld\nS4 500 500 0\nmass 0.3\n")),
              HasSubstr("a.sim:3:1: a robot stands before this: expected the line of an object"));
}

TEST(Load, AFrictionIsOneRobotsOwn) {
  const Folder folder;
  const auto scenario = load_scenario(folder.write(
      "a.sim", "world empty-room.wld\nS4 500 500 0\nS4 900 500 0\nfriction 0.7\nS4 900 900 0\n"));
  const auto friction = [&](std::size_t robot) {
    return scenario.models[scenario.robots[robot].model].contact_friction;
  };
  EXPECT_EQ(friction(0), 0.3);
  EXPECT_EQ(friction(1), 0.7);
  EXPECT_EQ(friction(2), 0.3);
}

TEST(Load, ARobotBesideABoxStandsFreeAndOneInItDoesNot) {
  const Folder folder;
  const std::string room = "world empty-room.wld\nbox 1000 1000 0 400 100\n";
  EXPECT_EQ(load_scenario(folder.write("a.sim", room + "S4 1000 850 0\n")).robots.size(), 1u);
  EXPECT_THAT(load_error(folder.write("b.sim", room + "S4 1000 900 0\n")),
              HasSubstr("stands in the box at (1000, 1000) mm"));
}

TEST(Load, FilesAreSearchedBesideInTheHomeAndAmongOurWorlds) {
  const Folder folder;
  folder.write("sim/worlds/room.wld", kRoom);
  const auto path = folder.write("a.sim", "world %SIM%\\worlds\\room.wld\nS4 500 500 0\n");
  EXPECT_THAT(load_error(path),
              HasSubstr("a.sim:1:7: '%SIM%\\worlds\\room.wld' found, but EYESIM_HOME"));
  SearchPlaces places;
  places.eyesim_home = folder.path() / "sim";
  EXPECT_EQ(load_scenario(path, {.places = places}).world.walls.size(), 4u);
  const auto relative = folder.write("b.sim", "world worlds/room.wld\n");
  EXPECT_EQ(load_scenario(relative, {.places = places}).robots.size(), 1u);
  EXPECT_EQ(load_scenario(folder.write("c.sim", "world empty-room.wld\n")).robots.size(), 1u);
}

TEST(Load, AnObjectIsDrawnInAnEmptyRoom) {
  const Folder folder;
  const Scenario scenario =
      load_scenario(folder.write("sign.esObj", "collider box 80 300 80 0 0 0\n"));
  ASSERT_EQ(scenario.world.objects.size(), 1u);
  EXPECT_EQ(scenario.world.objects[0].name, "sign");
  EXPECT_EQ(scenario.robots.size(), 1u);
  EXPECT_EQ(scenario.world.width, 2.0);
}

TEST(Load, MissingFilesAndNamesAreErrorsAtTheirLine) {
  const Folder folder;
  EXPECT_THAT(load_error(folder.write("a.sim", "world C:\\no\\such.wld\n")),
              HasSubstr("a.sim:1:7: no file 'C:\\no\\such.wld': expected a path"));
  EXPECT_THAT(load_error(folder.write("b.sim", "world empty-room.wld\nrobot no.robi\n")),
              HasSubstr("b.sim:2:7: no file 'no.robi'"));
  EXPECT_THAT(
      load_error(folder.write("c.sim", "S5 1 2 3\n")),
      HasSubstr(
          "c.sim:1:1: no robot or object 'S5': expected S4, S4-2015, LabBot, Mouse, Car, Omni, "
          "ServoBot, ServoBot-11, Mako or USAL"));
  EXPECT_THAT(load_error(folder.write("d.sim", "world maze-5.maz\nS4 L\n")),
              HasSubstr("d.sim:2:1: no start 'L' left"));
  EXPECT_EQ(load_error(folder.path() / "none.wld"),
            "world: no file '" + (folder.path() / "none.wld").string() +
                "': expected a path, or a name that eyebridge world list shows; looked in " +
                folder.path().string());
  EXPECT_THAT(load_error(folder.write("e.txt", "x")), HasSubstr("unknown kind of file"));
  EXPECT_EQ(load_error(folder.write("f.wld", kRoom), "R2D2"),
            "default robot: no robot 'R2D2': expected S4, S4-2015, LabBot, Mouse, Car, Omni, "
            "ServoBot, ServoBot-11, Mako or USAL");
  EXPECT_EQ(error_of([&] {
              load_scenario(folder.path() / "f.wld", {.robot = "R2D2", .robot_where = {"--robot"}});
            }),
            "--robot: no robot 'R2D2': expected S4, S4-2015, LabBot, Mouse, Car, Omni, "
            "ServoBot, ServoBot-11, Mako or USAL");
  EXPECT_THAT(load_error(folder.write("g.p", "diameter 100\n maze no.maz\n")),
              HasSubstr("g.p:2:7: no file 'no.maz'"));
}

TEST(Load, AParameterFileNamesItsWorldAndPauses) {
  const Folder folder;
  folder.write("a.wld", kRoom);
  const auto scenario =
      load_scenario(folder.write("eyesim.p", "name P\ndiameter 150\nworld a.wld\npause on\n"));
  EXPECT_TRUE(scenario.start_paused);
  EXPECT_EQ(scenario.models.at(0).name, "P");
  EXPECT_EQ(scenario.world.walls.size(), 4u);
}

TEST(Load, ARobotFileStandsInAnEmptyRoom) {
  const Folder folder;
  const auto scenario = load_scenario(folder.write("r.robi", "name R\ndiameter 100\n"));
  EXPECT_EQ(scenario.models.at(0).name, "R");
  EXPECT_EQ(scenario.world.width, 2.0);
}

TEST(Load, TheDefaultIsAnS4InTheMiddleOfAnEmptyRoom) {
  const auto scenario = default_scenario();
  EXPECT_EQ(scenario.world.walls.size(), 4u);
  EXPECT_EQ(scenario.models.at(0).name, "S4");
  EXPECT_EQ(scenario.robots.at(0).pose.position(), (Vec2{1, 1}));
  EXPECT_TRUE(scenario.warnings.empty());
}

TEST(Load, BuiltinRobotsHaveTheirPublishedMeasures) {
  const auto* s4 = builtin_robot("s4");
  ASSERT_NE(s4, nullptr);
  EXPECT_EQ(s4->diameter, 0.186);
  EXPECT_EQ(s4->drive.wheel_base, 0.09);
  EXPECT_EQ(s4->range_sensors.size(), 8u);
  EXPECT_TRUE(s4->camera);
  ASSERT_NE(builtin_robot("LABBOT"), nullptr);
  EXPECT_EQ(builtin_robot("LABBOT")->drive.wheel_base, 0.14);
  EXPECT_EQ(builtin_robot("nobody"), nullptr);
}

}  // namespace
}  // namespace eyebridge::files
