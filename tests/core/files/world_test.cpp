#include <gmock/gmock.h>

#include "eyebridge/base/units.hpp"
#include "reading.hpp"

namespace eyebridge::files {
namespace {

world::WorldModel world_of(const std::string& text) {
  std::vector<Warning> warnings;
  return read_world(text, "w.wld", warnings);
}

std::vector<Warning> warnings_of(const std::string& text) {
  std::vector<Warning> warnings;
  read_world(text, "w.wld", warnings);
  return warnings;
}

std::string world_error(const std::string& text) {
  return error_of([&] { world_of(text); });
}

TEST(World, ReadsBothWaysToGiveTheSize) {
  EXPECT_EQ(world_of("floor 3000 2000").width, 3.0);
  EXPECT_EQ(world_of("width 3000 ;BIGW\nheight 2000").height, 2.0);
}

TEST(World, ReadsWallsOfFourSixAndNineNumbers) {
  const auto world = world_of("floor 9 9\n1 2 3 4\n1 2 3 4 18 100\n1 2 3 4 18 100 255 128 0\n");
  ASSERT_EQ(world.walls.size(), 3u);
  EXPECT_EQ(world.walls[0].b, (Vec2{0.003, 0.004}));
  EXPECT_EQ(world.walls[0].thickness, 0.01);  // EyeSim's, where the line says none
  EXPECT_EQ(world.walls[0].height, world::Wall::kDefaultHeight);
  EXPECT_EQ(world.walls[1].thickness, 0.018);
  EXPECT_EQ(world.walls[1].colour, world::Wall::kDefaultColour);
  EXPECT_EQ(world.walls[2].height, 0.1);
  EXPECT_EQ(world.walls[2].colour, (Rgb{255, 128, 0}));
}

TEST(World, NestsPushedFrames) {
  const auto world = world_of(
      "floor 3000 3000\npush 1000 1000 90\npush 100 0 90\n0 0 50 0\npop\n"
      "position 100 0 0\npop\n0 0 10 0\n");
  ASSERT_EQ(world.walls.size(), 2u);
  EXPECT_NEAR(world.walls[0].a.x, 1.0, 1e-12);
  EXPECT_NEAR(world.walls[0].a.y, 1.1, 1e-12);
  EXPECT_NEAR(world.walls[0].b.x, 0.95, 1e-12);
  EXPECT_NEAR(world.walls[0].b.y, 1.1, 1e-12);
  EXPECT_EQ(world.walls[1].b, (Vec2{0.01, 0}));
  ASSERT_EQ(world.starts.size(), 1u);
  EXPECT_NEAR(world.starts[0].pose.y, 1.1, 1e-12);
  EXPECT_NEAR(world.starts[0].pose.theta, kPi / 2, 1e-12);
  EXPECT_EQ(world.starts[0].letter, 0);
}

TEST(World, TellsWhereItsStartsStand) {
  std::vector<Warning> warnings;
  std::vector<SourceLocation> places;
  read_world("floor 9 9\nposition 1 1 0\n  position 2 2 0\n", "w.wld", warnings, &places);
  EXPECT_EQ(places, (std::vector<SourceLocation>{{"w.wld", 2, 1}, {"w.wld", 3, 3}}));
}

TEST(World, KeepsAFloorTextureWithBlanks) {
  EXPECT_EQ(world_of("floor_texture \"my floor.png\"\nfloor 9 9").floor_texture, "my floor.png");
}

TEST(World, ToleratesLineEndsAndCommentsOfAnyKind) {
  EXPECT_EQ(world_of("\xEF\xBB\xBF# \xE4 \xC3\xA4\r\nfloor 9 9\r\n0 0 0 4;wall\r\n0 0 4 0 # x")
                .walls.size(),
            2u);
}

TEST(World, WarnsOfAPushThatIsNeverPopped) {
  const auto warnings = warnings_of("floor 9 9\n  push 1 1 0\n");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].str(), "w.wld:2:3: warning: 1 'push' without 'pop' at the end of the file");
}

TEST(World, WithoutASizeTheFloorReachesToTheWalls) {
  const std::string text = "0 0 3000 0\n3000 0 3000 1500\n";
  EXPECT_EQ(world_of(text).width, 3.0);
  EXPECT_EQ(world_of(text).height, 1.5);
  ASSERT_EQ(warnings_of(text).size(), 1u);
  EXPECT_THAT(warnings_of(text)[0].text, testing::HasSubstr("no size is given"));
}

