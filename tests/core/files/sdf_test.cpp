// What we write for Gazebo, read by its own library.
#include <gmock/gmock.h>
#include <sdf/sdf.hh>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/foreign_worlds.hpp"
#include "reading.hpp"

namespace eyebridge::files {
namespace {

using ::testing::ElementsAre;

/// Anything that is not of SDFormat is an error.
sdf::Errors load(sdf::Root& root, const std::string& text) {
  sdf::ParserConfig strict;
  strict.SetWarningsPolicy(sdf::EnforcementPolicy::ERR);
  strict.SetUnrecognizedElementsPolicy(sdf::EnforcementPolicy::ERR);
  return root.LoadSdfString(text, strict);
}

std::string in_words(const sdf::Errors& errors) {
  std::string out;
  for (const sdf::Error& error : errors) out += error.Message() + "\n";
  return out;
}

TEST(Sdf, GazebosLibraryReadsAWorldWithEverything) {
  Scenario scenario;
  world::WorldModel& model = scenario.world;
  model.width = 4;
  model.height = 3;
  world::Wall wall{{1, 1}, {1, 2}};
  wall.thickness = 0.1;
  wall.height = 0.5;
  model.walls = {wall, {{0, 0}, {3, 0}}};
  model.starts = {{0, {0.5, 0.25, 1.25}}};
  world::ObjectSpec ball;
  ball.pose = {2, 2, 0};
  world::ObjectSpec can = ball;
  can.kind = world::ObjectKind::Can;
  can.name = "a \"can\" & <more>";
  can.matter.friction = 0.4;
  world::ObjectSpec box = ball;
  box.kind = world::ObjectKind::Box;
  box.size = {0.3, 0.2};
  box.height = 0.1;
  box.matter.fixed = true;
  world::ObjectSpec wedge = ball;
  wedge.kind = world::ObjectKind::Polygon;
  wedge.corners = {{0.1, 0}, {-0.1, 0.1}, {-0.1, -0.1}};
  wedge.matter.restitution = 0.5;
  wedge.path = world::Path{};
  model.objects = {ball, can, box, wedge};
  const WrittenWorld written = write_sdf(scenario, "my \"world\" & more");
  EXPECT_THAT(written.losses,
              ElementsAre("1 bare wall (1 mm thick now)", "how the ball moves by itself"));

  sdf::Root root;
  const sdf::Errors errors = load(root, written.text);
  ASSERT_TRUE(errors.empty()) << in_words(errors);
  ASSERT_EQ(root.WorldCount(), 1U);
  const sdf::World& world = *root.WorldByIndex(0);
  EXPECT_EQ(world.Name(), "my \"world\" & more");
  const sdf::Model* walls = world.ModelByName("walls");
  ASSERT_NE(walls, nullptr);
  EXPECT_TRUE(walls->Static());
  const sdf::Link& link = *walls->LinkByIndex(0);
  ASSERT_EQ(link.CollisionCount(), 2U);
  const sdf::Collision& first = *link.CollisionByIndex(0);
  EXPECT_NEAR(first.RawPose().Yaw(), kPi / 2, 1e-9);
  EXPECT_NEAR(first.RawPose().Pos().X(), 1, 1e-9);
  EXPECT_NEAR(first.RawPose().Pos().Y(), 1.5, 1e-9);
  EXPECT_NEAR(first.RawPose().Pos().Z(), 0.25, 1e-9);
  EXPECT_NEAR(first.Geom()->BoxShape()->Size().X(), 1, 1e-9);
  EXPECT_NEAR(first.Geom()->BoxShape()->Size().Y(), 0.1, 1e-9);
  EXPECT_NEAR(first.Geom()->BoxShape()->Size().Z(), 0.5, 1e-9);
  ASSERT_NE(world.FrameByName("start_1"), nullptr);
  EXPECT_NEAR(world.FrameByName("start_1")->RawPose().Yaw(), 1.25, 1e-9);
  ASSERT_EQ(world.ModelCount(), 6U) << "the floor, the walls and four things";
  const auto shape = [&](const char* name) {
    const sdf::Model* found = world.ModelByName(name);
    EXPECT_NE(found, nullptr) << name;
    return found->LinkByIndex(0)->CollisionByIndex(0)->Geom();
  };
  EXPECT_EQ(shape("ball 1")->SphereShape()->Radius(), 0.02);
  EXPECT_EQ(shape("a \"can\" & <more> 2")->CylinderShape()->Length(), 0.04);
  EXPECT_EQ(shape("ball 3")->BoxShape()->Size().X(), 0.3);
  EXPECT_TRUE(shape("ball 4")->Element()->HasElement("polyline"));
  EXPECT_TRUE(world.ModelByName("ball 3")->Static());
}

TEST(Sdf, GazebosLibraryReadsAllOfOurWorlds) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(EYEBRIDGE_SOURCE_DIR "/worlds")) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".wld" && ending != ".maz" && ending != ".sim") continue;
    LoadOptions options;
    options.robot.clear();
    const Scenario scenario = load_scenario(entry.path(), options);
    sdf::Root root;
    const sdf::Errors errors = load(root, write_sdf(scenario, entry.path().stem().string()).text);
    EXPECT_TRUE(errors.empty()) << entry.path() << ": " << in_words(errors);
    const sdf::Model* walls = errors.empty() ? root.WorldByIndex(0)->ModelByName("walls") : nullptr;
    const std::size_t read = walls == nullptr ? 0 : walls->LinkByIndex(0)->CollisionCount();
    EXPECT_EQ(read, scenario.world.walls.size()) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 10);
}

}  // namespace
}  // namespace eyebridge::files
