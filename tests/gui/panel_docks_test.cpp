// Camera, loudspeaker, remote control and inspector of the panel, as a person uses them.
#include <QAction>
#include <QDockWidget>
#include <QSettings>
#include <QTest>
#include <QThread>
#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "album.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/convert.hpp"
#include "eyebridge/hal/device_notes.hpp"
#include "keys.hpp"
#include "lcd.hpp"
#include "panel/panel_window.hpp"
#include "room.hpp"
#include "run_program.hpp"

namespace eyebridge::gui {
namespace {

/// A panel of robot 1 of the room, whose program is the test.
class PanelDocks : public ::testing::Test {
 protected:
  void SetUp() override {
    QSettings().clear();
    hal::NotedBackend noted = hal::with_notes(room_.take_robot());
    robot_ = std::move(noted.backend);
    notes_ = std::move(noted.notes);
    keys_ = std::make_unique<robios::Keys>(robot_->clock(), std::vector<robios::ScriptedKey>{},
                                           nullptr);
    show();
  }
  void show() {
    panel_.reset();
    panel_.emplace(robios::PanelStart{"docks – robot", &lcd_, keys_.get(), &frames_, notes_.get()});
    panel_->show();
    panel_->activateWindow();  // shortcuts are those of the active window
    ASSERT_TRUE(QTest::qWaitForWindowActive(&*panel_));
  }
  void TearDown() override { panel_.reset(); }

  QDockWidget& dock(const char* name) { return *panel_->findChild<QDockWidget*>(name); }
  void raise(const char* name) {
    dock(name).show();
    dock(name).raise();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !dock(name).visibleRegion().isEmpty(); }));
  }
  QString shown(const QString& path, Inspector::Column column = Inspector::kValue) {
    const QTreeWidgetItem* const item = panel_->inspector()->find(path);
    return item == nullptr ? "no " + path : item->text(column);
  }
  bool shows(const QString& path, const QString& text) {
    const bool comes = QTest::qWaitFor([&] { return shown(path) == text; }, 30'000);
    EXPECT_TRUE(comes) << path.toStdString() << " is " << shown(path).toStdString();
    return comes;
  }
  camera::FramePtr frame(int width, int height, Time time) {
    camera::Frame frame = camera::make_frame(width, height, camera::PixelFormat::Rgb24);
    for (std::size_t i = 0; i < frame.bytes.size(); ++i) {
      frame.bytes[i] = static_cast<std::uint8_t>(7 * i + i / 300);
    }
    frame.time = time;
    return std::make_shared<const camera::Frame>(std::move(frame));
  }

  testing::Room room_;
  std::unique_ptr<hal::Backend> robot_;
  std::shared_ptr<hal::DeviceNotes> notes_;
  camera::LatestFrame frames_;
  robios::Lcd lcd_;
  std::unique_ptr<robios::Keys> keys_;
  std::optional<PanelWindow> panel_;
};

TEST_F(PanelDocks, TheCameraSaysThatThereIsNoPictureThenShowsItPixelForPixel) {
  EXPECT_TRUE(panel_->camera()->picture().isNull());
  EXPECT_TRUE(panel_->camera()->caption().contains("taken no picture"));
  const camera::FramePtr taken = frame(80, 60, from_seconds(1.25));
  frames_.set(taken);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !panel_->camera()->picture().isNull(); }));
  EXPECT_TRUE(panel_->camera()->caption().contains("80 × 60, at 1.25 s"));
  CameraView& view = *panel_->camera();
  view.setFixedSize(170, 160);
  QTest::qWait(0);
  const QImage picture = view.grab().toImage();
  for (const QPoint pixel : {QPoint(0, 0), QPoint(79, 0), QPoint(40, 30), QPoint(79, 59)}) {
    const std::uint8_t* const rgb = taken->row(pixel.y()).data() + 3 * pixel.x();
    const QPoint corner(5 + 2 * pixel.x(), 20 + 2 * pixel.y());
    for (const QPoint part : {QPoint(0, 0), QPoint(1, 1)}) {
      EXPECT_EQ(picture.pixelColor(corner + part), QColor(rgb[0], rgb[1], rgb[2]))
          << pixel.x() << ", " << pixel.y();
    }
  }
}

