// What read_sim() takes, write_sim() can say.
#include <gmock/gmock.h>

#include "reading.hpp"

namespace eyebridge::files {
namespace {

using ::testing::HasSubstr;

SimFile simulation_of(const std::string& text) {
  std::vector<Warning> warnings;
  return read_sim(text, "s.sim", warnings);
}

void expect_round_trip(const std::string& text) {
  const SimFile first = simulation_of(text);
  const std::string written = write_sim(first);
  EXPECT_TRUE(same_meaning(simulation_of(written), first)) << text << "became\n" << written;
  EXPECT_EQ(write_sim(simulation_of(written)), written);
}

TEST(SimWriter, WritesEveryKindOfLine) {
  expect_round_trip(
      "maze \"a b.maz\"\nwater 2500.5\nrobi x.robi\nobject p.esObj\nsettings trace VIS\n"
      "LabBot 400.25 500 90 go.x a 'b c' \"\"\nS4 S 100 p.py\nS4 u\nenters 12.5\n"
      "Golf 1 2 3\nmass 0.1\nfriction 0.35\nCan 3 4 5\nrestitution 0\nfixed\n"
      "box 1 2 30 300 200\nbox 1 2 30 300 200 150 1 2 3\nmass 2.5\n"
      "path 120 back 2500 1020 1 1\nbarrel 1 2 3\npath 5 loop 1 1\nmass 7\n"
      "marker 9 10\nmarker 9 10 1 2 3 255\n");
}

TEST(SimWriter, WritesHowThingsMoveByThemselves) {
  expect_round_trip(
      "object dog.esObj\nCan 1 2 0\npath 120.7 loop 2500 1020 1 1\nspeeds 33.3 0.1 700\n"
      "waits 0 1.7 0.1\nacceleration 333.3\nyields 123.4\nCan 1 2 0\nfollow 200\n"
      "box 1 2 30 300 200\nflee 100.1 700.7\nyields 5\nGolf 1 2 3\nwander 33.3\n"
      "dog 1 2 3\npath 5 back 1 1\nwaits 4\ndog 5 6 7\nwander 100\nyields 20\n"
      "dog 1 2 3\nloose\nstill\ndog 1 2 3\nwander 5\nyields 0\n");
}

TEST(SimWriter, WritesPolygons) {
  expect_round_trip(
      "polygon 1 2 30 200 0 -100 150.7 -100 -150\nmass 2\n"
      "polygon 1 2 3 9 9 -9 9 -9 -9 9 -9 colour 1 2 3 height 33.3\nwander 20\n"
      "robi polygon prog 1 2 3\npolygon 1 2 3\n");
  SimFile sim;
  sim.objects.emplace_back().kind = world::ObjectKind::Polygon;
  sim.objects.back().corners = {{0.1, 0}, {0, 0.1}};
  EXPECT_THAT(error_of([&] { write_sim(sim); }), HasSubstr("three corners or more"));
}

TEST(SimWriter, WritesTheErrorsOfRobots) {
  expect_round_trip(
      "S4 1 2 3\nerror realistic\nerror robot:2 harsh\nerror psd:2 4 1 dropout=5.3% quantised\n"
      "error wheels -1 0.7%\nerror camera exposure=-0.3 sigma=3.3\nerror compass 1.1\n"
      "error radio range=2.5 delay=33.3ms\nerror encoder quantised\n");
}

TEST(SimWriter, WritesTheOldFormWhereNoOtherSaysIt) {
  expect_round_trip("robi a/S4.robi drive.dll 600 500 0\nrobi a/S4.robi maze.dll\n");
  expect_round_trip("robi b\nrobi a\nrobi c prog\nrobi a ''\nrobi b x 1 2 3\nrobi d\n");
  expect_round_trip("robi mass prog 1 2 3\nfixed\nrobi 5 p 1 2 3\n");
  expect_round_trip("robi box prog 1 2 3\nbox 1 2 3\nbox 1 2 3\nmass 2\n");
  expect_round_trip("object 800 700 0 0.0 %sim%/objects/barrel/Big.Barrel.ms3d\n");
  expect_round_trip("object 800 700 0 0.0 box.ms3d\nobject 800 700 0 0.0 soccer.ms3d\n");
}

TEST(SimWriter, WritesWhatIsHardlyAnything) {
  expect_round_trip("settings\n");
  expect_round_trip("world w.wld\n");
  expect_round_trip("\n\xEF\xBB\xBFname 1 2 3\n");
  expect_round_trip("\"\" 0 0 0\n5 1 2 3\n'a b' 1 2 3 ' '\n");
}

TEST(SimWriter, KeepsNumbersToTheBit) {
  expect_round_trip("S4 0.1 33.333333333333336 12.3456789\nS4 1e-9 -7 2.5rad\n");
  expect_round_trip("S4 r 1100 prog\nS4 s -35999.3\nS4 u 33.333333333333336 x\nS4 d -0\n");
  for (int i = 1; i < 200; ++i) {
    expect_round_trip("S4 1 2 3\nerror psd " + std::to_string(i * 0.37) + " " +
                      std::to_string(i * 0.13) + "\n");
  }
}

TEST(SimWriter, RefusesWhatNoLineCanSay) {
  SimFile sim = simulation_of("Golf 1 2 3\n");
  sim.objects[0].radius = 0.5;
  EXPECT_THAT(error_of([&] { write_sim(sim); }), HasSubstr("cannot say all of it"));
  sim = simulation_of("robi a.robi prog\n");
  sim.robot_files.clear();
  EXPECT_THAT(error_of([&] { write_sim(sim); }), HasSubstr("no place of its own"));
  sim = simulation_of("S4 1 2 3 prog\n");
  sim.robots[0].program = "a \"b\" 'c'";
  EXPECT_THAT(error_of([&] { write_sim(sim); }), HasSubstr("cannot be quoted"));
}

TEST(SimWriter, OwnSimulationsSurvive) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(own_worlds())) {
    if (entry.path().extension() != ".sim") continue;
    expect_round_trip(read_text_file(entry.path()));
    ++count;
  }
  EXPECT_GE(count, 9);
}

}  // namespace
}  // namespace eyebridge::files
