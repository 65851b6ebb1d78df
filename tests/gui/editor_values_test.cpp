// The world editor's panel: values that are typed.
#include <QColor>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QTest>

#include <gtest/gtest.h>

#include "editor_rig.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::gui {
namespace {

class EditorValues : public testing::EditorRig {
 protected:
  void SetUp() override {
    EditorRig::SetUp();
    open("");
  }
};

TEST_F(EditorValues, ValuesAreTypedAsStepsThatCanBeUndone) {
  click(at(4, 2));
  auto* const thickness = qobject_cast<QDoubleSpinBox*>(window_->properties().field("Thickness"));
  ASSERT_NE(thickness, nullptr);
  thickness->selectAll();
  QTest::keyClicks(thickness, "50");
  EXPECT_EQ(plan().walls[1].thickness, world::Wall::kFileThickness) << "still being typed";
  QTest::keyClick(thickness, Qt::Key_Return);
  EXPECT_EQ(plan().walls[1].thickness, 0.05);
  press_key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(plan().walls[1].thickness, world::Wall::kFileThickness);
  window_->properties().set_value("Colour", QColor(1, 2, 3));
  EXPECT_EQ(plan().walls[1].colour, (Rgb{1, 2, 3}));
}

TEST_F(EditorValues, TheFloorHasPropertiesToo) {
  press_key(Qt::Key_Escape);
  auto* const width = qobject_cast<QDoubleSpinBox*>(window_->properties().field("Width"));
  ASSERT_NE(width, nullptr);
  width->selectAll();
  QTest::keyClicks(width, "5000");
  QTest::keyClick(width, Qt::Key_Return);
  EXPECT_EQ(plan().width, 5.0);
  EXPECT_EQ(plan().walls[1].a, (Vec2{4, 0})) << "its walls stay";
}

TEST_F(EditorValues, RobotsHavePrograms) {
  press_key(Qt::Key_R);
  click(at(2, 2));
  auto* const program = qobject_cast<QLineEdit*>(window_->properties().field("Program"));
  ASSERT_NE(program, nullptr);
  QTest::keyClicks(program, "follow.x");  // whose letters are tools elsewhere
  QTest::keyClick(program, Qt::Key_Return);
  EXPECT_EQ(plan().robots[0].program, "follow.x");
  EXPECT_EQ(window_->canvas().tool(), PlanTool::Robot);
  window_->properties().set_value("Arguments", "1 \"two words\"");
  EXPECT_EQ(plan().robots[0].arguments, (std::vector<std::string>{"1", "two words"}));
  window_->properties().set_value("Enters after", 2.5);
  EXPECT_EQ(plan().robots[0].enters, 2.5);
}

TEST_F(EditorValues, ThingsHaveMatterAndWaysSpeeds) {
  press_key(Qt::Key_O);
  click(at(1, 1));
  press_key(Qt::Key_P);
  click(at(2, 1));
  window_->properties().set_value("Friction", 0.5);
  window_->properties().set_value("Mass (kg)", 2.0);
  window_->properties().set_value("Fixed", true);
  window_->properties().set_value("Way: speed", 250.0);
  window_->properties().set_value("Way: round and round", false);
  const world::ObjectSpec& golf = plan().things.at(0).spec;
  EXPECT_EQ(golf.matter.friction, 0.5);
  EXPECT_EQ(golf.matter.restitution, std::nullopt);
  EXPECT_EQ(golf.matter.mass, 2.0);
  EXPECT_TRUE(golf.matter.fixed);
  EXPECT_EQ(golf.path->speed, 0.25);
  EXPECT_FALSE(golf.path->loop);
}

TEST_F(EditorValues, SeveralWallsGetOneValue) {
  press_key(Qt::Key_A, Qt::ControlModifier);
  window_->properties().set_value("Height", 300.0);
  for (const world::Wall& wall : plan().walls) EXPECT_EQ(wall.height, 0.3);
  press_key(Qt::Key_Z, Qt::ControlModifier);
  for (const world::Wall& wall : plan().walls) EXPECT_EQ(wall.height, 0.2);
}

TEST_F(EditorValues, AnEndOfAWallIsTypedForAllThatShareIt) {
  click(at(4, 2));
  window_->properties().set_value("x2", 3500.0);
  EXPECT_EQ(plan().walls[1].b, (Vec2{3.5, 4}));
  EXPECT_EQ(plan().walls[2].a, (Vec2{3.5, 4}));
}

TEST_F(EditorValues, AStartHasALetterAndAHeading) {
  press_key(Qt::Key_S);
  click(at(1, 1));
  window_->properties().set_value("Letter", "U");
  window_->properties().set_value("Heading", 90.0);
  EXPECT_EQ(plan().starts.at(0), (world::StartPose{'U', {1, 1, kPi / 2}}));
  window_->properties().set_value("Letter", "none");
  EXPECT_EQ(plan().starts[0].letter, 0);
}

TEST_F(EditorValues, OnlyBoxesHaveSizes) {
  press_key(Qt::Key_O);
  click(at(1, 1));
  EXPECT_FALSE(window_->properties().field("Length")->isVisible()) << "a golf ball is one";
  window_->canvas().set_thing("box");
  click(at(3, 3));
  ASSERT_TRUE(window_->properties().field("Length")->isVisible());
  window_->properties().set_value("Length", 500.0);
  EXPECT_EQ(plan().things.at(1).spec.size.x, 0.5);
  EXPECT_NO_THROW(files::write_sim(sim_of(plan())));
}

TEST_F(EditorValues, APolygonHasCornersThatAreWritten) {
  press_key(Qt::Key_O);
  window_->canvas().set_thing("polygon");
  click(at(3, 3));
  PropertyPanel& panel = window_->properties();
  ASSERT_TRUE(panel.field("Corners (mm)")->isVisible());
  EXPECT_FALSE(panel.field("Length")->isVisible());
  const std::vector<Vec2> square = {{0.1, 0.1}, {-0.1, 0.1}, {-0.1, -0.1}, {0.1, -0.1}};
  panel.set_value("Corners (mm)", "100, 100; -100, 100; -100, -100; 100, -100");
  EXPECT_EQ(plan().things.at(0).spec.corners, square);
  panel.set_value("Corners (mm)", "100, 100; -100, 100");
  EXPECT_EQ(plan().things.at(0).spec.corners, square) << "two corners make no polygon";
  panel.set_value("Height", 300.0);
  EXPECT_NO_THROW(files::write_sim(sim_of(plan())));
  // Turned by a corner: from that at 45 degrees to straight up.
  press_key(Qt::Key_V);
  drag(at(3.1, 3.1), at(3.0, 3.2));
  EXPECT_NEAR(plan().things.at(0).spec.pose.theta, kPi / 4, 0.05);
}

}  // namespace
}  // namespace eyebridge::gui
