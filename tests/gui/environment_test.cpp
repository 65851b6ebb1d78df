// The driving environment, as a person uses it.
#include <QComboBox>
#include <QTest>
#include <QWheelEvent>
#include <thread>

#include <gtest/gtest.h>

#include "environment_fixture.hpp"

namespace eyebridge::gui {
namespace {

using Environment = testing::EnvironmentFixture;

TEST_F(Environment, ARobotIsCarriedByItsMiddle) {
  drag(at(0.5, 0.5), at(0.7, 0.8));
  const Pose pose = room_.pose(1);
  EXPECT_NEAR(pose.x, 0.7, 0.005);
  EXPECT_NEAR(pose.y, 0.8, 0.005);
  EXPECT_EQ(pose.theta, 0.0);
  EXPECT_EQ(window_->view().chosen(), 0U);
  EXPECT_EQ(room_.pose(2), (Pose{1.5, 0.5, kPi}));
}

TEST_F(Environment, ARobotIsTurnedByItsRim) {
  drag(at(1.5 + 0.085, 0.5), at(1.5, 0.5 + 0.2));
  const Pose pose = room_.pose(2);
  EXPECT_NEAR(pose.x, 1.5, 1e-9);
  EXPECT_NEAR(wrap_angle(pose.theta - kPi - kPi / 2), 0.0, 0.02);
  EXPECT_EQ(window_->view().chosen(), 1U);
}

TEST_F(Environment, AThingIsCarriedToo) {
  drag(at(1.0, 0.2), at(1.0, 0.8));
  const Pose pose = room_.environment().control().object_pose(1).value();
  EXPECT_NEAR(pose.x, 1.0, 0.005);
  EXPECT_NEAR(pose.y, 0.8, 0.005);
}

TEST_F(Environment, NothingIsPutIntoSomethingElse) {
  drag(at(0.5, 0.5), at(1.5, 0.5));  // where robot 2 stands
  EXPECT_LT(room_.pose(1).x, 1.5 - 0.18);
  EXPECT_GT(room_.pose(1).x, 1.1) << "it went as far as it could";
  drag(at(1.5, 0.5), at(1.5, -0.5));  // out of the room
  EXPECT_GT(room_.pose(2).y, 0.09);
  EXPECT_EQ(window_->findChild<QLabel*>("trouble")->text(), "There is no room here");
}

TEST_F(Environment, TheFloorMovesThePicture) {
  const Viewport before = window_->view().viewport();
  drag(at(1.0, 0.7), at(1.0, 0.7) + QPoint(40, 30));
  EXPECT_EQ(at(1.0, 0.7), before.to_pixel({1.0, 0.7}).toPoint() + QPoint(40, 30));
  EXPECT_EQ(room_.pose(1), (Pose{0.5, 0.5, 0.0}));
  QTest::keyClick(&window_->view(), Qt::Key_F);
  EXPECT_EQ(window_->view().viewport(), before);
}

TEST_F(Environment, TheWheelZoomsToThePointer) {
  WorldView& view = window_->view();
  const QPointF pointer = at(0.5, 0.5);
  const Vec2 before = view.viewport().to_world(pointer);
  const double scale = view.viewport().pixels_per_metre();
  QWheelEvent wheel(pointer, view.mapToGlobal(pointer), {}, {0, 240}, Qt::NoButton, {},
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(&view, &wheel);
  EXPECT_NEAR(view.viewport().pixels_per_metre(), 1.25 * 1.25 * scale, 1e-9);
  EXPECT_NEAR(norm(view.viewport().to_world(pointer) - before), 0.0, 1e-9);
}

TEST_F(Environment, TimeIsPausedSteppedAndGoesOn) {
  QTest::keyClick(&*window_, Qt::Key_Space);
  ASSERT_TRUE(room_.environment().time().is_paused());
  std::thread program([&] { room_.pass(0.05); });
  const auto shown = [&] { return window_->view().look().scene.time; };
  QTest::keyClick(&*window_, Qt::Key_Period);
  QTest::keyClick(&*window_, Qt::Key_Period);
  EXPECT_TRUE(QTest::qWaitFor([&] { return shown() > 0.015; }));
  EXPECT_DOUBLE_EQ(shown(), 0.02);
  EXPECT_EQ(window_->findChild<QLabel*>("time")->text(), "0.02 s, paused");
  QTest::keyClick(&*window_, Qt::Key_Space);
  program.join();
  EXPECT_FALSE(room_.environment().time().is_paused());
  EXPECT_FALSE(action("Step").isEnabled());
}

TEST_F(Environment, TheSpeedIsChosen) {
  auto* const factor = window_->findChild<QComboBox*>("factor");
  EXPECT_EQ(factor->currentText(), "fastest");
  factor->setCurrentIndex(factor->findText("2x"));
  EXPECT_EQ(room_.environment().time().factor(), 2.0);
  factor->setCurrentIndex(factor->findText("fastest"));
  EXPECT_EQ(room_.environment().time().factor(), hal::TimeControl::kFastest);
}

TEST_F(Environment, LayersAreSwitched) {
  // Robot 1 looks at robot 2: its front sensor sits 20 mm left of its middle.
  EXPECT_TRUE(is_drawn_at(1.0, 0.52));
  QTest::keyClick(&*window_, Qt::Key_D);
  EXPECT_FALSE(window_->view().layers().distances);
  EXPECT_FALSE(is_drawn_at(1.0, 0.52));
  action("Trails").trigger();
  EXPECT_FALSE(window_->view().layers().trails);
}

TEST_F(Environment, RobotsLeaveTrails) {
  QTest::keyClick(&*window_, Qt::Key_D);
  ASSERT_TRUE(room_.robot().drive()->set_speed({0.2, 0.0}));
  for (int i = 0; i < 20; ++i) {
    room_.pass(0.1);
    window_->view().refresh();
  }
  EXPECT_TRUE(is_drawn_at(0.6, 0.5));
  QTest::keyClick(&*window_, Qt::Key_E);
  EXPECT_FALSE(is_drawn_at(0.6, 0.5));
}

TEST_F(Environment, CollisionsAreToldOnce) {
  auto* const events = window_->findChild<EventLog*>();
  ASSERT_TRUE(room_.robot().drive()->set_speed({0.4, 0.0}));
  room_.pass(4.0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return events->count() > 0; }));
  QTest::qWait(50);
  ASSERT_EQ(events->count(), 1);
  EXPECT_TRUE(events->item(0)->text().contains("robot 1 hit robot 2 at "))
      << events->item(0)->text().toStdString();
}

TEST_F(Environment, ACollisionWhileSomethingIsCarriedIsToldToo) {
  auto* const events = window_->findChild<EventLog*>();
  ASSERT_TRUE(room_.robot().drive()->set_speed({0.4, 0.0}));
  room_.pass(4.0);
  drag(at(1.0, 0.2), at(1.0, 0.3));  // looks at the world, too
  EXPECT_EQ(events->count(), 1);
}

TEST_F(Environment, ReadingsAreThoseOfTheChosenRobot) {
  auto* const readings = window_->findChild<Readings*>();
  window_->view().choose(1);
  ASSERT_TRUE(QTest::qWaitFor([&] { return readings->item(0, 1)->text() == "2 (S4)"; }));
  EXPECT_EQ(readings->item(1, 1)->text(), "1500  500 mm  180.0°");
}

TEST_F(Environment, APictureIsSavedOrNot) {
  const eyebridge::testing::ScratchFolder folder;
  const QString path = QString::fromStdString(folder.path() + "/room.png");
  EXPECT_TRUE(window_->save_picture(path));
  EXPECT_EQ(QImage(path).size(), window_->view().size());
  EXPECT_FALSE(window_->save_picture("/proc/room.png"));
}

TEST_F(Environment, FollowsTheChosenRobot) {
  window_->view().choose(1);
  QTest::keyClick(&*window_, Qt::Key_O);
  window_->view().refresh();
  const QPointF middle = QRectF(window_->view().rect()).center();
  EXPECT_LT(norm(window_->view().viewport().to_world(middle) - Vec2{1.5, 0.5}), 0.01);
}

}  // namespace
}  // namespace eyebridge::gui