TEST_F(PanelDocks, APictureThatIsTooLargeIsShownByAWholeFraction) {
  frames_.set(frame(640, 480, Time(0)));
  panel_->camera()->setFixedSize(330, 250);
  ASSERT_TRUE(QTest::qWaitFor([&] { return panel_->camera()->caption().contains("× 1/2"); }));
}

TEST_F(PanelDocks, LookingAtTheCameraTakesNoPictureAndKeepsTimeStill) {
  const Time before = robot_->clock().now();
  frames_.set(frame(4, 3, Time(0)));
  const auto shows_it = [&] { return panel_->camera()->caption().contains("4 × 3"); };
  ASSERT_TRUE(QTest::qWaitFor(shows_it, 30'000)) << panel_->camera()->caption().toStdString();
  EXPECT_EQ(robot_->clock().now(), before);
  for (const hal::NotedValue& value : notes_->values()) {
    EXPECT_EQ(value.cell.get().value().count, 0U) << value.kind << ": nobody has called it";
  }
}

TEST_F(PanelDocks, TheRemoteControlSendsCodesByMouse) {
  raise("remote");
  for (const RemoteButton& button : remote_buttons()) {
    QTest::mouseClick(&panel_->remote().button(button.code), Qt::LeftButton);
    EXPECT_EQ(keys_->read_remote(), button.code) << button.name;
  }
  EXPECT_EQ(keys_->read_remote(), 0);
  EXPECT_TRUE(shows("Keys/remote control", "'D'"));
}

TEST_F(PanelDocks, TheRemoteControlSendsCodesByItsShortcutsWhereverItIs) {
  dock("remote").hide();
  for (const RemoteButton& button : remote_buttons()) {
    QTest::keySequence(&*panel_, QKeySequence(button.shortcut));
    EXPECT_EQ(keys_->read_remote(), button.code) << button.name;
  }
}

TEST_F(PanelDocks, AProgramThatWaitsInVirtualTimeGetsTheButton) {
  raise("remote");
  const Time before = robot_->clock().now();
  std::atomic<int> code = 0;
  std::thread program([&] {
    code = keys_->wait_remote([&](Time until) { robot_->clock().wait_until(until); }).value_or(-1);
  });
  QTest::mouseClick(&panel_->remote().button('5'), Qt::LeftButton);
  EXPECT_TRUE(QTest::qWaitFor([&] { return code != 0; }, 60'000));
  keys_->set_window(false);  // so that it ends in any case
  program.join();
  EXPECT_EQ(code, '5');
  EXPECT_EQ(robot_->clock().now(), before) << "time stands still while a person is waited for";
}

TEST_F(PanelDocks, SoftKeysAreTypedWhateverHasTheFocus) {
  panel_->inspector()->setFocus();
  QTest::keyClick(panel_->inspector(), Qt::Key_2);
  EXPECT_EQ(keys_->read(), 2);
  QTest::keyClick(panel_->inspector(), Qt::Key_F4);
  EXPECT_EQ(keys_->read(), 8);
  raise("remote");
  panel_->remote().button('7').setFocus();
  QTest::keyClick(&panel_->remote().button('7'), Qt::Key_3);
  EXPECT_EQ(keys_->read(), 4);
  EXPECT_EQ(keys_->read_remote(), 0) << "a digit is a soft key, Alt and a digit the remote control";
  dock("remote").setFloating(true);
  QTest::keyClick(&panel_->remote().button('7'), Qt::Key_1);
  EXPECT_EQ(keys_->read(), 1);
}

TEST_F(PanelDocks, TheInspectorShowsWhatTheProgramReadAndWrote) {
  EXPECT_EQ(shown("Distance sensors (PSD)/PSD_FRONT (1)"), "–");
  robot_->clock().wait_until(from_seconds(2.0));
  const double front = robot_->range_sensor(1)->read().value();
  EXPECT_TRUE(shows("Distance sensors (PSD)/PSD_FRONT (1)", QString::number(qRound(1000 * front))));
  EXPECT_EQ(shown("Distance sensors (PSD)/PSD_FRONT (1)", Inspector::kUnit), "mm");
  EXPECT_EQ(shown("Distance sensors (PSD)/PSD_FRONT (1)", Inspector::kTime), "2.00 s");
  EXPECT_EQ(shown("Distance sensors (PSD)/PSD_LEFT (2)"), "–") << "nobody has asked it";

  ASSERT_TRUE(robot_->drive()->set_speed({0.2, deg_to_rad(-30)}));
  EXPECT_TRUE(shows("Drive/speed set", "200"));
  EXPECT_TRUE(shows("Drive/turning set", "-30.0"));
  ASSERT_TRUE(robot_->drive()->set_odometry({0.123, -0.2, deg_to_rad(90)}));
  EXPECT_TRUE(shows("Drive/x", "123"));
  EXPECT_TRUE(shows("Drive/heading", "90.0"));
  ASSERT_TRUE(robot_->servo(1)->set(1.0));
  EXPECT_TRUE(shows("Servos/1", "255"));
  robot_->clock().wait_until(from_seconds(3.0));
  ASSERT_TRUE(robot_->gyroscope()->read());
  EXPECT_TRUE(shows("Gyroscope/turning", "-30.0"));
  ASSERT_TRUE(robot_->accelerometer()->read());
  EXPECT_TRUE(shows("Accelerometer/left", "-105"));
  EXPECT_EQ(shown("Accelerometer/left", Inspector::kUnit), "mm/s²");
  ASSERT_TRUE(robot_->digital()->write(9, true));
  EXPECT_TRUE(shows("Digital lines/line 9 written", "1"));
  ASSERT_TRUE(robot_->motor(1)->set_duty(0.5));
  EXPECT_TRUE(shows("Motors/1", "50"));
  keys_->press(4);
  EXPECT_EQ(keys_->read(), 4);
  EXPECT_TRUE(shows("Keys/key", "KEY3"));
}

TEST_F(PanelDocks, RowsOfRareCallsComeWithTheirFirstCall) {
  const QTreeWidgetItem* const goal = panel_->inspector()->find("Drive/goal: way");
  ASSERT_NE(goal, nullptr);
  EXPECT_TRUE(goal->isHidden());
  ASSERT_TRUE(robot_->drive()->start({0.0, deg_to_rad(90), deg_to_rad(45)}));
  EXPECT_TRUE(shows("Drive/goal: angle", "90.0"));
  EXPECT_TRUE(shows("Drive/goal: speed", "45 °/s"));
  EXPECT_FALSE(goal->isHidden());
}

TEST_F(PanelDocks, TheSpeakerLightsWhileAToneLasts) {
  Speaker& speaker = *panel_->speaker();
  EXPECT_FALSE(speaker.is_lit());
  hal::SoundNote tone;
  tone.frequency = 880;
  tone.length = 3.0;
  notes_->put_sound(tone);
  ASSERT_TRUE(QTest::qWaitFor([&] { return speaker.is_lit(); }));
  EXPECT_EQ(speaker.text(), "880 Hz, 3.00 s");
  QTest::qWait(600);
  EXPECT_TRUE(speaker.is_lit()) << "the robot's time stands still: it plays on";
  robot_->clock().wait_until(robot_->clock().now() + from_seconds(3.1));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !speaker.is_lit(); }));
  EXPECT_EQ(speaker.text(), "880 Hz, 3.00 s") << "to be read";
}

TEST_F(PanelDocks, AShortBeepIsSeenEvenWhenTimeIsFast) {
  hal::SoundNote beep;
  beep.frequency = 1000;
  beep.length = 0.1;
  notes_->put_sound(beep);
  robot_->clock().wait_until(robot_->clock().now() + from_seconds(60));
  ASSERT_TRUE(QTest::qWaitFor([&] { return panel_->speaker()->is_lit(); }));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !panel_->speaker()->is_lit(); }));
}

