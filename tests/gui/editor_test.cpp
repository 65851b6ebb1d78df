// The world editor, as a person uses it: drawing.
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QMenuBar>
#include <QMouseEvent>
#include <QTest>
#include <QWheelEvent>
#include <random>

#include <gmock/gmock.h>

#include "album.hpp"
#include "editor_rig.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::gui {
namespace {

class WorldEditor : public testing::EditorRig {
 protected:
  void SetUp() override {
    EditorRig::SetUp();
    open("");
  }
  void press_at(QPoint place) { QTest::mousePress(&window_->canvas(), Qt::LeftButton, {}, place); }
  void move_and_release(QPoint place) {
    Canvas& canvas = window_->canvas();
    QMouseEvent move(QEvent::MouseMove, place, canvas.mapToGlobal(place), Qt::NoButton,
                     Qt::LeftButton, {});
    QApplication::sendEvent(&canvas, &move);
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, place);
  }
};

TEST_F(WorldEditor, BeginsWithARoomOfFourByFourMetres) {
  EXPECT_EQ(plan().width, 4.0);
  EXPECT_EQ(plan().height, 4.0);
  EXPECT_EQ(plan().walls.size(), 4U);
  EXPECT_FALSE(window_->isWindowModified());
  EXPECT_EQ(window_->windowTitle(), "unnamed[*] – world editor");
}

TEST_F(WorldEditor, WallsAreDrawnOnTheGridInOneStroke) {
  press_key(Qt::Key_W);
  drag(at(1.02, 0.98), at(2.51, 0.97));
  ASSERT_EQ(plan().walls.size(), 5U);
  EXPECT_EQ(plan().walls[4].a, (Vec2{1.0, 1.0}));
  EXPECT_EQ(plan().walls[4].b, (Vec2{2.5, 1.0}));
  EXPECT_TRUE(window_->isWindowModified());
  drag(at(1.02, 2.0), at(1.02, 2.5), Qt::ControlModifier);
  ASSERT_EQ(plan().walls.size(), 6U);
  EXPECT_NE(plan().walls[5].a.x, 1.0) << "Ctrl leaves the grid";
  EXPECT_NEAR(plan().walls[5].a.x, 1.02, 0.006);
}

TEST_F(WorldEditor, WallsAreDrawnFromCornerToCorner) {
  press_key(Qt::Key_W);
  click(at(1, 1));
  click(at(2, 1));
  EXPECT_EQ(message(), "1000 mm, 0.0°");
  click(at(2, 2));
  click(at(1, 1));  // closed: the next click begins anew
  ASSERT_EQ(plan().walls.size(), 7U);
  EXPECT_EQ(plan().walls[6].a, (Vec2{2, 2}));
  EXPECT_EQ(plan().walls[6].b, (Vec2{1, 1}));
  click(at(3, 3));
  press_key(Qt::Key_Escape);
  click(at(3, 1));
  click(at(3, 2));
  ASSERT_EQ(plan().walls.size(), 8U) << "Escape let the corner at (3, 3) go";
  EXPECT_EQ(plan().walls[7].a, (Vec2{3, 1}));
}

TEST_F(WorldEditor, ShiftKeepsAWallStraight) {
  press_key(Qt::Key_W);
  drag(at(1, 1), at(2, 1.3), Qt::ShiftModifier);
  EXPECT_EQ(plan().walls.at(4).b, (Vec2{2, 1}));
  drag(at(1, 2), at(2, 2.9), Qt::ShiftModifier);
  EXPECT_EQ(plan().walls.at(5).b, (Vec2{2, 3}));
}

TEST_F(WorldEditor, AVertexMovesWithAllWallsThatShareIt) {
  drag(at(4, 4), at(3.5, 3.01));
  EXPECT_EQ(plan().walls[1].b, (Vec2{3.5, 3}));
  EXPECT_EQ(plan().walls[2].a, (Vec2{3.5, 3}));
  EXPECT_EQ(plan().walls.size(), 4U);
  press_key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(plan().walls[2].a, (Vec2{4, 4}));
  press_key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(plan().walls[2].a, (Vec2{3.5, 3}));
}

TEST_F(WorldEditor, AWallMovesAndItsNeighboursFollow) {
  drag(at(4, 2), at(3.48, 2.2));
  EXPECT_EQ(plan().walls[1].a, (Vec2{3.5, 0.2}));
  EXPECT_EQ(plan().walls[0].b, (Vec2{3.5, 0.2}));
  EXPECT_EQ(plan().walls[2].a, (Vec2{3.5, 4.2}));
}

