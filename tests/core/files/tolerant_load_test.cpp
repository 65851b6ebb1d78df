#include <gmock/gmock.h>

#include "reading.hpp"

// Reading::Tolerant: what a line breaks is a warning.

namespace eyebridge::files {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kFourWalls =
    "floor 2000 2000\n0 0 2000 0\n2000 0 2000 2000\n2000 2000 0 2000\n0 2000 0 0\n";

Scenario load_tolerant(const std::filesystem::path& path,
                       const SearchPlaces& places = SearchPlaces::of_process()) {
  return load_scenario(path, {.places = places, .reading = Reading::Tolerant});
}

std::string warnings_of(const Scenario& scenario) {
  std::string all;
  for (const Warning& warning : scenario.warnings) all += warning.str() + "\n";
  return all;
}

TEST(TolerantLoad, WhatALineOfAWorldBreaksIsAWarning) {
  const Folder folder;
  const auto path = folder.write("a.wld",
                                 "floor 2000 2000\n0 0 2000 0\nush 0 0 0\n0 0 x 0\n\"open\n"
                                 "2000 0 2000 2000\n");
  EXPECT_THAT(error_of([&] { load_scenario(path); }),
              HasSubstr("a.wld:3:1: unknown keyword 'ush'"));
  const Scenario scenario = load_tolerant(path);
  EXPECT_EQ(scenario.world.walls.size(), 2u);
  EXPECT_EQ(scenario.robots.size(), 1u);
  EXPECT_THAT(
      warnings_of(scenario),
      AllOf(HasSubstr("a.wld:3:1: warning: unknown keyword 'ush': expected 'push'?; the line "
                      "is left out"),
            HasSubstr("a.wld:4:5: "), HasSubstr("a.wld:5:1: ")));
}

// Two million walls took half a minute, and all beyond the first 500,000 were left out.
TEST(TolerantLoad, AFileOfWhichNoLineCanBeUsedIsRefusedInTime) {
  const Folder folder;
  std::string text = kFourWalls;
  for (int i = 0; i < 10'000; ++i) text += "wall\n";
  EXPECT_EQ(load_tolerant(folder.write("most.wld", text)).world.walls.size(), 4u);
  const auto path = folder.write("more.wld", text + "wall\n");
  EXPECT_THAT(error_of([&] { load_tolerant(path); }),
              AllOf(HasSubstr("more.wld:10006:1: unknown keyword 'wall'"),
                    HasSubstr("; 10000 lines before it cannot be used either")));
}

TEST(TolerantLoad, WhatALineOfASimBreaksIsAWarning) {
  const Folder folder;
  folder.write("room.wld", kFourWalls);
  const auto path = folder.write("a.sim",
                                 "world room.wld\nrobot no.robi\nobject signs/stop.esObj\n"
                                 "stop 300 300 90\nNobody 1 2 3\nmass 1\nS4 500 500 0\nmass 1\n"
                                 "S4 700 500 0\nerror robot:9 psd sigma=5\n");
  const Scenario scenario = load_tolerant(path);
  EXPECT_EQ(scenario.robots.size(), 2u) << warnings_of(scenario);
  ASSERT_EQ(scenario.world.objects.size(), 1u);
  EXPECT_EQ(scenario.world.objects[0].name, "stop");
  EXPECT_EQ(scenario.world.objects[0].size, (Vec2{0.1, 0.1}));
  EXPECT_TRUE(scenario.world.objects[0].matter.fixed);
  EXPECT_THAT(
      warnings_of(scenario),
      AllOf(HasSubstr("a.sim:2:7: warning: no file 'no.robi'"),
            HasSubstr("'stop' is a box of 100 mm instead"),
            HasSubstr("a.sim:5:1: warning: no robot or object 'Nobody'"),
            HasSubstr("a.sim:6:1: warning: a robot stands before this"),
            HasSubstr("a.sim:8:1: warning: a robot stands before this"), HasSubstr("a.sim:10:")));
}

TEST(TolerantLoad, ARobotInTheWayIsPutToTheNearestFreePlace) {
  const Folder folder;
  const auto path = folder.write("a.sim",
                                 "world empty-room.wld\nS4 1000 1000 0\nS4 1100 1000 30\n"
                                 "S4 50 1000 0\n");
  EXPECT_THAT(error_of([&] { load_scenario(path); }),
              HasSubstr("stands in the S4 at (1000, 1000) mm"));
  const Scenario scenario = load_tolerant(path);
  ASSERT_EQ(scenario.robots.size(), 3u);
  EXPECT_NEAR(scenario.robots[1].pose.x, 1.19, 1e-9);
  EXPECT_NEAR(scenario.robots[1].pose.y, 1.0, 1e-9);
  EXPECT_NEAR(scenario.robots[1].pose.theta, deg_to_rad(30), 1e-9);
  EXPECT_NEAR(scenario.robots[2].pose.x, 0.1, 1e-9);
  EXPECT_THAT(warnings_of(scenario),
              AllOf(HasSubstr("stands in the S4 at (1000, 1000) mm: it is put to (1190, 1000) mm"),
                    HasSubstr("it is put to (100, 1000) mm")));
}

TEST(TolerantLoad, ASensorOfABrokenLineIsNotThere) {
  std::vector<Warning> warnings;
  const auto robot =
      read_robi("diameter 100\npsd A 0 1 2 3 4\nir B x 1 2 3 4\nbump C 0 1 2\npsd D 7 1 2 3 4\n",
                "a.robi", warnings, Reading::Tolerant);
  ASSERT_EQ(robot.range_sensors.size(), 1u);
  EXPECT_EQ(robot.range_sensors[0].name, "D");
  EXPECT_EQ(robot.range_sensors[0].id, 7);
  EXPECT_TRUE(robot.proximity_sensors.empty());
  EXPECT_TRUE(robot.bumpers.empty());
  EXPECT_EQ(warnings.size(), 3u);
}

TEST(TolerantLoad, AWorldThatIsNotThereIsAnErrorStill) {
  const Folder folder;
  EXPECT_THROW(load_tolerant(folder.write("a.sim", "world no.wld\nS4 500 500 0\n")), ConfigError);
  EXPECT_THROW(load_tolerant(folder.write("b.wld", "garbage\n")), ConfigError);
}

TEST(TolerantLoad, AFileOfAnotherComputerIsLookedForByItsLastName) {
  const Folder folder;
  folder.write("sim/worlds/small/room.wld", kFourWalls);
  folder.write("beside.wld", kFourWalls);
  SearchPlaces places;
  places.eyesim_home = folder.path() / "sim";
  for (const char* written : {"C:\\Users\\anna\\beside.wld", "/Users/anna/EyeSim/beside.wld",
                              "%sim%/worlds/beside.wld", "../elsewhere/beside.wld"}) {
    const auto path = folder.write("a.sim", std::string("world ") + written + "\nS4 500 500 0\n");
    const Scenario scenario = load_tolerant(path, places);
    EXPECT_EQ(scenario.world.walls.size(), 4u) << written;
    EXPECT_THROW(load_scenario(path, {.places = places}), ConfigError) << written;
    ASSERT_EQ(scenario.warnings.size(), 1u);
    EXPECT_THAT(scenario.warnings[0].str(), AllOf(HasSubstr("a.sim:1:7: warning: no file '" +
                                                            std::string(written) + "' here: "),
                                                  HasSubstr("beside.wld' is read instead")));
  }
  const auto home = folder.write("b.sim", "world /Applications/room.wld\nS4 500 500 0\n");
  EXPECT_THAT(load_tolerant(home, places).warnings.at(0).str(),
              HasSubstr("sim/worlds/small/room.wld' is read instead"));
}

}  // namespace
}  // namespace eyebridge::files