TEST(World, NegativeWallsWithoutASizeAreAnError) {
  EXPECT_THAT(world_error("0 0 3000 0\n0 0 0 -720\n"),
              testing::HasSubstr("w.wld:1:1: no size is given and the walls lie at negative"));
}

TEST(World, WarnsOfWallsOutsideTheFloor) {
  const auto warnings = warnings_of("floor 10 10\n0 0 5 5\n0 0 11 0\n");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].where.line, 3);
}

TEST(World, EveryMistakeIsNamedWithItsPlace) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "w.wld:1:1: nothing in the file: expected a world ('floor W H', then walls)"},
      {"# only a comment\n",
       "w.wld:1:1: nothing in the file: expected a world ('floor W H', then "
       "walls)"},
      {"floor 9 9\nush 5 0 0", "w.wld:2:1: unknown keyword 'ush': expected 'push'?"},
      {"floor 9 9\n pop", "w.wld:2:2: 'pop' without 'push': expected a 'push X Y PHI' before it"},
      {"floor 9 9\n1 1 1 1", "w.wld:2:1: wall of zero length: expected two different ends"},
      {"floor 9 9\n1 1 nan 1", "w.wld:2:5: 'nan' found: expected x2, a number"},
      {"floor 9 9\n1 1 1e999 1", "w.wld:2:5: '1e999' found: expected x2, a number"},
      {"floor 9 9\n1 1 12mm 1", "w.wld:2:5: '12mm' found: expected x2, a number"},
      {"floor 9 9\n1 1 2e7 1", "w.wld:2:5: x2 is 2e7: expected -10000000 to 10000000"},
      {"floor 9", "w.wld:1:8: 'floor' with 1 argument: expected 'floor WIDTH HEIGHT'"},
      {"floor 9 9 9", "w.wld:1:11: 'floor' with 3 arguments: expected 'floor WIDTH HEIGHT'"},
      {"floor 0 9", "w.wld:1:7: width is 0: expected 1 to 10000000"},
      {"floor 9 9\nwidth 9", "w.wld:2:1: the width is given a second time: expected it once"},
      {"# size\n width 9", "w.wld:2:2: width without height: expected both"},
      {"height 9\n0 0 1 1", "w.wld:1:1: height without width: expected both"},
      {"\nposition 1 1 0\n",
       "w.wld:2:1: no size and no walls up to the end: expected 'floor WIDTH HEIGHT'"},
      {"floor 9 9\n1 2 3 4 5",
       "w.wld:2:10: wall of 5 values: expected 4 (x1 y1 x2 y2), 6 (... "
       "thickness height) or 9 (... red green blue)"},
      {"floor 9 9\n1 2 3 4 5 6 256 0 0", "w.wld:2:13: red is 256: expected 0 to 255"},
      {"floor_texture \"a",
       "w.wld:1:15: quote \" is not closed: expected another one on this line"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(world_error(text), expected) << text;
}

TEST(World, LimitsTheNestingOfFrames) {
  std::string text = "floor 9 9\n";
  for (int i = 0; i < 1001; ++i) text += "push 0 0 0\n";
  EXPECT_THAT(world_error(text), testing::HasSubstr("w.wld:1002:1: 'push' nested 1001 deep"));
}

TEST(World, ReadWriteReadIsTheIdentity) {
  const auto first = world_of(
      "floor 3333.3 2000\nwater 1234.5\nfloor_texture 'a b.png'\nposition 100.7 1 33.3\n"
      "push 1234.5 777.7 17\nposition 10 20 30\n0 0 100 3\n1 2 3 4 18 99.9\n"
      "0 0 7 7 1 1 1 2 3\npop\n0.001 0 5 5\n");
  const std::string text = write_world(first);
  EXPECT_EQ(world_of(text), first) << text;
  EXPECT_EQ(write_world(world_of(text)), text);
}

TEST(World, RefusesToWriteWhatAWorldFileCannotHold) {
  auto world = world_of("floor 9 9");
  world.markers.push_back({});
  EXPECT_THAT(error_of([&] { write_world(world); }), testing::HasSubstr("objects or markers"));
  world = world_of("floor 9 9");
  world.starts.push_back({'S', {}});
  EXPECT_THAT(error_of([&] { write_world(world); }), testing::HasSubstr("start letters"));
}

}  // namespace
}  // namespace eyebridge::files