TEST_F(WorldEditor, WhatIsUndoneUnderTheMouseIsLetGo) {
  press_key(Qt::Key_W);
  drag(at(1, 1), at(2, 1));
  press_key(Qt::Key_V);
  press_at(at(2, 1));
  press_key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_EQ(plan().walls.size(), 4U);
  const QString before = message();
  move_and_release(at(3, 3));
  EXPECT_EQ(message(), before) << "no wall is being moved";
  EXPECT_EQ(plan().walls.size(), 4U);
  press_key(Qt::Key_M);
  click(at(1, 1));
  press_key(Qt::Key_Right);
  press_key(Qt::Key_V);
  press_at(at(1.1, 1));
  press_key(Qt::Key_Z, Qt::ControlModifier);
  move_and_release(at(3, 3));
  EXPECT_EQ(plan().markers.at(0).position, (Vec2{1, 1}));
}

TEST_F(WorldEditor, AnotherToolEndsTheBand) {
  press_at(at(2, 2));
  press_key(Qt::Key_W);
  press_key(Qt::Key_V);
  drag(at(4, 4), at(3.5, 3));
  EXPECT_EQ(plan().walls[1].b, (Vec2{3.5, 3}));
}

TEST_F(WorldEditor, ADoubleClickSplitsAWall) {
  double_click(at(1.32, 4));
  ASSERT_EQ(plan().walls.size(), 5U);
  EXPECT_EQ(plan().walls[2].b, (Vec2{1.3, 4}));
  EXPECT_EQ(plan().walls[3].a, (Vec2{1.3, 4}));
  drag(at(1.3, 4), at(1.3, 3));
  EXPECT_EQ(plan().walls[3].a, (Vec2{1.3, 3})) << "its new end can be dragged";
  click(at(2, 0));
  press_key(Qt::Key_K, Qt::ControlModifier);
  ASSERT_EQ(plan().walls.size(), 6U);
  EXPECT_EQ(plan().walls[0].b, (Vec2{2, 0}));
}

TEST_F(WorldEditor, WhatMeetsIsNoWallAnyMore) {
  drag(at(4, 4), at(4, 0));
  EXPECT_EQ(plan().walls.size(), 3U);
  press_key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(plan().walls.size(), 4U);
}

TEST_F(WorldEditor, ThingsArePlacedTurnedAndDragged) {
  window_->findChild<QComboBox*>("things")->setCurrentText("box");
  press_key(Qt::Key_O);
  drag(at(1, 1), at(1, 2));
  ASSERT_EQ(plan().things.size(), 1U);
  EXPECT_EQ(plan().things[0].spec.pose, (Pose{1, 1, kPi / 2}));
  EXPECT_EQ(plan().things[0].spec.name, "box");
  press_key(Qt::Key_V);
  drag(at(1.02, 1), at(2.02, 1.5));
  EXPECT_EQ(plan().things[0].spec.pose, (Pose{2, 1.5, kPi / 2}));
  press_key(Qt::Key_Delete);
  EXPECT_TRUE(plan().things.empty());
}

TEST_F(WorldEditor, RobotsStartsAndMarkersArePlaced) {
  press_key(Qt::Key_R);
  click(at(1, 1));
  press_key(Qt::Key_S);
  drag(at(2, 1), at(1, 1.02));
  press_key(Qt::Key_M);
  click(at(3, 1));
  ASSERT_EQ(plan().robots.size(), 1U);
  EXPECT_EQ(plan().robots[0].model, "S4");
  EXPECT_EQ(plan().robots[0].pose, (Pose{1, 1, 0}));
  ASSERT_EQ(plan().starts.size(), 1U);
  EXPECT_EQ(plan().starts[0].pose, (Pose{2, 1, kPi}));
  ASSERT_EQ(plan().markers.size(), 1U);
  EXPECT_EQ(plan().markers[0].position, (Vec2{3, 1}));
}

TEST_F(WorldEditor, ARobotIsTurnedByItsRim) {
  press_key(Qt::Key_R);
  click(at(2, 2));
  press_key(Qt::Key_V);
  drag(at(2.085, 2), at(2.03, 2.2));
  EXPECT_EQ(plan().robots.at(0).pose, (Pose{2, 2, deg_to_rad(75)}));
  press_key(Qt::Key_BracketRight);
  EXPECT_NEAR(plan().robots[0].pose->theta, deg_to_rad(60), 1e-12);
}

TEST_F(WorldEditor, AWayIsDrawnPointByPointAndChanged) {
  window_->findChild<QComboBox*>("things")->setCurrentText("can");
  press_key(Qt::Key_O);
  click(at(1, 1));
  press_key(Qt::Key_P);
  click(at(2, 1));
  click(at(2, 2));
  const auto points = [&] { return plan().things.at(0).spec.path->points; };
  EXPECT_EQ(points(), (std::vector<Vec2>{{2, 1}, {2, 2}}));
  press_key(Qt::Key_V);
  drag(at(2, 2), at(3, 3));
  EXPECT_EQ(points(), (std::vector<Vec2>{{2, 1}, {3, 3}}));
  double_click(at(1.5, 1));
  EXPECT_EQ(points(), (std::vector<Vec2>{{1.5, 1}, {2, 1}, {3, 3}}));
  click(at(2, 1));
  press_key(Qt::Key_Delete);
  EXPECT_EQ(points(), (std::vector<Vec2>{{1.5, 1}, {3, 3}}));
  EXPECT_EQ(plan().things.size(), 1U) << "the point went, not the can";
}

