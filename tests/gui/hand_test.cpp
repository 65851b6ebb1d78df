// The view for a person who carries the camera.
#include <QAction>
#include <QPainter>
#include <QSettings>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <mutex>

#include <gtest/gtest.h>

#include "album.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/convert.hpp"
#include "eyebridge/hal/backend.hpp"
#include "eyebridge/hal/registry.hpp"
#include "hand/hand_window.hpp"
#include "hand/uncertainty.hpp"
#include "run_program.hpp"

namespace eyebridge::gui {
namespace {

using InstructionKind = hal::Instruction::Kind;

/// Tells what the test wants.
class ScriptedGuide final : public hal::HandGuide {
 public:
  [[nodiscard]] hal::HandLook look() const override {
    const std::lock_guard lock(mutex_);
    return look_;
  }
  void tell(const hal::HandLook& look) {
    const std::lock_guard lock(mutex_);
    look_ = look;
  }

 private:
  mutable std::mutex mutex_;
  hal::HandLook look_;
};

hal::Instruction goal(double distance, double angle, double linear, double angular) {
  hal::Instruction instruction;
  instruction.kind = InstructionKind::Goal;
  instruction.distance = distance;
  instruction.angle = angle;
  instruction.speed = {linear, angular};
  return instruction;
}

class HandView : public ::testing::Test {
 protected:
  void SetUp() override {
    QSettings().clear();
    window_.emplace(robios::HandStart{"maze – robot", &guide_, &frames_});
    window_->resize(1100, 640);
    window_->show();
    window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&*window_));
  }
  void tell(const hal::Instruction& instruction) {
    look_.instruction = instruction;
    tell();
  }
  void tell() {
    guide_.tell(look_);
    const HandWords wanted = words_for(look_.instruction);
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return window_->sign().words().headline == wanted.headline; }));
  }
  static camera::FramePtr grey_frame() {
    camera::Frame frame = camera::make_frame(320, 240, camera::PixelFormat::Rgb24);
    std::ranges::fill(frame.bytes, std::uint8_t{120});
    return std::make_shared<const camera::Frame>(std::move(frame));
  }

  ScriptedGuide guide_;
  hal::HandLook look_;
  camera::LatestFrame frames_;
  std::optional<HandWindow> window_;
};

TEST(HandWords, TellWayDistanceAndSpeed) {
  HandWords words = words_for(goal(0.42, 0.0, 0.2, 0.0));
  EXPECT_EQ(words.arrow, camera::Arrow::Forward);
  EXPECT_EQ(words.headline, "420 mm");
  EXPECT_EQ(words.detail, "Straight ahead");
  EXPECT_EQ(words.speed, "200 mm/s");
  words = words_for(goal(0.0, deg_to_rad(-85), 0.0, deg_to_rad(45)));
  EXPECT_EQ(words.arrow, camera::Arrow::TurnRight);
  EXPECT_EQ(words.headline, "85°");
  EXPECT_EQ(words.detail, "Turn right");
  EXPECT_EQ(words.speed, "45°/s");
  words = words_for(goal(0.3, deg_to_rad(30), 0.1, 0.0));
  EXPECT_EQ(words.arrow, camera::Arrow::CurveLeft);
  EXPECT_EQ(words.headline, "300 mm, 30°");
  words = words_for(goal(-0.3, deg_to_rad(30), 0.1, 0.0));
  EXPECT_EQ(words.arrow, camera::Arrow::BackRight)
      << "backward, a left turn of the heading goes to the right";

  hal::Instruction instruction;
  EXPECT_EQ(words_for(instruction).headline, "Stand still");
  instruction.kind = InstructionKind::Speed;
  instruction.speed = {-0.15, 0.0};
  EXPECT_EQ(words_for(instruction).arrow, camera::Arrow::Backward);
  EXPECT_EQ(words_for(instruction).headline, "150 mm/s");
  instruction.kind = InstructionKind::Lost;
  instruction.reason = "the camera has seen no marker yet";
  EXPECT_EQ(words_for(instruction).arrow, camera::Arrow::Lost);
  EXPECT_EQ(words_for(instruction).detail, "the camera has seen no marker yet");
}

TEST_F(HandView, CanBeReadFromTwoMetres) {
  tell(goal(1.234, deg_to_rad(30), 0.2, 0.0));
  // A minute of arc a stroke, five strokes a letter: 3 mm at 2 m, 12 pixels of 0.26 mm. Four times
  // that for somebody who walks.
  EXPECT_GE(window_->sign().letter_height(), 48);
  tell(goal(0.42, 0.0, 0.2, 0.0));
  const int before = window_->sign().letter_height();
  window_->resize(1100, 900);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window_->sign().letter_height() > before; }));
}

