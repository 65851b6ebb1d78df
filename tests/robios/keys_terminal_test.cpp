#include <csignal>
#include <cstdlib>
#include <string_view>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include "key_input.hpp"

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
  EXPECT_EQ(keys.poll(milliseconds(0)), 0);
  terminal.type("1x45");
  EXPECT_EQ(keys.poll(kPlenty), 1);
  EXPECT_EQ(keys.poll(kPlenty), 0);  // x
  EXPECT_EQ(keys.poll(kPlenty), 8);
  EXPECT_EQ(keys.poll(kPlenty), 0);  // 5
  EXPECT_TRUE(keys.open());
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
  EXPECT_EQ(keys.poll(kPlenty), 0);
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
