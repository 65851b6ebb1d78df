// What the environment's window has beside carrying and looking: measuring, driving, errors, films,
// 3D.
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QWheelEvent>
#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "album.hpp"
#include "environment_fixture.hpp"
#include "eyebridge/base/jumping_clock.hpp"
#include "eyebridge/camera/source.hpp"

namespace eyebridge::gui {
namespace {

class Tools : public testing::EnvironmentFixture {
 protected:
  QString trouble() { return window_->findChild<QLabel*>("trouble")->text(); }
  double psd_spread() {
    double least = 1e9;
    double most = 0.0;
    for (int i = 0; i < 50; ++i) {
      const double range = room_.robot().range_sensor(1)->read().value();
      least = std::min(least, range);
      most = std::max(most, range);
    }
    return most - least;
  }
  /// One that was begun after now.
  void wait_for_another_picture() {
    const int before = window_->scene().count();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window_->scene().count() > before; }, 60'000));
  }
  template <class Widget>
  Widget& child(const char* name) {
    auto* const found = window_->findChild<Widget*>(name);
    if (found == nullptr) throw std::runtime_error(std::string("no ") + name);
    return *found;
  }
};

TEST_F(Tools, TheTapeMeasuresAndTakesNothing) {
  QTest::keyClick(&*window_, Qt::Key_M);
  drag(at(0.5, 0.5), at(0.9, 0.8));
  ASSERT_TRUE(window_->view().tape().has_value());
  EXPECT_EQ(room_.pose(1), (Pose{0.5, 0.5, 0.0}));
  const Tape& tape = *window_->view().tape();
  EXPECT_NEAR(norm(tape.to - tape.from), 0.5, 0.005);
  EXPECT_EQ(tape_text({{0.5, 0.5}, {0.9, 0.8}}), "500 mm, 36.9°");
  EXPECT_TRUE(is_drawn_at(0.7, 0.65));
  QTest::keyClick(&*window_, Qt::Key_M);
  EXPECT_FALSE(window_->view().tape().has_value());
  drag(at(0.5, 0.5), at(0.6, 0.5));
  EXPECT_NEAR(room_.pose(1).x, 0.6, 0.005);
}

TEST_F(Tools, ArrowKeysDriveTheChosenRobotWhileTheyAreDown) {
  WorldView& view = window_->view();
  QTest::keyClick(&*window_, Qt::Key_N);  // robot 2
  QTest::keyPress(&view, Qt::Key_Up);
  room_.pass(0.2);
  EXPECT_EQ(room_.pose(2).x, 1.5) << "not before somebody wants it";
  QTest::keyRelease(&view, Qt::Key_Up);
  QTest::keyClick(&*window_, Qt::Key_K);
  QTest::keyPress(&view, Qt::Key_Up);
  room_.pass(1.0);
  EXPECT_LT(room_.pose(2).x, 1.4) << "it looks to the left";
  EXPECT_EQ(room_.pose(1).x, 0.5);
  QTest::keyRelease(&view, Qt::Key_Up);
  room_.pass(1.0);
  const Pose stopped = room_.pose(2);
  room_.pass(1.0);
  EXPECT_EQ(room_.pose(2), stopped);
  QTest::keyPress(&view, Qt::Key_Left);
  room_.pass(0.2);
  EXPECT_GT(wrap_angle(room_.pose(2).theta - kPi), 0.05);
  QTest::keyClick(&*window_, Qt::Key_K);  // and so it stops
  room_.pass(1.0);
  const Pose left = room_.pose(2);
  room_.pass(1.0);
  EXPECT_EQ(room_.pose(2), left);
}

TEST_F(Tools, WhoLooksAwayStopsDriving) {
  QTest::keyClick(&*window_, Qt::Key_K);
  QTest::keyPress(&window_->view(), Qt::Key_Up);
  room_.pass(0.2);
  EXPECT_GT(room_.pose(1).x, 0.505);
  window_->view().clearFocus();
  room_.pass(1.0);
  const Pose stopped = room_.pose(1);
  room_.pass(1.0);
  EXPECT_EQ(room_.pose(1), stopped);
}

TEST_F(Tools, AKeyThatIsReleasedStopsOnlyWhomItDrove) {
  QTest::keyClick(&*window_, Qt::Key_K);
  QTest::keyPress(&window_->view(), Qt::Key_Up);
  window_->view().choose(1);
  ASSERT_TRUE(room_.environment().drive(1, {0.1, 0.0}));  // its program
  QTest::keyRelease(&window_->view(), Qt::Key_Up);
  room_.pass(1.0);
  EXPECT_LT(room_.pose(2).x, 1.45) << "robot 2 goes on";
}

TEST_F(Tools, AFilmIsWholeWhenItsWindowIsClosed) {
  const eyebridge::testing::ScratchFolder folder;
  const std::string path = folder.path() + "/room.mp4";
  ASSERT_TRUE(window_->start_film(QString::fromStdString(path)));
  window_->close();
  JumpingClock clock;
  const auto source = camera::open_source("frames:" + path, {&clock, nullptr, nullptr});
  EXPECT_TRUE(source->next(clock.now() + std::chrono::seconds(1)));
}

TEST_F(Tools, ErrorsAreSetForAllAndForOne) {
  EXPECT_EQ(psd_spread(), 0.0);
  child<QDockWidget>("errors").show();
  auto& kind = child<QComboBox>("error_kind");
  kind.setFocus();
  QTest::keyClick(&kind, Qt::Key_End);  // harsh
  ASSERT_EQ(kind.currentText(), "harsh");
  const double harsh = psd_spread();
  EXPECT_GT(harsh, 0.0);
  auto& share = child<QSlider>("error_share");
  QTest::keyClick(&share, Qt::Key_Home);
  EXPECT_EQ(psd_spread(), 0.0);
  QTest::keyClick(&share, Qt::Key_End);
  EXPECT_GT(psd_spread(), 0.3 * harsh) << "shares do not add up";
  auto& target = child<QComboBox>("error_target");
  ASSERT_EQ(target.count(), 3);
  target.setCurrentIndex(1);
  EXPECT_EQ(kind.currentText(), "harsh");
  QTest::keyClick(&kind, Qt::Key_Home);  // as at the start
  EXPECT_EQ(psd_spread(), 0.0);
  target.setCurrentIndex(2);
  EXPECT_EQ(kind.currentText(), "harsh") << "robot 2 keeps its errors";
  EXPECT_EQ(trouble(), "");
}

TEST_F(Tools, AFilmHas25PicturesForASecondOfTheWorld) {
  const eyebridge::testing::ScratchFolder folder;
  const std::string path = folder.path() + "/room.mp4";
  ASSERT_TRUE(window_->start_film(QString::fromStdString(path)));
  ASSERT_TRUE(room_.robot().drive()->set_speed({0.2, 0.0}));
  for (int i = 0; i < 10; ++i) {
    room_.pass(0.1);
    const double now = 0.1 * (i + 1);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window_->view().look().scene.time > now - 0.001; }));
  }
  action("Film...").trigger();
  JumpingClock clock;
  const auto source = camera::open_source("frames:" + path, {&clock, nullptr, nullptr});
  EXPECT_EQ(source->natural_size().width, window_->view().width() & ~1);
  int count = 0;
  while (source->next(clock.now() + std::chrono::seconds(1))) ++count;
  EXPECT_EQ(count, 26);
}

