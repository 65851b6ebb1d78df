// Things that a person puts into the world, changes and takes away, with the mouse.
#include <QComboBox>
#include <QContextMenuEvent>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>

#include "environment_fixture.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/hal/world_control.hpp"

namespace eyebridge::gui {
namespace {

class ThingsByHand : public testing::EnvironmentFixture {
 protected:
  template <class Widget>
  Widget& child(const char* name) {
    auto* const found = window_->findChild<Widget*>(name);
    if (found == nullptr) throw std::runtime_error(std::string("no ") + name);
    return *found;
  }
  std::string trouble() { return child<QLabel>("trouble").text().toStdString(); }
  hal::WorldControl& control() { return room_.environment().control(); }

  void open_panel() {
    QTest::keyClick(&*window_, Qt::Key_A, Qt::ShiftModifier);
    ASSERT_TRUE(QTest::qWaitFor([&] { return child<QLineEdit>("thing_more").isVisible(); }));
    QTest::mouseClick(&child<QPushButton>("thing_place"), Qt::LeftButton);
    window_->view().fit();
  }
  QMenu* press_right(QPoint place) {
    WorldView& view = window_->view();
    QContextMenuEvent event(QContextMenuEvent::Mouse, place, view.mapToGlobal(place));
    QApplication::sendEvent(&view, &event);
    return window_->findChild<QMenu*>("thing_menu");
  }
  void choose(QMenu& menu, const QString& text) {
    for (QAction* action : menu.actions()) {
      if (action->text().remove('&') == text) action->trigger();
    }
    menu.close();
  }
};

TEST_F(ThingsByHand, OneIsPutWhereThePersonShows) {
  open_panel();
  auto& kind = child<QComboBox>("thing_kind");
  EXPECT_EQ(kind.itemText(0), "golf");
  EXPECT_EQ(kind.itemText(4), "box 300 200") << "its size can be edited";
  kind.setEditText("box 200 100 50");
  QTest::keyClicks(&child<QLineEdit>("thing_more"), "mass 2; wander 100");
  drag(at(1.0, 0.7), at(1.0, 0.9));
  EXPECT_EQ(trouble(), "Object 2 is there");
  const Pose pose = control().object_pose(2).value();
  EXPECT_NEAR(pose.x, 1.0, 0.005);
  EXPECT_NEAR(pose.y, 0.7, 0.005);
  EXPECT_NEAR(pose.theta, kPi / 2, 0.02);
  room_.pass(0.5);
  EXPECT_NE(control().object_pose(2).value(), pose) << "it wanders";
}

TEST_F(ThingsByHand, WhatCannotBeIsToldInWords) {
  open_panel();
  auto& kind = child<QComboBox>("thing_kind");
  kind.setEditText("polygon 100 0 -100 100");
  drag(at(1.0, 0.7), at(1.0, 0.7));
  EXPECT_NE(trouble().find("corner 3 of the polygon: expected three corners or more"),
            std::string::npos)
      << trouble();
  kind.setEditText("can");
  drag(at(0.5, 0.5), at(0.5, 0.5));
  EXPECT_NE(trouble().find("would stand in a robot"), std::string::npos) << trouble();
  kind.setEditText("");
  drag(at(1.0, 0.7), at(1.0, 0.7));
  EXPECT_NE(trouble(), "");
  EXPECT_EQ(control().object_count(), 1);
}

TEST_F(ThingsByHand, OneToolIsUsedAtATime) {
  open_panel();
  QTest::keyClick(&*window_, Qt::Key_A);
  ASSERT_TRUE(QTest::qWaitFor([&] { return child<QLineEdit>("add_program").isVisible(); }));
  QTest::mouseClick(&child<QPushButton>("add_place"), Qt::LeftButton);
  EXPECT_FALSE(child<QPushButton>("thing_place").isChecked());
  QTest::mouseClick(&child<QPushButton>("thing_place"), Qt::LeftButton);
  EXPECT_FALSE(child<QPushButton>("add_place").isChecked());
  drag(at(1.0, 0.7), at(1.0, 0.9));
  EXPECT_EQ(control().object_count(), 2) << "the one that was asked for last";
  QTest::keyClick(&*window_, Qt::Key_M);
  EXPECT_FALSE(child<QPushButton>("thing_place").isChecked());
}

TEST_F(ThingsByHand, TheRightButtonChangesAndRemovesOne) {
  QMenu* menu = press_right(at(1.0, 0.2));
  ASSERT_NE(menu, nullptr);
  choose(*menu, "Change...");
  auto& dialog = child<QInputDialog>("change");
  dialog.setTextValue("wander 100\nyields 10");
  dialog.accept();
  EXPECT_EQ(trouble(), "Object 1 has changed");
  const Pose before = control().object_pose(1).value();
  room_.pass(0.2);
  const Pose after = control().object_pose(1).value();
  EXPECT_NE(after, before);
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return window_->findChild<QInputDialog*>("change") == nullptr; }));
  window_->view().refresh();
  menu = press_right(at(after.x, after.y));
  ASSERT_NE(menu, nullptr);
  choose(*menu, "Remove");
  EXPECT_EQ(trouble(), "Object 1 is gone");
  EXPECT_FALSE(control().object_pose(1));
  window_->view().refresh();
  ASSERT_TRUE(QTest::qWaitFor([&] { return window_->findChild<QMenu*>("thing_menu") == nullptr; }));
  EXPECT_EQ(press_right(at(after.x, after.y)), nullptr);
}

TEST_F(ThingsByHand, AWrongChangeIsToldAndChangesNothing) {
  choose(*press_right(at(1.0, 0.2)), "Change...");
  auto& dialog = child<QInputDialog>("change");
  dialog.setTextValue("wander 100\nmass 0");
  dialog.accept();
  EXPECT_NE(trouble().find("object:2:6: "), std::string::npos) << trouble();
  const Pose before = control().object_pose(1).value();
  room_.pass(0.2);
  EXPECT_EQ(control().object_pose(1).value(), before);
}

}  // namespace
}  // namespace eyebridge::gui
