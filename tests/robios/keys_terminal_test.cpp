#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include "key_input.hpp"
#include "terminal/terminal_mode.hpp"

namespace eyebridge::robios {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kPlenty{10000};

/// A terminal whose person is the test.
class FakeTerminal {
 public:
  FakeTerminal() : person_(posix_openpt(O_RDWR | O_NOCTTY)) {
    if (person_ >= 0 && grantpt(person_) == 0 && unlockpt(person_) == 0) {
      program_ = open(ptsname(person_), O_RDWR | O_NOCTTY);
    }
  }
  ~FakeTerminal() {
    hang_up();
    close(program_);
  }
  FakeTerminal(const FakeTerminal&) = delete;
  FakeTerminal& operator=(const FakeTerminal&) = delete;

  [[nodiscard]] int program() const { return program_; }
  void type(std::string_view text) const {
    ASSERT_EQ(write(person_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  /// What the program has sent since the last time.
  [[nodiscard]] std::string seen() const {
    char text[256];
    const ssize_t count = read(person_, text, sizeof text);
    return {text, static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
  }
  void hang_up() {
    if (person_ >= 0) {
      close(person_);
      person_ = -1;
    }
  }
  [[nodiscard]] bool takes_lines_and_echoes() const {
    termios mode{};
    EXPECT_EQ(tcgetattr(program_, &mode), 0);
    return (mode.c_lflag & ICANON) != 0 && (mode.c_lflag & ECHO) != 0;
  }

 private:
  int person_;
  int program_ = -1;
};

TEST(TerminalKeys, TakesTheDigitsOneToFourWithoutEnter) {
  const FakeTerminal terminal;
  TerminalKeys keys(terminal.program());
  EXPECT_EQ(keys.poll(milliseconds(0)), KeyEvent{});
  terminal.type("1x45");
  EXPECT_EQ(keys.poll(kPlenty), (KeyEvent{1, std::nullopt, '1'}));
  EXPECT_EQ(keys.poll(kPlenty), (KeyEvent{8, std::nullopt, '4'}));
  EXPECT_EQ(keys.poll(kPlenty), (KeyEvent{0, std::nullopt, '5'}));
  EXPECT_TRUE(keys.open());
  EXPECT_FALSE(keys.has_touches());
}

TEST(TerminalKeys, TakesClicksAsTouchesOfWhatIsUnderThem) {
  const FakeTerminal terminal;
  TerminalKeys keys(terminal.program(), [](int column, int row) {
    return row == 0 ? std::nullopt : std::optional(TouchPoint{7 * column, 15 * row});
  });
  EXPECT_TRUE(keys.has_touches());
  keys.poll(milliseconds(0));
  EXPECT_EQ(terminal.seen(), "\x1b[?1000h\x1b[?1006h");
  terminal.type("\x1b[<0;11;3M\x1b[<0;11;3m\x1b[<0;5;1M");
  EXPECT_EQ(keys.poll(kPlenty), (KeyEvent{0, TouchPoint{70, 30}}));
  EXPECT_EQ(keys.poll(kPlenty), KeyEvent{}) << "outside";
  restore_keys();
  EXPECT_EQ(terminal.seen(), "\x1b[?1006l\x1b[?1000l");
}

TEST(TerminalKeys, LeavesTheTerminalAsItWas) {
  const FakeTerminal terminal;
  {
    TerminalKeys keys(terminal.program());
    EXPECT_TRUE(terminal.takes_lines_and_echoes());  // nothing is switched before it is needed
    keys.poll(milliseconds(0));
    EXPECT_FALSE(terminal.takes_lines_and_echoes());
  }
  EXPECT_TRUE(terminal.takes_lines_and_echoes());
}

TEST(TerminalKeys, LeavesTheTerminalAloneOnceItIsReleased) {
  EXPECT_EXIT(
      {
        const FakeTerminal terminal;
        TerminalKeys keys(terminal.program());
        keys.poll(milliseconds(0));
        release_terminal();
        const bool restored = terminal.takes_lines_and_echoes();
        keys.poll(milliseconds(0));
        _exit(restored && terminal.takes_lines_and_echoes() ? 0 : 1);
      },
      ::testing::ExitedWithCode(0), "");
}

TEST(TerminalKeys, EndsWithTheTerminal) {
  FakeTerminal terminal;
  TerminalKeys keys(terminal.program());
  keys.poll(milliseconds(0));
  terminal.hang_up();
  EXPECT_EQ(keys.poll(kPlenty), KeyEvent{});
  EXPECT_FALSE(keys.open());
}

TEST(TerminalKeys, RestoresTheTerminalWhenKilledOrLeft) {
  for (const int signal : {SIGTERM, SIGINT, 0}) {
    const FakeTerminal terminal;
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      auto* keys = new TerminalKeys(terminal.program());  // never deleted, as in a killed program
      keys->poll(milliseconds(0));
      if (terminal.takes_lines_and_echoes()) {
        _exit(3);
      }
      if (signal != 0) {
        std::raise(signal);
      }
      restore_terminal();
      _exit(0);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    if (signal != 0) {
      EXPECT_TRUE(WIFSIGNALED(status));
      EXPECT_EQ(WTERMSIG(status), signal);
    } else {
      EXPECT_EQ(status, 0);
    }
    EXPECT_TRUE(terminal.takes_lines_and_echoes());
  }
}

}  // namespace
}  // namespace eyebridge::robios