TEST_F(Tools, AFilmThatCannotBeWrittenIsRefused) {
  EXPECT_FALSE(window_->start_film("/proc/room.mp4"));
  EXPECT_TRUE(trouble().startsWith("/proc/room.mp4: cannot be written")) << trouble().toStdString();
  EXPECT_FALSE(action("Film...").isChecked());
}

TEST_F(Tools, TheWorldIsSeenInThreeDimensions) {
  SceneView& scene = window_->scene();
  EXPECT_TRUE(scene.picture().isNull()) << "not drawn while nobody looks";
  QTest::keyClick(&*window_, Qt::Key_3);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !scene.picture().isNull(); }));
  child<QDockWidget>("scene").setFloating(true);
  child<QDockWidget>("scene").resize(480, 360);
  ASSERT_TRUE(QTest::qWaitFor([&] { return scene.picture().size() == scene.size(); }));
  EXPECT_TRUE(testing::looks_as(scene.picture(), "scene-free"));
}

TEST_F(Tools, TheEyeIsTurnedMovedAndBroughtNearer) {
  SceneView& scene = window_->scene();
  QTest::keyClick(&*window_, Qt::Key_3);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !scene.picture().isNull(); }));
  const Orbit before = scene.orbit();
  const QPoint middle = scene.rect().center();
  const auto drag_scene = [&](Qt::MouseButton button, QPoint way) {
    QTest::mousePress(&scene, button, {}, middle);
    QMouseEvent move(QEvent::MouseMove, middle + way, scene.mapToGlobal(middle + way), Qt::NoButton,
                     button, {});
    QApplication::sendEvent(&scene, &move);
    QTest::mouseRelease(&scene, button, {}, middle + way);
  };
  drag_scene(Qt::LeftButton, {50, -20});
  EXPECT_LT(scene.orbit().heading, before.heading);
  EXPECT_LT(scene.orbit().height, before.height);
  drag_scene(Qt::RightButton, {-30, 0});
  EXPECT_GT(scene.orbit().target.x, before.target.x);
  QWheelEvent wheel(middle, scene.mapToGlobal(QPointF(middle)), {}, {0, 120}, Qt::NoButton, {},
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(&scene, &wheel);
  EXPECT_LT(scene.orbit().distance, before.distance);
}