TEST_F(HandView, TheArrowPointsWhereToGo) {
  // Which half of the sign has more ink.
  const auto ink = [&](const QRect& part) {
    const QImage picture = window_->sign().grab(part).toImage();
    const QColor paper = picture.pixelColor(0, 0);
    int count = 0;
    for (int y = 0; y < picture.height(); y += 2) {
      for (int x = 0; x < picture.width(); x += 2) count += picture.pixelColor(x, y) != paper;
    }
    return count;
  };
  const QSize size = window_->sign().size();
  const int arrow = size.height() / 4;  // its upper half: where it points
  const QRect left(0, 0, size.width() / 2, arrow);
  const QRect right(size.width() / 2, 0, size.width() / 2, arrow);
  tell(goal(0.3, 0.5, 0.1, 0.0));
  QTest::qWait(0);
  const int left_curve = ink(left) - ink(right);
  tell(goal(0.3, -0.6, 0.1, 0.0));
  const int right_curve = ink(left) - ink(right);
  EXPECT_GT(left_curve, 80);
  EXPECT_LT(right_curve, -80);
  tell(goal(0.5, 0.0, 0.1, 0.0));
  EXPECT_LT(std::abs(ink(left) - ink(right)), 30) << "straight ahead has no side";
}

TEST_F(HandView, ShowsThePictureWithAFrameRoundEachMarker) {
  look_.has_markers = true;
  look_.frame = grey_frame();
  look_.markers = {{42, {Vec2{100, 60}, Vec2{180, 60}, Vec2{180, 140}, Vec2{100, 140}}}};
  tell(goal(0.42, 0.0, 0.2, 0.0));
  MarkerView& view = window_->camera();
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.markers().size() == 1; }));
  const auto colour_at = [&](Vec2 pixel) {
    return view.grab().toImage().pixelColor(view.place_of(pixel).toPoint());
  };
  EXPECT_EQ(colour_at({140, 60}), QColor(230, 0, 180)) << "its upper edge";
  EXPECT_EQ(colour_at({20, 20}), QColor(120, 120, 120));
  QTest::keyClick(&*window_, Qt::Key_M);
  EXPECT_EQ(colour_at({140, 60}), QColor(120, 120, 120)) << "switched off";
}

TEST_F(HandView, LooksAsReviewed) {
  look_.has_markers = true;
  look_.frame = grey_frame();
  look_.markers = {{42, {Vec2{100, 60}, Vec2{180, 70}, Vec2{180, 140}, Vec2{100, 150}}}};
  look_.pose = Pose{1.2, 0.35, deg_to_rad(45)};
  tell(goal(0.42, deg_to_rad(30), 0.2, 0.0));
  ASSERT_TRUE(QTest::qWaitFor([&] { return window_->place_text().startsWith("x 1200"); }));
  QTest::qWait(0);
  EXPECT_TRUE(testing::looks_as(window_->grab().toImage(), "hand"));
}

TEST_F(HandView, TellsThePoseAndHowSureItIs) {
  look_.has_markers = true;
  tell(goal(0.42, 0.0, 0.2, 0.0));
  EXPECT_EQ(window_->place_text(), "Nobody knows where the robot is");
  look_.pose = Pose{1.2, 0.35, deg_to_rad(45)};
  look_.covariance = {2.25e-6, 0, 0, 0, 1e-6, 0, 0, 0, std::pow(deg_to_rad(0.25), 2)};
  tell();
  EXPECT_TRUE(QTest::qWaitFor([&] {
    return window_->place_text() == "x 1200 ± 3 mm, y 350 ± 2 mm, 45.0 ± 0.5°";
  })) << window_->place_text().toStdString();
}

TEST_F(HandView, WithoutMarkersShowsWhatTheProgramSees) {
  frames_.set(grey_frame());
  tell(goal(0.1, 0.0, 0.2, 0.0));
  ASSERT_TRUE(QTest::qWaitFor([&] { return window_->camera().picture().width() == 320; }));
  EXPECT_TRUE(window_->camera().markers().empty());
  EXPECT_EQ(window_->place_text(), "Without markers: go as the sign says");
}

TEST_F(HandView, IsSavedAndSaysSoWhenItCannotBe) {
  const eyebridge::testing::ScratchFolder folder;
  const QString path = QString::fromStdString(folder.path() + "/hand.png");
  EXPECT_TRUE(window_->save_window(path));
  EXPECT_EQ(QImage(path).size(), window_->size());
  EXPECT_FALSE(window_->save_window("/nowhere/hand.png"));
}

TEST_F(HandView, SaysThatTheRunHasEnded) {
  window_->tell_end("The program has ended with 0");
  EXPECT_EQ(window_->sign().words().headline, "The run has ended");
  look_.instruction = goal(0.1, 0.0, 0.2, 0.0);
  guide_.tell(look_);
  // Who looks on sees it, and once more: as often would this window, had it not ended.
  HandWindow other(robios::HandStart{"other", &guide_, &frames_});
  for (const double distance : {0.2, 0.3}) {
    look_.instruction = goal(distance, 0.0, 0.2, 0.0);
    guide_.tell(look_);
    const QString headline = words_for(look_.instruction).headline;
    ASSERT_TRUE(QTest::qWaitFor([&] { return other.sign().words().headline == headline; }));
  }
  EXPECT_EQ(window_->sign().words().headline, "The run has ended");
}

