// Remote control, camera and hand view of a program that runs, from outside.
#include <QTest>
#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "person.hpp"
#include "running_program.hpp"

namespace eyebridge::gui {
namespace {

using eyebridge::testing::RunningProgram;
using ::testing::HasSubstr;

class PanelSession : public ::testing::Test {
 protected:
  void build(const std::vector<std::string>& flags, const std::string& text) {
    folder_.write("prog.c", text);
    std::vector<std::string> words{EYEBRIDGE_BIN "/eyebridge-cc", "prog.c", "-o", "prog"};
    words.insert(words.end(), flags.begin(), flags.end());
    const auto built = eyebridge::testing::run_program({words, {}, folder_.path()});
    ASSERT_EQ(built.exit_code, 0) << built.err;
  }
  [[nodiscard]] eyebridge::testing::ProgramStart start(std::vector<std::string> options) const {
    options.insert(options.begin(), {EYEBRIDGE_BIN "/eyebridge", "run"});
    options.push_back("./prog");
    return {options, {{"XDG_CONFIG_HOME", folder_.path()}}, folder_.path()};
  }

  eyebridge::testing::ScratchFolder folder_;
  testing::Person person_;
};

constexpr const char* kWaits = R"(
#include <eyebot.h>
#include <stdio.h>
int main(void) {
  puts("ready");
  fflush(stdout);
  int first = IRTVGet();
  int start = OSGetCount();
  int second = IRTVGet();
  printf("got %c and %c after %d ms\n", first, second, OSGetCount() - start);
  fflush(stdout);
  return 0;
}
)";

TEST_F(PanelSession, TheRemoteControlWorksInVirtualTime) {
  build({}, kWaits);
  RunningProgram program(start({"--fast", "--gui"}));
  const xcb_window_t panel = person_.window("prog – robot");
  program.wait_for("ready\n");
  person_.type_alt(panel, '5');
  person_.type_alt(panel, 'r');
  // What the call itself costs on a robot, and no time while a person is waited for.
  EXPECT_THAT(program.wait_for("ms\n"), HasSubstr("got 5 and R after 0 ms"));
  program.finish(SIGTERM);
}

TEST_F(PanelSession, TheRemoteControlWorksInRealTime) {
  build({}, kWaits);
  RunningProgram program(start({"--gui"}));
  const xcb_window_t panel = person_.window("prog – robot");
  program.wait_for("ready\n");
  person_.type_alt(panel, '0');
  person_.type_alt(panel, 'p');
  EXPECT_THAT(program.wait_for("ms\n"), HasSubstr("got 0 and P"));
  program.finish(SIGTERM);
}

// In virtual time an hour of polling passes in a second: it waited for no person.
TEST_F(PanelSession, AClassicProgramWaitsForThePersonAtTheRemoteControl) {
  build({"--classic"}, R"(
#include "eyebot.h"
#include <stdio.h>
int main(void) {
  IRTVInitHDT(IRTV);
  puts("ready");
  fflush(stdout);
  printf("got %c\n", IRTVGet());
  fflush(stdout);
  return 0;
}
)");
  RunningProgram program(start({"--fast", "--gui"}));
  const xcb_window_t panel = person_.window("prog – robot");
  program.wait_for("ready\n");
  QTest::qWait(1500);  // a poller has long given up
  person_.type_alt(panel, '7');
  EXPECT_THAT(program.wait_for("got 7"), HasSubstr("got 7"));
  program.finish(SIGTERM);
}

constexpr const char* kSees = R"(
#include <eyebot.h>
#include <stdio.h>
int main(void) {
  static BYTE frame[QQVGA_SIZE];
  CAMInit(QQVGA);
  for (int i = 0; i < 20; i++) {
    CAMGet(frame);
    VWSetSpeed(PSDGet(PSD_FRONT) / 4, frame[100] / 4);
    AUBeep();
    OSWait(50);
  }
  puts("seen");
  fflush(stdout);
  KEYWait(KEY1);
  return 0;
}
)";

TEST_F(PanelSession, TheCameraOfAProgramIsShown) {
  build({}, kSees);
  RunningProgram program(start({"--fast", "--gui"}));
  const xcb_window_t panel = person_.window("prog – robot");
  program.wait_for("seen\n");
  // The sky, which nothing else here is as blue as.
  const auto sees_sky = [&] {
    const QImage picture = person_.picture(panel);
    int sky = 0;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = picture.width() / 2; x < picture.width(); ++x) {
        const QColor colour = picture.pixelColor(x, y);
        if (colour.blue() > 220 && colour.red() < 180) ++sky;
      }
    }
    return sky > 1000;
  };
  EXPECT_TRUE(QTest::qWaitFor(sees_sky));
  program.finish(SIGTERM);
}

TEST_F(PanelSession, ARunIsTheSameWithAndWithoutWindows) {
  build({}, kSees);
  const auto trace = [&](const char* out) {
    return eyebridge::testing::file_text(folder_.path() + "/" + out + "/trace.csv");
  };
  RunningProgram quiet(
      start({"--fast", "--errors", "realistic", "--keys", "KEY1@5s", "--out", "quiet"}));
  EXPECT_EQ(quiet.wait(), 0) << quiet.said();
  RunningProgram seen(
      start({"--fast", "--errors", "realistic", "--keys", "KEY1@5s", "--out", "seen", "--gui"}));
  const xcb_window_t panel = person_.window("prog – robot");
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return trace("seen").size() >= trace("quiet").size(); }, 20000));
  seen.signal(SIGTERM);
  seen.wait();
  EXPECT_GT(trace("quiet").size(), 1000U);
  EXPECT_EQ(trace("seen"), trace("quiet"));
  static_cast<void>(panel);
}

TEST_F(PanelSession, TheHandViewOpensWhereAPersonIsToFollow) {
  build({}, R"(
#include <eyebot.h>
#include <stdio.h>
int main(void) {
  VWStraight(500, 100);
  puts("drives");
  fflush(stdout);
  VWWait();
  return 3;
}
)");
  RunningProgram program(start({"--drive", "hand:free"}));
  const xcb_window_t view = person_.window("carried by hand");
  program.wait_for("drives\n");
  // The arrow: black on white, in the left half.
  EXPECT_TRUE(QTest::qWaitFor([&] {
    const QImage picture = person_.picture(view);
    int black = 0;
    for (int y = 0; y < picture.height() / 2; y += 4) {
      for (int x = 0; x < picture.width() / 2; x += 4) {
        black += picture.pixelColor(x, y) == QColor(Qt::black);
      }
    }
    return black > 300;
  }));
  program.signal(SIGTERM);
  EXPECT_EQ(program.wait(), 128 + SIGTERM) << program.said();
}

}  // namespace
}  // namespace eyebridge::gui
