// A robot program and its windows, from outside: what a person does at the display.
#include <QTest>
#include <algorithm>
#include <csignal>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/jumping_clock.hpp"
#include "eyebridge/camera/source.hpp"
#include "person.hpp"
#include "running_program.hpp"

namespace eyebridge::gui {
namespace {

using eyebridge::testing::RunningProgram;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

/// Waits for a key, drives, and tells where it is.
constexpr const char* kProgram = R"(
#include <eyebot.h>
#include <stdio.h>
int main(void) {
  LCDMenu("GO", "", "", "END");
  LCDArea(0, 0, 100, 100, RED, 1);
  puts("ready");
  fflush(stdout);
  if (KEYWait(ANYKEY) == KEY4) return 4;
  VWStraight(100, 200);
  VWWait();
  int x, y, phi;
  VWGetPosition(&x, &y, &phi);
  printf("at %d\n", x);
  return 7;
}
)";

class Session : public ::testing::Test {
 protected:
  void SetUp() override { build("drives", kProgram); }
  void build(const std::string& name, const std::string& text) {
    folder_.write(name + ".c", text);
    const auto built = eyebridge::testing::run_program(
        {{EYEBRIDGE_BIN "/eyebridge-cc", name + ".c", "-o", name}, {}, folder_.path()});
    ASSERT_EQ(built.exit_code, 0) << built.err;
  }
  [[nodiscard]] eyebridge::testing::ProgramStart start(std::vector<std::string> options,
                                                       const std::string& name = "drives") const {
    options.insert(options.begin(), {EYEBRIDGE_BIN "/eyebridge", "run"});
    options.push_back("./" + name);
    return {options, {{"XDG_CONFIG_HOME", folder_.path()}}, folder_.path()};
  }

  eyebridge::testing::ScratchFolder folder_;
  testing::Person person_;
};

TEST_F(Session, PanelThenEnvironmentAndBothStayAtTheEnd) {
  RunningProgram program(start({"--factor", "5"}));
  const xcb_window_t panel = person_.window("drives – robot");
  program.wait_for("ready\n");
  EXPECT_THAT(person_.titles(), Not(Contains(HasSubstr("environment")))) << "it has not driven yet";
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return person_.picture(panel).pixelColor(50, 100) == QColor(255, 0, 0); }));
  person_.type(panel, '1');
  const xcb_window_t environment = person_.window("drives – environment");
  EXPECT_EQ(person_.window("environment – ended"), environment);
  EXPECT_THAT(person_.titles(), Contains(HasSubstr("drives – robot")));
  person_.close(environment);
  person_.wait_until_gone("environment");
  person_.close(panel);
  EXPECT_EQ(program.wait(), 7) << program.said();
}

TEST_F(Session, ClosingTheWindowsEndsTheProgramPolitely) {
  RunningProgram program(start({"--out", folder_.path() + "/out"}));
  person_.close(person_.window("drives – robot"));
  EXPECT_EQ(program.wait(), 128 + SIGTERM) << program.said();
  EXPECT_NE(eyebridge::testing::file_text(folder_.path() + "/out/lcd.txt"), "");
}

TEST_F(Session, CtrlCCompletesAFilm) {
  build("turns",
        "#include <eyebot.h>\nint main(void) { VWSetSpeed(0, 90); return KEYWait(ANYKEY); }\n");
  RunningProgram program(start({}, "turns"));
  person_.type_control(person_.window("turns – environment"), 'r');
  constexpr std::uint32_t kReturn = 0xff0d;
  person_.press(person_.window("Film"), kReturn);  // the name that it proposes
  const std::string film = folder_.path() + "/turns.mp4";
  ASSERT_TRUE(QTest::qWaitFor([&] { return std::filesystem::exists(film); }));
  EXPECT_EQ(program.finish(SIGINT), 128 + SIGINT) << program.said();
  JumpingClock clock;
  const auto source = camera::open_source("frames:" + film, {&clock, nullptr, nullptr});
  EXPECT_TRUE(source->next(clock.now() + std::chrono::seconds(1)));
}

TEST_F(Session, WindowsInVirtualTimeWhereTheyAreAskedFor) {
  RunningProgram quiet(start({"--fast", "--keys", "KEY1@1s"}));
  EXPECT_EQ(quiet.wait(), 7) << quiet.said();
  RunningProgram shown(start({"--fast", "--gui", "--keys", "KEY1@1s"}));
  const xcb_window_t environment = person_.window("drives – environment – ended");
  person_.close(person_.window("drives – robot"));
  person_.close(environment);
  EXPECT_EQ(shown.wait(), 7) << shown.said();
}

TEST_F(Session, SeveralRobotsHaveAPanelEach) {
  RunningProgram program(start({"--robots", "2", "--keys", "KEY1@1s"}));
  const xcb_window_t environment = person_.window("– environment");
  const xcb_window_t first = person_.window("robot 1");
  const xcb_window_t second = person_.window("robot 2");
  EXPECT_EQ(person_.window("environment – ended"), environment);
  for (const xcb_window_t window : {environment, first, second}) person_.close(window);
  EXPECT_EQ(program.wait(), 7) << program.said();
}