TEST(Uncertainty, IsAnEllipseAlongTheDoubt) {
  // 2 mm along 30 deg, 1 mm across.
  const double c = std::cos(deg_to_rad(30));
  const double s = std::sin(deg_to_rad(30));
  const double a = 4e-6;
  const double b = 1e-6;
  const PoseCovariance covariance{a * c * c + b * s * s,
                                  (a - b) * c * s,
                                  0,
                                  (a - b) * c * s,
                                  a * s * s + b * c * c,
                                  0,
                                  0,
                                  0,
                                  0};
  const UncertaintyEllipse ellipse = ellipse_of(covariance);
  EXPECT_NEAR(ellipse.major, 2.4477 * 2e-3, 1e-9);
  EXPECT_NEAR(ellipse.minor, 2.4477 * 1e-3, 1e-9);
  EXPECT_NEAR(ellipse.heading, deg_to_rad(30), 1e-9);
  EXPECT_EQ(ellipse_of({NAN, 0, 0, 0, 1, 0, 0, 0, 0}).major, 0.0);
  EXPECT_EQ(ellipse_of({-1, 0, 0, 0, 1, 0, 0, 0, 0}).major, 0.0);
}

TEST(Uncertainty, IsDrawnRoundThePose) {
  Viewport view;
  view.resize({400, 400});
  view.fit({}, {2.0, 2.0});
  QImage picture(400, 400, QImage::Format_RGB32);
  picture.fill(Qt::white);
  QPainter painter(&picture);
  // 5 cm across the view, 1 cm along: 95 % are within 12 and 2.4 cm.
  paint_uncertainty(painter, view, {1.0, 1.0, 0.0}, {2.5e-3, 0, 0, 0, 1e-4, 0, 0, 0, 1e-4});
  painter.end();
  const auto is_drawn = [&](double x, double y) {
    return picture.pixelColor(view.to_pixel({x, y}).toPoint()) != QColor(Qt::white);
  };
  EXPECT_TRUE(is_drawn(1.0, 1.0));
  EXPECT_TRUE(is_drawn(0.9, 1.0));
  EXPECT_FALSE(is_drawn(0.86, 1.0));
  EXPECT_FALSE(is_drawn(1.0, 1.06));
  EXPECT_TRUE(is_drawn(1.2, 1.0)) << "the wedge of headings";
}

/// A film of a marked room, which the person's camera shows again.
TEST(HandFilm, MarkersAreFoundAndThePoseIsKnown) {
  const eyebridge::testing::ScratchFolder folder;
  folder.write("films.c", R"(
#include <eyebot.h>
static BYTE frame[VGA_SIZE];
int main(void) {
  CAMInit(VGA);
  VWSetSpeed(0, 30);
  for (int i = 0; i < 60; i++) CAMGet(frame);
  return 0;
})");
  const std::string world = EYEBRIDGE_SOURCE_DIR "/worlds/empty-room.wld";
  const auto run = [&](const std::vector<std::string>& words) {
    const auto done = eyebridge::testing::run_program({words, {}, folder.path()});
    ASSERT_EQ(done.exit_code, 0) << done.err;
  };
  run({EYEBRIDGE_BIN "/eyebridge-cc", "films.c", "-o", "films"});
  run({EYEBRIDGE_BIN "/eyebridge", "run", "--fast", "--world", world, "--camera",
       "render:?fiducials=on", "--record", "walk.ebrec", "./films"});

  struct Silence final : LogSink {
    void write(Severity, std::string_view) override {}
  } log;
  const hal::Config config =
      hal::Config::load({{{"world", world},
                          {"fast", "true"},
                          {"camera", "frames:" + folder.path() + "/walk.ebrec"},
                          {"drive", "hand?fov=60"}},
                         {},
                         {}});
  const std::unique_ptr<hal::Backend> robot = hal::open_backend({config, log});
  ASSERT_NE(robot->hand_guide(), nullptr);
  QSettings().clear();
  HandWindow window({"film – robot", robot->hand_guide(), nullptr});
  window.show();
  robot->clock().wait_until(from_seconds(1.0));
  ASSERT_TRUE(robot->drive()->start({0.3, 0.0, 0.1}));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window.camera().markers().empty(); }));
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.sign().words().headline == "300 mm"; }))
      << window.sign().words().headline.toStdString();
  EXPECT_EQ(window.camera().picture().size(), QSize(640, 480));
  const hal::HandLook look = robot->hand_guide()->look();
  ASSERT_TRUE(look.pose);
  EXPECT_NEAR(look.pose->x, 1.0, 0.02);
  EXPECT_NEAR(look.pose->y, 1.0, 0.02);
  EXPECT_GT(ellipse_of(look.covariance).major, 0.0);
  EXPECT_LT(ellipse_of(look.covariance).major, 0.1);
  EXPECT_TRUE(window.place_text().startsWith("x ")) << window.place_text().toStdString();
}

}  // namespace
}  // namespace eyebridge::gui
