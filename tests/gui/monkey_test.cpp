// Somebody who clicks and types at random, in all windows at once: nothing crashes, nothing leaks
// (ASan). EYEBRIDGE_TEST_MONKEY_ACTS: how often, or EYEBRIDGE_TEST_MONKEY_SECONDS: for how long;
// EYEBRIDGE_TEST_MONKEY_SEED: another somebody.
#include "monkey.hpp"

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QSettings>
#include <QTimer>
#include <algorithm>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "editor/editor_window.hpp"
#include "environment/environment_window.hpp"
#include "eyebridge/camera/convert.hpp"
#include "eyebridge/hal/device_notes.hpp"
#include "eyebridge/hal/hand_guide.hpp"
#include "eyebridge/mapping/occupancy_grid.hpp"
#include "eyebridge/mapping/picture.hpp"
#include "hand/hand_window.hpp"
#include "keys.hpp"
#include "lcd.hpp"
#include "panel/panel_window.hpp"
#include "room.hpp"
#include "windows/map_board.hpp"
#ifdef EYEBRIDGE_HAVE_CODE_PANEL
#include "code/code_window.hpp"
#endif

namespace eyebridge::gui {
namespace {

int number_of(const char* variable, int otherwise) {
  const char* const text = std::getenv(variable);
  return text == nullptr ? otherwise : std::atoi(text);
}

camera::FramePtr a_frame(int grey) {
  camera::Frame frame = camera::make_frame(160, 120, camera::PixelFormat::Rgb24);
  std::ranges::fill(frame.bytes, static_cast<std::uint8_t>(grey));
  return std::make_shared<const camera::Frame>(std::move(frame));
}

/// Wants another thing each time that it is asked.
class FickleGuide final : public hal::HandGuide {
 public:
  [[nodiscard]] hal::HandLook look() const override {
    hal::HandLook look;
    look.instruction.kind = static_cast<hal::Instruction::Kind>(++looks_ % 4);
    look.instruction.distance = 0.01 * (looks_ % 100);
    look.has_markers = looks_ % 3 != 0;
    if (look.has_markers) look.frame = a_frame(looks_ % 256);
    look.markers = {{7, {Vec2{10, 10}, Vec2{50, 10}, Vec2{50, 50}, Vec2{10, 50}}}};
    if (looks_ % 5 != 0) look.pose = Pose{0.01 * (looks_ % 100), 0.5, 0.1 * looks_};
    look.covariance = {1e-4, 0, 0, 0, 1e-4, 0, 0, 0, 1e-4};
    return look;
  }

 private:
  mutable int looks_ = 0;
};

/// Lets every second one in, and all out, without a world.
struct AnyCrew final : robios::Crew {
  Result<std::size_t> add(const std::vector<std::string>& words) override {
    if (words.size() % 2 == 0) return fail(Errc::OutOfRange, "not today");
    return 1U;
  }
  Result<void> remove(std::size_t) override { return {}; }
};

/// All windows there are, with programs and robots behind them that go on.
class Cage {
 public:
  Cage() {
    folder_.write("a.c", "#include <eyebot.h>\nint main(void) { return 0; }\n");
    folder_.write("room.wld", "floor 2000 1000\n0 0 2000 0\n");
    QImage(20, 20, QImage::Format_RGB32).save(path("plan.png"));
    hal::NotedBackend noted = hal::with_notes(panel_room_.take_robot());
    robot_ = std::move(noted.backend);
    notes_ = std::move(noted.notes);
    keys_.emplace(robot_->clock(), std::vector<robios::ScriptedKey>{}, nullptr);
    environment_.emplace(room_.environment(), "monkey", &crew_);
    environment_->view().set_guide(guide_);
    environment_->show_map("belief", board_);
    panel_.emplace(robios::PanelStart{"monkey – robot", &lcd_, &*keys_, &frames_, notes_.get()});
    hand_.emplace(robios::HandStart{"monkey – hand", &guide_, &frames_});
    editor_.emplace("");
    windows_ = {&*environment_, &*panel_, &*hand_, &*editor_};
    open_code_panel();
    for (QWidget* window : windows_) {
      for (QDockWidget* dock : window->findChildren<QDockWidget*>()) dock->show();
    }
    show();
  }

