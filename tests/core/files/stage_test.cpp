// Worlds of Stage. The grammar and how a model's blocks fill its size are facts of its
// documentation; files are of our own making, after those that it ships.
#include <map>

#include <gmock/gmock.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/foreign_worlds.hpp"
#include "reading.hpp"

namespace eyebridge::files {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct ReadStage {
  world::WorldModel model;
  std::vector<std::string> warnings;
};

/// With files in memory; the picture is 8 x 4 with a dark rim one pixel within its white one.
ReadStage read_worldfile(const std::string& text,
                         std::map<std::string, std::string> includes = {}) {
  NamedFiles files;
  files.text = [=](const std::string& name, const SourceLocation& where) {
    const auto found = includes.find(name);
    if (found == includes.end()) throw ConfigError(where, "no such file: '" + name + "'");
    return found->second;
  };
  files.picture = [](const std::string&, const SourceLocation&) {
    GreyPicture picture{8, 5, std::vector<std::uint8_t>(40, 255)};
    for (int x = 1; x < 7; ++x) picture.greys[static_cast<std::size_t>(8 + x)] = 0;
    for (int x = 1; x < 7; ++x) picture.greys[static_cast<std::size_t>(24 + x)] = 127;
    return picture;
  };
  std::vector<Warning> warnings;
  ReadStage out{read_stage(text, "s.world", files, warnings), {}};
  for (const Warning& warning : warnings) out.warnings.push_back(warning.str());
  return out;
}

const std::string kMapInc =
    "define floorplan model\n(\n  color \"gray30\"\n  gui_nose 0\n  gui_grid 1\n"
    "  gripper_return 0 # not to be moved\n)\n";

TEST(Stage, ABitmapFillsTheSizeOfItsModel) {
  const auto read = read_worldfile(
      "include \"map.inc\"\nresolution 0.02\nwindow ( size [ 600 600 ] )\n"
      "floorplan ( name \"cave\" pose [1 2 0 0] size [12.000 6.000 0.600] bitmap \"b/cave.png\" "
      ")\n",
      {{"map.inc", kMapInc}});
  // The dark pixels alone fill it: not the white ones around them.
  EXPECT_NEAR(read.model.corner.x, -5, 1e-9);
  EXPECT_NEAR(read.model.width, 12, 1e-9);
  EXPECT_NEAR(read.model.corner.y, -1, 1e-9);
  EXPECT_NEAR(read.model.height, 6, 1e-9);
  ASSERT_EQ(read.model.walls.size(), 8U) << "two bars";
  EXPECT_EQ(read.model.walls[0].height, 0.6);
  EXPECT_THAT(read.warnings, ElementsAre(HasSubstr("how Stage shows a model"),
                                         HasSubstr("s.world:2:1: warning: not "
                                                   "carried over: settings of Stage (2 times)"),
                                         HasSubstr("the colour 'gray30'"),
                                         HasSubstr("the property 'gripper_return' of a model")));
}

TEST(Stage, ABoundaryIsTheRimOfThePicture) {
  const auto read = read_worldfile("model ( size [8 5 1] boundary 1 bitmap \"p.png\" )");
  EXPECT_EQ(read.model.walls.size(), 12U);
  EXPECT_NEAR(read.model.width, 8, 1e-9);
  // A pixel is a metre now: the upper bar's lower edge lies three metres above the lower rim.
  double highest = -10;
  for (std::size_t i = 0; i < 8; ++i) highest = std::max(highest, read.model.walls[i].a.y);
  EXPECT_NEAR(highest, 1.5, 1e-9);
}

TEST(Stage, BoxesAreWallsAndRobotsAreStarts) {
  const auto read = read_worldfile(
      "define wall model ( size [ 4 0.2 0.5 ] color_rgba [ 1 0 0 1 ] )\n"
      "define rob position ( size [0.4 0.4 0.2] ranger ( sensor( range [0 5] ) ) )\n"
      "wall ( pose [ 2 1 0 90 ] )\n"
      "wall ( pose [ 0 0 0 ] size [ 0.2 4 0.5 ] )\n"
      "rob ( name \"r0\" pose [ 1 0.5 0 45 ] ctrl \"wander\" )\n");
  ASSERT_EQ(read.model.walls.size(), 2U);
  const world::Wall& first = read.model.walls[0];
  EXPECT_NEAR(first.a.x, 2, 1e-9);
  EXPECT_NEAR(first.a.y, -1, 1e-9);
  EXPECT_NEAR(first.b.y, 3, 1e-9);
  EXPECT_EQ(first.thickness, 0.2);
  EXPECT_EQ(first.colour, (Rgb{255, 0, 0}));
  EXPECT_NEAR(read.model.walls[1].b.y, 2, 1e-9) << "along its longer side";
  ASSERT_EQ(read.model.starts.size(), 1U);
  EXPECT_NEAR(read.model.starts[0].pose.theta, kPi / 4, 1e-12);
  EXPECT_THAT(read.warnings,
              ElementsAre(HasSubstr("s.world:5:1: warning: not carried over: a robot")));
}

TEST(Stage, ModelsInModelsAndBlocks) {
  const auto read = read_worldfile(
      "unit_length \"cm\"\n"
      "model ( pose [ 100 0 0 90 ] size [ 20 20 20 ]\n"
      "  block ( points 3 point[0] [0 0] point[1] [2 0] point[2] [0 2] z [0 1] )\n"
      "  model ( pose [ 50 0 0 0 ] size [ 10 10 ] origin [ 5 0 0 0 ]\n"
      "    polygons 1 polygon[0].points 4 polygon[0].point[0] [0 0] polygon[0].point[1] [0 1]\n"
      "    polygon[0].point[2] [1 1] polygon[0].point[3] [1 0] ) )\n");
  ASSERT_EQ(read.model.walls.size(), 7U);
  // The triangle is 0.2 m wide about (1, 0), turned by 90 degrees.
  EXPECT_NEAR(read.model.walls[0].a.x, 1.1, 1e-9);
  EXPECT_NEAR(read.model.walls[0].a.y, -0.1, 1e-9);
  EXPECT_NEAR(read.model.walls[0].b.y, 0.1, 1e-9);
  // The square lies 0.5 + 0.05 m farther along y.
  EXPECT_NEAR(read.model.walls[3].a.x, 1.05, 1e-9);
  EXPECT_NEAR(read.model.walls[3].a.y, 0.5, 1e-9);
}

TEST(Stage, WhatIsNotKnownIsSaid) {
  const auto read = read_worldfile(
      "include \"pioneer.inc\"\npioneer2dx ( pose [0 0 0 0] )\n"
      "model ( size [1 1 1] joules 3 obstacle_return 1 sicklaser ( samples 32 ) )\n"
      "model ( size [1 1 1] obstacle_return 0 )\n");
  EXPECT_THAT(
      read.warnings,
      ElementsAre(
          HasSubstr("s.world:1:9: warning: no such file: 'pioneer.inc'; what it defines is "
                    "not known"),
          HasSubstr("s.world:2:1: warning: not carried over: 'pioneer2dx', which is defined"),
          HasSubstr("s.world:3:49: warning: not carried over: 'sicklaser', which is a device"),
          HasSubstr("s.world:4:22: warning: not carried over: a model that is no obstacle"),
          HasSubstr("s.world:3:22: warning: not carried over: the property 'joules'")));
  EXPECT_EQ(read.model.walls.size(), 1U);
}

TEST(Stage, ErrorsHaveAPlace) {
  const auto error = [](const std::string& text) {
    return error_of([&] { read_worldfile(text); });
  };
  EXPECT_EQ(error("model (\n size [1 1"), "s.world:2:11: a list without its ']'");
  EXPECT_EQ(error("model ( size [1 1]\n"), "s.world:1:1: 'model (' without its ')'");
  EXPECT_THAT(error("model ( size [1 x] )"),
              HasSubstr("s.world:1:17: found 'x': expected a number"));
  EXPECT_THAT(error("model ( name \"a\n )"), HasSubstr("s.world:1:14: a text without its closing"));
  EXPECT_THAT(error("model { }"), HasSubstr("s.world:1:7: found '{'"));
  EXPECT_THAT(error("model ( size 1.2.3 )"), HasSubstr("found '1.2.3': expected a number"));
  EXPECT_THAT(error("model ( size [0 1 1] )"),
              HasSubstr("size: expected more than 0, at most 10 km"));
  EXPECT_THAT(error("model ( pose [0 1] )"), HasSubstr("pose: expected 3 or 4 numbers"));
  EXPECT_THAT(error("model ( pose [1e8 1 0] )"), HasSubstr("more than 10 km"));
  EXPECT_THAT(error("model ( block ( points 2 ) )"), HasSubstr("points: expected 3 to 10000"));
  EXPECT_THAT(error("model ( block ( points 3 point[0] [1 1] ) )"), HasSubstr("expected point[1]"));
  EXPECT_THAT(error("define a"), HasSubstr("define: expected a name"));
  EXPECT_THAT(error("include map.inc"), HasSubstr("the name of a file in quotes"));
  EXPECT_THAT(error("unit_length \"inch\""),
              HasSubstr("unit_length is 'inch': expected m, cm or mm"));
  EXPECT_THAT(error("resolution 1"), HasSubstr("nothing that spans a floor"));
  EXPECT_THAT(error_of([] {
                read_worldfile("include \"a.inc\"", {{"a.inc", "include \"a.inc\"\n"}});
              }),
              HasSubstr("more than 20 deep"));
  std::string doubling = "define a0 model ( )\n";
  for (int i = 1; i < 40; ++i) {
    const std::string before = " a" + std::to_string(i - 1) + " ( ) ";
    doubling += "define a" + std::to_string(i) + " model (" + before + before + ")\n";
  }
  EXPECT_THAT(error(doubling), HasSubstr("more than 100000 entities"));
}

TEST(Stage, OurOwnIsReadAgain) {
  Scenario scenario;
  scenario.world.width = scenario.world.height = 2;
  scenario.world.walls = world::walls_around(2, 2);
  for (world::Wall& wall : scenario.world.walls) wall.thickness = 0.02;
  world::ObjectSpec box;
  box.kind = world::ObjectKind::Box;
  box.pose = {1, 1, 0.5};
  box.size = {0.3, 0.2};
  scenario.world.objects = {box, {}};
  scenario.world.objects[1].pose = {0.4, 0.5, 0};
  scenario.world.starts = {{0, {0.5, 1.5, 1}}};
  const WrittenWorld written = write_stage(scenario, "room");
  EXPECT_THAT(written.losses, ElementsAre("2 objects that can be pushed (they stand still now)"));
  const auto read = read_worldfile(written.text);
  ASSERT_EQ(read.model.walls.size(), 4U + 4U + 16U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(norm(read.model.walls[i].a - scenario.world.walls[i].a), 0, 1e-9);
    EXPECT_NEAR(norm(read.model.walls[i].b - scenario.world.walls[i].b), 0, 1e-9);
  }
  const std::vector<Vec2> corners = corners_of(box);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 corner = Vec2{1, 1} + Heading::from_angle(0.5).rotate(corners[i]);
    EXPECT_NEAR(norm(read.model.walls[4 + i].a - corner), 0, 1e-9);
  }
  EXPECT_NEAR(norm(read.model.walls[8].a - Vec2{0.42, 0.5}), 0, 1e-9);
  ASSERT_EQ(read.model.starts.size(), 1U);
  EXPECT_NEAR(read.model.starts[0].pose.theta, 1, 1e-12);
}

}  // namespace
}  // namespace eyebridge::files