TEST_F(WorldEditor, ABandSelectsWhatLiesWithin) {
  press_key(Qt::Key_M);
  click(at(1, 1));
  click(at(2, 1));
  click(at(3, 3));
  press_key(Qt::Key_V);
  drag(at(0.5, 0.5), at(2.5, 1.5));
  EXPECT_EQ(window_->document().selection(), (Selection{{Kind::Marker, 0}, {Kind::Marker, 1}}));
  click(at(3, 3), Qt::ShiftModifier);
  EXPECT_EQ(window_->document().selection().size(), 3U);
  click(at(3, 3), Qt::ShiftModifier);
  EXPECT_EQ(window_->document().selection().size(), 2U);
  drag(at(1, 1), at(1, 2));
  EXPECT_EQ(plan().markers[1].position, (Vec2{2, 2})) << "both move";
  press_key(Qt::Key_A, Qt::ControlModifier);
  EXPECT_EQ(window_->document().selection().size(), 7U);
  press_key(Qt::Key_Delete);
  EXPECT_TRUE(plan().walls.empty());
  press_key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(plan().walls.size(), 4U);
  EXPECT_EQ(plan().markers.size(), 3U);
}

TEST_F(WorldEditor, CopiesArePastedBesideTheirOriginals) {
  press_key(Qt::Key_R);
  click(at(2, 2));
  press_key(Qt::Key_C, Qt::ControlModifier);
  press_key(Qt::Key_V, Qt::ControlModifier);
  press_key(Qt::Key_V, Qt::ControlModifier);
  ASSERT_EQ(plan().robots.size(), 3U);
  EXPECT_EQ(plan().robots[1].pose, (Pose{2.1, 1.9, 0}));
  EXPECT_EQ(plan().robots[2].pose, (Pose{2.2, 1.8, 0}));
  press_key(Qt::Key_D, Qt::ControlModifier);
  EXPECT_EQ(plan().robots.size(), 4U);
}

TEST_F(WorldEditor, ArrowKeysMoveWhatIsSelected) {
  press_key(Qt::Key_M);
  click(at(1, 1));
  press_key(Qt::Key_Right);
  press_key(Qt::Key_Up);
  EXPECT_EQ(plan().markers[0].position, (Vec2{1.1, 1.1}));
  press_key(Qt::Key_Left, Qt::ControlModifier);
  EXPECT_EQ(plan().markers[0].position, (Vec2{1.099, 1.1}));
}

TEST_F(WorldEditor, UndoHasNoLimit) {
  press_key(Qt::Key_M);
  click(at(1, 1));
  for (int i = 0; i < 300; ++i) press_key(i % 2 == 0 ? Qt::Key_Right : Qt::Key_Up);
  for (int i = 0; i < 301; ++i) press_key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(plan().markers.empty());
  EXPECT_FALSE(window_->isWindowModified()) << "back where it began";
}

TEST_F(WorldEditor, TheKeyboardSelectsOneAfterTheOther) {
  press_key(Qt::Key_M);
  click(at(1, 1));
  press_key(Qt::Key_N);
  EXPECT_EQ(window_->document().selection(), (Selection{{Kind::Wall, 0}})) << "after the last one";
  press_key(Qt::Key_N);
  EXPECT_EQ(window_->document().selection(), (Selection{{Kind::Wall, 1}}));
  press_key(Qt::Key_N, Qt::ShiftModifier);
  press_key(Qt::Key_N, Qt::ShiftModifier);
  EXPECT_EQ(window_->document().selection(), (Selection{{Kind::Marker, 0}}));
}

TEST_F(WorldEditor, WhoChoosesAThingPlacesIt) {
  auto* const things = window_->findChild<QComboBox*>("things");
  things->setFocus();
  QTest::keyClick(things, Qt::Key_Down);  // from golf
  EXPECT_EQ(window_->canvas().tool(), PlanTool::Thing);
  click(at(1, 1));
  EXPECT_EQ(plan().things.at(0).spec.name, "soccer");
}

TEST_F(WorldEditor, LooksAsAPersonHasSeenIt) {
  press_key(Qt::Key_R);
  drag(at(1, 1), at(1, 2));
  press_key(Qt::Key_O);
  window_->findChild<QComboBox*>("things")->setCurrentText("box");
  drag(at(3, 1), at(3.5, 1.5));
  press_key(Qt::Key_P);
  click(at(3, 3));
  click(at(2, 3));
  press_key(Qt::Key_V);
  window_->canvas().setFixedSize(600, 600);
  window_->canvas().fit();
  EXPECT_TRUE(testing::looks_as(window_->canvas().grab().toImage(), "editor"));
}