#ifndef __SANITIZE_ADDRESS__
// Qt's plug-ins go with the process, after the thread that they were made in. The address sanitizer
// does not see what Qt itself does with memory.
TEST_F(Session, TheEndUsesNoMemoryThatWasFreed) {
  auto checked = start({"--fast", "--gui", "--keys", "KEY1@1s"});
  checked.command.insert(checked.command.begin(),
                         {"valgrind", "--quiet", "--trace-children=yes", "--undef-value-errors=no",
                          "--error-exitcode=99"});
  RunningProgram program(checked);
  const xcb_window_t environment = person_.window("drives – environment – ended");
  person_.close(person_.window("drives – robot"));
  person_.close(environment);
  EXPECT_EQ(program.wait(), 7) << program.said();
}
#endif

/// A server of its own, which says its number; when its last client leaves, it begins anew.
class OwnDisplay {
 public:
  explicit OwnDisplay(const std::string& options = "-screen 0 800x600x24")
      : server_({{"sh", "-c", "exec Xvfb -displayfd 1 " + options + " 2>/dev/null"}, {}, {}}) {
    const std::string& number = server_.wait_for("\n");
    name_ = ":" + number.substr(0, number.find('\n'));
  }
  [[nodiscard]] const std::string& name() const { return name_; }
  void go_away() { server_.finish(SIGKILL); }

 private:
  RunningProgram server_;
  std::string name_;
};

TEST_F(Session, ADisplayThatGoesAwayEndsTheRunPolitely) {
  for (const std::string robots : {"1", "2"}) {
    OwnDisplay display;
    auto shown = start({"--gui", "--robots", robots, "--out", folder_.path() + "/out" + robots});
    shown.environment["DISPLAY"] = display.name();
    RunningProgram program(shown);
    program.wait_for("ready\n");
    display.go_away();
    EXPECT_EQ(program.wait(), 128 + SIGTERM) << program.said();
    EXPECT_THAT(program.said(), HasSubstr("eyebridge: the display went away: the run ends\n"));
    const std::string robot = robots == "1" ? "" : "/robot-2";
    EXPECT_NE(eyebridge::testing::file_text(folder_.path() + "/out" + robots + robot + "/lcd.txt"),
              "")
        << "results are written";
  }
}

TEST_F(Session, WindowsFitOnASmallScreen) {
  for (const QSize& size : {QSize(640, 480), QSize(480, 320)}) {
    const std::string words = std::to_string(size.width()) + 'x' + std::to_string(size.height());
    const OwnDisplay display("-screen 0 " + words + "x24");
    testing::Person person(display.name().c_str());
    auto shown = start({"--gui", "--factor", "20"});
    shown.environment["DISPLAY"] = display.name();
    RunningProgram program(shown);
    const xcb_window_t panel = person.window("drives – robot");
    program.wait_for("ready\n");
    person.type(panel, '1');
    const xcb_window_t environment = person.window("environment");
    for (const xcb_window_t window : {panel, environment}) {
      const QRect place = person.place(window);
      EXPECT_TRUE(QRect(QPoint(), size).contains(place))
          << words << ": " << place.x() << ' ' << place.y() << ' ' << place.width() << ' '
          << place.height();
    }
    EXPECT_EQ(program.finish(SIGTERM), 128 + SIGTERM) << program.said();
  }
}

TEST_F(Session, ADisplayBehindANetworkIsADisplay) {
  const OwnDisplay display("-listen tcp -nolisten unix -ac -screen 0 800x600x24");
  auto shown = start({"--gui", "--factor", "20", "--keys", "KEY1@1s"});
  shown.environment["DISPLAY"] = "127.0.0.1" + display.name();
  RunningProgram program(shown);
  EXPECT_THAT(program.wait_for("at 100\n"), HasSubstr("at 100\n"));
  testing::Person person(shown.environment["DISPLAY"].c_str());
  person.close(person.window("environment"));
  person.wait_until_gone("environment");
  person.close(person.window("robot"));
  EXPECT_EQ(program.wait(), 7) << program.said();
}

TEST_F(Session, OpensWindowsAtADisplayThatBeginsAnewWithoutClients) {
  const OwnDisplay display;  // nobody else is at it
  auto alone = start({"--gui", "--factor", "20", "--keys", "KEY1@1s"});
  alone.environment["DISPLAY"] = display.name();
  RunningProgram program(alone);
  EXPECT_THAT(program.wait_for("at 100\n"), HasSubstr("at 100\n"));
  EXPECT_EQ(program.finish(SIGTERM), 128 + SIGTERM) << program.said();
}