TEST_F(PanelDocks, TheSpeakerTellsAFileAndItsLength) {
  const eyebridge::testing::ScratchFolder folder;
  std::string wav = "RIFF    WAVEfmt ";
  const auto put = [&wav](std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) wav += static_cast<char>(value >> (8 * i));
  };
  put(16, 4);  // the length of what says: PCM, one channel,
  put(1, 2);
  put(1, 2);
  put(8000, 4);  // of so many bytes a second, one at a time, of 8 bits
  put(8000, 4);
  put(1, 2);
  put(8, 2);
  wav += "data";
  put(4000, 4);
  wav += std::string(4000, '\x80');
  hal::SoundNote sound;
  sound.file = folder.write("horn.wav", wav);
  notes_->put_sound(sound);
  Speaker& speaker = *panel_->speaker();
  speaker.refresh();
  EXPECT_TRUE(speaker.is_lit());
  EXPECT_EQ(speaker.text(), "horn.wav") << "the file is read by somebody else";
  EXPECT_TRUE(QTest::qWaitFor([&] { return speaker.text() == "horn.wav, 0.50 s"; }, 60'000));
  EXPECT_TRUE(speaker.is_lit()) << "the robot's time stands still: it plays on";
  robot_->clock().wait_until(robot_->clock().now() + from_seconds(0.6));
  EXPECT_TRUE(QTest::qWaitFor([&] { return !speaker.is_lit(); }, 60'000));
}

TEST_F(PanelDocks, TheScreenIsSavedPixelForPixel) {
  const eyebridge::testing::ScratchFolder folder;
  lcd_.area(10, 20, 30, 40, {200, 0, 0}, true);
  const QString path = QString::fromStdString(folder.path() + "/screen.png");
  ASSERT_TRUE(panel_->save_screen(path));
  const QImage saved(path);
  EXPECT_EQ(saved.size(), QSize(robios::Lcd::kDefaultWidth, robios::Lcd::kDefaultHeight));
  EXPECT_EQ(saved.pixelColor(15, 25), QColor(200, 0, 0));
  EXPECT_FALSE(panel_->save_screen("/nowhere/screen.png"));
  EXPECT_TRUE(panel_->findChild<QLabel*>("told")->text().contains("/nowhere/screen.png"));
}

TEST_F(PanelDocks, AreSwitchedByTheirKeysAndRemembered) {
  ASSERT_TRUE(dock("camera").isVisible());
  QTest::keyClick(&*panel_, Qt::Key_F5);
  EXPECT_FALSE(dock("camera").isVisible());
  show();
  EXPECT_FALSE(dock("camera").isVisible());
  EXPECT_TRUE(dock("inspector").isVisible());
  QTest::keyClick(&*panel_, Qt::Key_F5);
  EXPECT_TRUE(dock("camera").isVisible());
}

TEST_F(PanelDocks, LookAsReviewed) {
  lcd_.set_menu({"GO", "", "", "END"});
  lcd_.area(10, 20, 200, 120, {200, 0, 0}, true);
  robot_->clock().wait_until(from_seconds(2.0));
  ASSERT_TRUE(robot_->range_sensor(1)->read());
  ASSERT_TRUE(robot_->drive()->set_speed({0.2, 0.1}));
  ASSERT_TRUE(robot_->drive()->odometry());
  frames_.set(frame(160, 120, from_seconds(1.5)));
  EXPECT_TRUE(shows("Drive/speed set", "200"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !panel_->camera()->picture().isNull(); }));
  EXPECT_TRUE(testing::looks_as(panel_->grab().toImage(), "panel"));
  raise("remote");
  EXPECT_TRUE(testing::looks_as(panel_->remote().grab().toImage(), "remote_control"));
}

TEST_F(PanelDocks, NothingIsSentWhenTheProgramHasEnded) {
  raise("remote");
  panel_->tell_end("The program has ended (0)");
  QTest::mouseClick(&panel_->remote().button('5'), Qt::LeftButton);
  QTest::keyClick(&*panel_, Qt::Key_1);
  QTest::keySequence(&*panel_, QKeySequence("Alt+5"));
  EXPECT_EQ(keys_->read_remote(), 0);
  EXPECT_EQ(keys_->read(), 0);
}

}  // namespace
}  // namespace eyebridge::gui