TEST_F(Tools, TheEyeIsTheRobots) {
  SceneView& scene = window_->scene();
  QTest::keyClick(&*window_, Qt::Key_3);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !scene.picture().isNull(); }));
  action("The robot's camera").trigger();
  child<QDockWidget>("scene").setFloating(true);
  child<QDockWidget>("scene").resize(480, 360);
  ASSERT_TRUE(QTest::qWaitFor([&] { return scene.picture().size() == scene.size(); }));
  wait_for_another_picture();
  EXPECT_TRUE(testing::looks_as(scene.picture(), "scene-robot"));
  action("Behind the robot").trigger();
  wait_for_another_picture();
  EXPECT_TRUE(testing::looks_as(scene.picture(), "scene-behind"));
}

TEST(Orbit, StaysAboveTheFloorAndBelowTheTop) {
  Orbit orbit;
  orbit.turn(0.0, 10.0);
  EXPECT_LT(orbit.height, kPi / 2);
  orbit.turn(0.0, -10.0);
  EXPECT_GT(orbit.eye().z, 0.0);
  orbit.move_away(1e9);
  EXPECT_EQ(orbit.distance, Orbit::kFarthest);
  orbit.move_away(1e-9);
  EXPECT_EQ(orbit.distance, Orbit::kNearest);
}

TEST_F(Tools, ARobotIsAskedForWhereThePersonShows) {
  QTest::keyClick(&*window_, Qt::Key_A);
  auto& program = child<QLineEdit>("add_program");
  ASSERT_TRUE(QTest::qWaitFor([&] { return program.isVisible(); }));
  EXPECT_EQ(child<QComboBox>("add_model").currentText(), "S4");
  child<QComboBox>("add_model").setEditText("LabBot");
  QTest::keyClicks(&program, "./prog 3 \"two words\"");
  QTest::mouseClick(&child<QPushButton>("add_place"), Qt::LeftButton);
  window_->view().fit();
  drag(at(1.0, 0.7), at(1.0, 0.9));
  ASSERT_TRUE(QTest::qWaitFor([&] { return trouble() == "the run has ended"; }));
  const std::lock_guard lock(crew_.mutex);
  ASSERT_EQ(crew_.words.size(), 7U);
  EXPECT_EQ(crew_.words[0], "LabBot");
  EXPECT_NEAR(std::stod(crew_.words[1]), 1000.0, 5.0);
  EXPECT_NEAR(std::stod(crew_.words[2]), 700.0, 5.0);
  EXPECT_NEAR(std::stod(crew_.words[3]), 90.0, 1.0);
  EXPECT_EQ(crew_.words[4], "./prog");
  EXPECT_EQ(crew_.words[6], "two words");
  QTest::keyClick(&*window_, Qt::Key_M);
  EXPECT_FALSE(child<QPushButton>("add_place").isChecked()) << "one tool at a time";
}

TEST(AddRobot, IsNotOfferedWhereARunHasOne) {
  testing::Room room;
  EnvironmentWindow window(room.environment(), "square");
  EXPECT_FALSE(window.findChild<QPushButton*>("add_place")->isEnabled());
}

TEST(FloorTexture, IsDrawnWithItsUpperEdgeAtTheWorlds) {
  testing::Room room("floor_texture floor.png\n");
  QImage picture(2, 2, QImage::Format_RGB888);
  picture.fill(Qt::red);
  picture.setPixelColor(0, 1, Qt::blue);
  ASSERT_TRUE(picture.save(QString::fromStdString(room.folder() + "/floor.png")));
  WorldView view(room.environment(), nullptr);
  view.resize(400, 200);
  EXPECT_EQ(view.missing(), "");
  const QImage seen = view.grab().toImage();
  const auto colour = [&](double x, double y) {
    return seen.pixelColor(view.viewport().to_pixel({x, y}).toPoint());
  };
  EXPECT_EQ(colour(0.2, 0.2), QColor(Qt::blue));
  EXPECT_EQ(colour(0.2, 0.8), QColor(Qt::red));
  EXPECT_EQ(colour(1.8, 0.2), QColor(Qt::red));
}

TEST(FloorTexture, IsMissedInWords) {
  testing::Room room("floor_texture floor.png\n");
  EnvironmentWindow window(room.environment(), "square");
  const QString told = window.findChild<QLabel*>("trouble")->text();
  EXPECT_TRUE(told.contains(QString::fromStdString(room.folder()) + "/floor.png cannot be read"))
      << told.toStdString();
}

TEST_F(Tools, TheWholeWindowLooksAsReviewed) {
  ASSERT_TRUE(room_.robot().drive()->set_speed({0.1, 0.8}));
  for (int i = 0; i < 20; ++i) {
    room_.pass(0.1);
    window_->view().refresh();
  }
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return window_->findChild<Readings*>()->item(1, 1)->text() != "500  500 mm  0.0°"; }));
  EXPECT_TRUE(testing::looks_as(window_->grab().toImage(), "environment"));
}

}  // namespace
}  // namespace eyebridge::gui