#ifdef EYEBRIDGE_HAVE_CODE_PANEL
TEST_F(Session, NothingThatWasTypedIsLostWithTheDisplay) {
  OwnDisplay display("-screen 0 1280x1024x24");
  testing::Person person(display.name().c_str());
  folder_.write("room.wld", "floor 1000 1000\n0 0 1000 0\n");
  RunningProgram edit({{EYEBRIDGE_BIN "/eyebridge", "edit", "drives.c", "room.wld"},
                       {{"DISPLAY", display.name()},
                        {"XDG_CONFIG_HOME", folder_.path()},
                        {"XDG_DATA_HOME", folder_.path()}},
                       folder_.path()});
  const xcb_window_t program = person.window("drives.c");
  for (const char letter : std::string("lastwords")) person.type(program, letter);
  const xcb_window_t world = person.window("room.wld");
  person.type_control(world, 'a');  // all of it
  person.press(world, 0xff53);      // one step to the right
  ASSERT_TRUE(QTest::qWaitFor([&] {
    const auto titles = person.titles();
    return std::ranges::count_if(titles, [](const std::string& title) {
             return title.find("*") != std::string::npos;
           }) == 2;
  })) << ::testing::PrintToString(person.titles());
  display.go_away();
  EXPECT_EQ(edit.wait(), 128 + SIGTERM) << edit.said();
  EXPECT_THAT(edit.said(), HasSubstr("the display went away"));
  bool has_text = false;
  bool has_world = false;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path())) {
    if (entry.path().extension() == ".json") {
      has_text = has_text ||
                 eyebridge::testing::file_text(entry.path()).find("lastwords") != std::string::npos;
    }
    has_world = has_world || entry.path().extension() == ".autosave";
  }
  EXPECT_TRUE(has_text);
  EXPECT_TRUE(has_world);
}
#endif

TEST_F(Session, NoWindowsWhereThereIsNoDisplay) {
  auto lost = start({"--gui"});
  lost.environment["DISPLAY"] = ":4711";
  RunningProgram insists(lost);
  EXPECT_EQ(insists.wait(), 2);
  EXPECT_THAT(insists.said(), HasSubstr("no windows can be opened: the display :4711 cannot be "
                                        "reached; expected one that can, or gui = off"));
  auto silent = start({"--log", "info", "--factor", "20", "--keys", "KEY4@1s"});
  silent.environment["DISPLAY"] = ":4711";
  RunningProgram goes_on(silent);
  EXPECT_EQ(goes_on.wait(), 4) << goes_on.said();
  EXPECT_THAT(goes_on.said(), HasSubstr("no windows: the display :4711 cannot be reached"));
  RunningProgram off(start({"--no-gui", "--factor", "20", "--keys", "KEY4@1s"}));
  EXPECT_EQ(off.wait(), 4) << off.said();
  EXPECT_THAT(person_.titles(), Not(Contains(HasSubstr("drives"))));
}

TEST_F(Session, NoWindowsWithoutThePlugIn) {
  // As where EyeBridge was built without Qt.
  const std::filesystem::path lonely = folder_.path() + "/lib";
  std::filesystem::create_directories(lonely / "eyebridge");
  std::filesystem::copy_file(EYEBRIDGE_BIN "/../lib/libeyebridge.so.0",
                             lonely / "libeyebridge.so.0");
  auto insists = start({"--gui"});
  insists.environment["LD_LIBRARY_PATH"] = lonely;
  RunningProgram program(insists);
  EXPECT_EQ(program.wait(), 2);
  EXPECT_THAT(
      program.said(),
      HasSubstr("no windows can be opened: there is no " + lonely.string() +
                "/eyebridge/libeyebridge_gui.so; expected EyeBridge built where Qt 6 is installed "
                "(qt6-base-dev), or gui = off"));
}

TEST_F(Session, AFileThatIsOpenComesToTheFront) {
  folder_.write("room.wld", "floor 1000 1000\n0 0 1000 0\n");
  folder_.write("last.wld", "floor 1000 1000\n0 0 1000 0\n");
  RunningProgram edit({{EYEBRIDGE_BIN "/eyebridge", "edit", "room.wld", "drives.c", "./room.wld",
                        folder_.path() + "/drives.c", "last.wld"},
                       {{"XDG_CONFIG_HOME", folder_.path()}, {"XDG_DATA_HOME", folder_.path()}},
                       folder_.path()});
  const xcb_window_t last = person_.window("last.wld");  // all others were opened
  const xcb_window_t program = person_.window("drives.c");
  person_.close(person_.window("room.wld"));
  person_.wait_until_gone("room.wld");  // there was one
  person_.close(last);
  person_.close(program);
  EXPECT_EQ(edit.wait(), 0) << edit.said();
}

TEST_F(Session, WorldsAndProgramsAreEditedWithoutARun) {
  folder_.write("room.wld", "floor 1000 1000\n0 0 1000 0\n");
  RunningProgram edit({{EYEBRIDGE_BIN "/eyebridge", "edit", "room.wld", "drives.c"},
                       {{"XDG_CONFIG_HOME", folder_.path()}, {"XDG_DATA_HOME", folder_.path()}},
                       folder_.path()});
  const xcb_window_t world = person_.window("room.wld");
  const xcb_window_t program = person_.window("drives.c");
  person_.close(world);
  person_.wait_until_gone("room.wld");
  EXPECT_THAT(person_.titles(), Contains(HasSubstr("drives.c")));
  person_.close(program);
  EXPECT_EQ(edit.wait(), 0) << edit.said();
}

}  // namespace
}  // namespace eyebridge::gui
