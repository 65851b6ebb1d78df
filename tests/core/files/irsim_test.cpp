// Worlds of IR-SIM: the keys are those of its documentation.
#include <gmock/gmock.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/foreign_worlds.hpp"
#include "reading.hpp"

namespace eyebridge::files {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct ReadIrsim {
  world::WorldModel model;
  std::vector<std::string> warnings;
};

ReadIrsim read_yaml_world(const std::string& text) {
  NamedFiles files;
  files.picture = [](const std::string&, const SourceLocation&) {
    GreyPicture picture{8, 4, std::vector<std::uint8_t>(32, 255)};
    for (const std::size_t i : {0U, 1U, 8U, 9U}) picture.greys[i] = 0;  // the upper left corner
    return picture;
  };
  std::vector<Warning> warnings;
  ReadIrsim out{read_irsim(text, "w.yaml", files, warnings), {}};
  for (const Warning& warning : warnings) out.warnings.push_back(warning.str());
  return out;
}

TEST(Irsim, ShapesAreWallsAndCans) {
  const auto read = read_yaml_world(
      "world:\n  height: 8\n  width: 10\n  offset: [-1, -2]\n  step_time: 0.1\n"
      "robot:\n  kinematics: {name: 'diff'}\n  shape: {name: 'circle', radius: 0.2}\n"
      "  state: [1, 2, 1.57]\n  goal: [9, 9, 0]\n"
      "obstacle:\n"
      "  - shape: {name: 'circle', radius: 0.5}\n    state: [5, 5, 0]\n"
      "  - shape: {name: 'rectangle', length: 2, width: 0.5}\n    state: [3, 3, "
      "1.5707963267948966]\n"
      "  - shape: {name: 'polygon', vertices: [[0, 0], [1, 0], [1, 1]]}\n    state: [4, 1]\n"
      "  - shape: {name: 'linestring', vertices: [[0, 0], [2, 0], [2, 2]]}\n    state: [0, 0, "
      "0]\n");
  const world::WorldModel& model = read.model;
  EXPECT_EQ(model.corner, (Vec2{-1, -2}));
  EXPECT_EQ(model.width, 10);
  EXPECT_EQ(model.height, 8);
  ASSERT_EQ(model.objects.size(), 1U);
  EXPECT_EQ(model.objects[0].radius, 0.5);
  EXPECT_TRUE(model.objects[0].matter.fixed);
  ASSERT_EQ(model.walls.size(), 1U + 3U + 2U);
  EXPECT_NEAR(model.walls[0].a.y, 2, 1e-9);
  EXPECT_NEAR(model.walls[0].b.y, 4, 1e-9);
  EXPECT_EQ(model.walls[0].thickness, 0.5);
  EXPECT_EQ(model.walls[3].b, (Vec2{4, 1})) << "a polygon is closed";
  EXPECT_EQ(model.walls[5].b, (Vec2{2, 2})) << "a line is not";
  ASSERT_EQ(model.starts.size(), 1U);
  EXPECT_EQ(model.starts[0].pose.theta, 1.57);
  EXPECT_THAT(
      read.warnings,
      ElementsAre(HasSubstr("w.yaml:10:3: warning: not carried over: a robot's 'goal'"),
                  HasSubstr("w.yaml:7:3: warning: not carried over: a robot's 'kinematics'"),
                  HasSubstr("w.yaml:7:3: warning: not carried over: a robot: where it"),
                  HasSubstr("w.yaml:5:3: warning: not carried over: settings of IR-SIM's")));
}

TEST(Irsim, SeveralOfAKind) {
  const auto read = read_yaml_world(
      "world: {height: 10, width: 10}\n"
      "robot:\n  - number: 3\n    distribution: {name: 'circle', radius: 4}\n"
      "obstacle:\n  - number: 2\n    distribution: {name: manual}\n"
      "    shape:\n      - {name: circle, radius: 1.0}\n      - {name: circle, radius: 0.5}\n"
      "    state: [[1, 2, 0], [3, 4, 0], [5, 6, 0]]\n    behavior: {name: 'rvo'}\n");
  EXPECT_TRUE(read.model.starts.empty()) << "nobody knows where they will be";
  ASSERT_EQ(read.model.objects.size(), 2U);
  EXPECT_EQ(read.model.objects[1].radius, 0.5);
  EXPECT_EQ(read.model.objects[1].pose.position(), (Vec2{3, 4}));
  EXPECT_THAT(read.warnings,
              ElementsAre(HasSubstr("an obstacle's 'behavior'"),
                          HasSubstr("places that are drawn (distribution: circle)")));
}

TEST(Irsim, WhatIsDrawnWhileItRunsIsSaid) {
  const auto read = read_yaml_world(
      "world: {height: 10, width: 10}\n"
      "obstacle:\n  - number: 10\n    shape: [{name: polygon, random_shape: true}]\n"
      "  - {shape: {name: circle, radius: 1}, state: [2, 2]}\n");
  EXPECT_EQ(read.model.objects.size(), 1U);
  EXPECT_THAT(
      read.warnings,
      ElementsAre(HasSubstr("obstacles without a shape"),
                  HasSubstr("w.yaml:4:13: warning: not carried over: shapes that are drawn")));
}

TEST(Irsim, APictureIsAsLargeAsTheFloor) {
  const auto read = read_yaml_world(
      "world:\n  height: 2\n  width: 4\n  obstacle_map: 'cave.png'\n  mdownsample: 2\n");
  ASSERT_EQ(read.model.walls.size(), 4U);
  double left = 10;
  double low = 10;
  for (const world::Wall& wall : read.model.walls) {
    left = std::min(left, wall.a.x);
    low = std::min(low, wall.a.y);
  }
  EXPECT_EQ(left, 0);
  EXPECT_EQ(low, 1);
}

TEST(Irsim, IsToldFromMaps) {
  EXPECT_TRUE(is_irsim("world:\n  height: 1\n"));
  EXPECT_TRUE(is_irsim("# mine\nrobot:\n- state: [1, 1]\n"));
  EXPECT_FALSE(is_irsim("image: a.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n"));
  EXPECT_FALSE(is_irsim("world"));
}

TEST(Irsim, ErrorsHaveAPlace) {
  const auto error = [](const std::string& text) {
    return error_of([&] { read_yaml_world(text); });
  };
  EXPECT_EQ(error("world:\n  height: high\n"),
            "w.yaml:2:11: 'high' found: expected height, a number");
  EXPECT_EQ(error("world: {height: 3}"), "w.yaml:1:8: width and height: expected both");
  EXPECT_THAT(error("world: 3"), HasSubstr("world: expected width and height"));
  EXPECT_THAT(error("obstacle: 3"), HasSubstr("expected a robot or an obstacle"));
  EXPECT_THAT(error("obstacle: {shape: {radius: 1}}"), HasSubstr("shape '': expected circle"));
  EXPECT_THAT(error("obstacle: {shape: {name: star}}"), HasSubstr("shape 'star': expected circle"));
  EXPECT_THAT(error("obstacle: {shape: {name: polygon}}"), HasSubstr("polygon without vertices"));
  EXPECT_THAT(error("obstacle: {shape: {name: circle, radius: -1}}"), HasSubstr("more than 0"));
  EXPECT_THAT(error("robot: {state: 5}"), HasSubstr("state: expected [x, y, heading]"));
  EXPECT_THAT(error("robot: {number: -1}"), HasSubstr("number: expected 0 to 10000"));
  EXPECT_THAT(error("robot: {state: [1, 2, 0]}"), HasSubstr("no floor"));
  EXPECT_THAT(error("robot: [1"), HasSubstr("w.yaml:"));
  EXPECT_THAT(error("- 1"), HasSubstr("expected 'world:'"));
}

}  // namespace
}  // namespace eyebridge::files