  [[nodiscard]] const std::vector<QWidget*>& windows() const { return windows_; }
  [[nodiscard]] testing::Room& room() { return room_; }
  /// It closes them, too.
  void show() {
    for (QWidget* window : windows_) window->show();
  }
  /// Programs go on: what they draw, read and hear.
  void live(int turn) {
    hal::TimeControl& time = room_.environment().time();
    if (time.is_paused()) time.resume();
    EXPECT_TRUE(time.set_factor(hal::TimeControl::kFastest));
    room_.pass(0.05);
    lcd_.set_menu({"A&B", "", turn % 3 == 0 ? "C" : "", "END"});
    lcd_.area(turn % 100, 20, 100, 40, {200, 0, 0}, true);
    frames_.set(a_frame(turn % 256));
    static_cast<void>(robot_->range_sensor(1)->read());
    static_cast<void>(robot_->drive()->start({0.1, 0.0, 0.1}));
    hal::SoundNote sound;
    if (turn % 2 == 0) sound.file = folder_.path() + "/plan.png";
    sound.frequency = 440;
    sound.length = 0.1;
    notes_->put_sound(sound);
    mapping::OccupancyGrid grid({{0.0, 0.0}, 0.1, 20, 10});
    grid.set_probability({turn % 20, turn % 10}, 0.99);
    board_.show({mapping::picture_of(grid, mapping::PictureKind::Probabilities),
                 {{1, room_.pose(1), 0.1}}});
  }

 private:
  [[nodiscard]] QString path(const std::string& name) const {
    return QString::fromStdString(folder_.path() + "/" + name);
  }
  [[nodiscard]] QString script(const std::string& name, const std::string& text) {
    QString file = QString::fromStdString(folder_.write(name, "#!/bin/sh\n" + text));
    QFile(file).setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    return file;
  }
  void open_code_panel() {
#ifdef EYEBRIDGE_HAVE_CODE_PANEL
    CodeSettings settings = CodeSettings::defaults();
    settings.drafts = path("drafts");
    settings.builds = path("builds");
    // What somebody typed at random is not for a computer to run.
    settings.c_compiler = script("cc", "echo 'a.c:1:3: warning: nonsense'\n");
    settings.cpp_compiler = script("c++", "echo 'a.cpp:1:3: error: nonsense'; exit 1\n");
    settings.eyebridge = script("eyebridge", "echo 'a.py:2: hello'; sleep 1\n");
    code_.emplace(QStringList{path("a.c")}, settings);
    windows_.push_back(&*code_);
#endif
  }

  eyebridge::testing::ScratchFolder folder_;
  testing::Room room_;
  testing::Room panel_room_;
  FickleGuide guide_;
  AnyCrew crew_;
  robios::MapBoard board_;
  robios::Lcd lcd_;
  camera::LatestFrame frames_;
  std::unique_ptr<hal::Backend> robot_;
  std::shared_ptr<hal::DeviceNotes> notes_;
  std::optional<robios::Keys> keys_;
  std::optional<EnvironmentWindow> environment_;
  std::optional<PanelWindow> panel_;
  std::optional<HandWindow> hand_;
  std::optional<EditorWindow> editor_;
#ifdef EYEBRIDGE_HAVE_CODE_PANEL
  std::optional<CodeWindow> code_;
#endif
  std::vector<QWidget*> windows_;
};

TEST(AMonkey, BreaksNothing) {
  const eyebridge::testing::ScratchFolder home;
  qputenv("XDG_DATA_HOME", QByteArray::fromStdString(home.path()));
  const QString before = QDir::currentPath();
  QDir::setCurrent(QString::fromStdString(home.path()));  // what it saves
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QSettings().clear();
  const int seed = number_of("EYEBRIDGE_TEST_MONKEY_SEED", 1);
  SCOPED_TRACE("seed " + std::to_string(seed));
  {
    Cage cage;
    testing::Monkey monkey(cage.windows(), static_cast<unsigned>(seed));
    // Event loops within an act have no other end.
    QTimer hands;
    QObject::connect(&hands, &QTimer::timeout, [&monkey] { monkey.let_go(); });
    hands.start(20);
    const int acts = number_of("EYEBRIDGE_TEST_MONKEY_ACTS", 600);
    const int seconds = number_of("EYEBRIDGE_TEST_MONKEY_SECONDS", 0);
    QElapsedTimer time;
    time.start();
    int done = 0;
    for (; seconds == 0 ? done < acts : time.elapsed() < 1000LL * seconds; ++done) {
      monkey.act();
      QApplication::processEvents();
      if (monkey.below(4) == 0) monkey.close_dialog();
      cage.show();
      if (done % 10 == 0) cage.live(done / 10);
    }
    ::testing::Test::RecordProperty("acts", done);
    // Robots are still in the world that they were in.
    hal::WorldLook look;
    cage.room().environment().look(look);
    EXPECT_EQ(look.robots.size(), 2U);
  }
  QDir::setCurrent(before);
}

}  // namespace
}  // namespace eyebridge::gui