TEST_F(WorldEditor, LengthsAreMeasured) {
  press_key(Qt::Key_L);
  drag(at(0, 0), at(3, 4));
  EXPECT_EQ(message(), "5000 mm, 53.1°");
  EXPECT_FALSE(window_->isWindowModified());
}

TEST_F(WorldEditor, TheWheelZoomsToThePointerAndTheMiddleButtonPans) {
  Canvas& canvas = window_->canvas();
  const QPointF pointer = at(1, 1);
  const Vec2 before = canvas.viewport().to_world(pointer);
  const double scale = canvas.viewport().pixels_per_metre();
  QWheelEvent wheel(pointer, canvas.mapToGlobal(pointer), {}, {0, 240}, Qt::NoButton, {},
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(&canvas, &wheel);
  EXPECT_NEAR(canvas.viewport().pixels_per_metre(), 1.25 * 1.25 * scale, 1e-9);
  EXPECT_NEAR(norm(canvas.viewport().to_world(pointer) - before), 0.0, 1e-9);
  const QPoint place = at(1, 1);
  drag(place, place + QPoint(40, 30), {}, Qt::MiddleButton);
  EXPECT_EQ(at(1, 1), place + QPoint(40, 30));
  press_key(Qt::Key_F);
  EXPECT_NEAR(canvas.viewport().pixels_per_metre(), scale, 1e-9);
}

TEST_F(WorldEditor, TheStatusBarTellsWhereThePointerIs) {
  drag(at(1, 2), at(1.5, 2));
  EXPECT_EQ(window_->findChild<QLabel*>("pointer")->text().left(3), "x 1");
}

TEST_F(WorldEditor, SurvivesAMonkeyAndUndoesAllItDid) {
  const Plan first = plan();
  std::mt19937 random(7);
  const auto any = [&](int below) {
    return static_cast<int>(random() % static_cast<unsigned>(below));
  };
  const Qt::Key keys[] = {
      Qt::Key_V,    Qt::Key_W,      Qt::Key_O, Qt::Key_R,      Qt::Key_S,
      Qt::Key_M,    Qt::Key_P,      Qt::Key_L, Qt::Key_Delete, Qt::Key_BracketLeft,
      Qt::Key_Left, Qt::Key_Escape, Qt::Key_F, Qt::Key_G};
  const Qt::Key commands[] = {Qt::Key_Z, Qt::Key_Y, Qt::Key_A, Qt::Key_C, Qt::Key_V, Qt::Key_K};
  const Qt::KeyboardModifiers modifiers[] = {Qt::NoModifier, Qt::NoModifier, Qt::ShiftModifier,
                                             Qt::ControlModifier};
  const auto somewhere = [&] {
    return QPoint(any(window_->canvas().width()), any(window_->canvas().height()));
  };
  constexpr int kMoves = 1500;
  for (int i = 0; i < kMoves; ++i) {
    const Qt::KeyboardModifiers held = modifiers[any(4)];
    const std::size_t size = all_items(plan()).size();
    switch (any(6)) {
      case 0:
        click(somewhere(), held);
        break;
      case 1:
        double_click(somewhere(), held);
        break;
      case 2:
        press_key(keys[any(14)]);
        break;
      case 3:
        if (size < 200 || any(2) == 0) press_key(commands[any(6)], Qt::ControlModifier);
        break;
      default:
        drag(somewhere(), somewhere(), held);
    }
    for (const world::Wall& wall : plan().walls) ASSERT_FALSE(same_point(wall.a, wall.b)) << i;
    for (const Item& item : window_->document().selection()) ASSERT_TRUE(has(plan(), item)) << i;
  }
  EXPECT_GT(window_->document().history().count(), 100);
  EXPECT_NO_THROW(files::write_sim(sim_of(plan())));
  while (window_->document().history().canUndo()) window_->document().history().undo();
  EXPECT_TRUE(same_plan(plan(), first));
}

TEST_F(WorldEditor, EveryActionOfTheMenusCanBeReachedByKeyboard) {
  int count = 0;
  for (QMenu* menu : window_->menuBar()->findChildren<QMenu*>()) {
    for (QAction* action : menu->actions()) {
      if (action->isSeparator() || action->menu() != nullptr) continue;
      const bool is_dock = action->text() == "Properties";
      EXPECT_TRUE(is_dock || !action->shortcut().isEmpty()) << action->text().toStdString();
      ++count;
    }
  }
  EXPECT_GE(count, 28);
}

}  // namespace
}  // namespace eyebridge::gui
