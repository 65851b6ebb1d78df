// Programs at a terminal: what a person sees there, types and clicks, and what is left at the end.

#include <array>
#include <csignal>
#include <functional>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include "named_program.hpp"
#include "terminal_emulator.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using testing::TerminalEmulator;

constexpr int kColumns = 90;
constexpr int kRows = 36;
constexpr int kTop = 9;  // of the panel, 27 rows

/// Runs `program` as a shell does: in its session, but not as the leader. With the leader's end the
/// kernel takes the terminal from all, and the guard, which restores it after SIGKILL, may be late.
/// Tells its process id and then each of its states, as waitpid() gives them. Never returns.
[[noreturn]] void lead_session(const std::string& program, int states) {
  // Those of the keyboard go to all at the terminal.
  constexpr std::array kKeyboard = {SIGINT, SIGQUIT, SIGTSTP, SIGTTOU, SIGHUP};
  for (const int signal : kKeyboard) std::signal(signal, SIG_IGN);
  const pid_t pid = fork();
  if (pid == 0) {
    for (const int signal : kKeyboard) std::signal(signal, SIG_DFL);
    close(states);
    execl(program.c_str(), program.c_str(), nullptr);
    _exit(127);
  }
  for (const int terminal : {0, 1, 2}) close(terminal);  // its last reader sees its end
  bool is_told = write(states, &pid, sizeof pid) == sizeof pid;
  int status = 0;
  while (is_told && waitpid(pid, &status, WUNTRACED) == pid) {
    is_told = write(states, &status, sizeof status) == sizeof status && WIFSTOPPED(status);
  }
  pollfd reader{states, 0, 0};
  poll(&reader, 1, -1);  // until nobody wants to know more
  _exit(0);
}

/// A program of tests/robios/programs at a terminal of its own.
class Person {
 public:
  Person(const std::string& program, const std::map<std::string, std::string>& environment) {
    winsize size{};
    size.ws_col = kColumns;
    size.ws_row = kRows;
    int states[2];
    EXPECT_EQ(pipe2(states, O_CLOEXEC), 0);
    leader_ = forkpty(&terminal_, nullptr, nullptr, &size);
    if (leader_ == 0) {
      close(states[0]);
      setenv("TERM", "xterm-256color", 1);
      setenv("COLORTERM", "truecolor", 1);
      setenv("ASAN_OPTIONS", "handle_segv=0:handle_sigbus=0:use_sigaltstack=0", 1);
      for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
      lead_session(std::string(EYEBRIDGE_TEST_PROGRAMS) + "/" + program, states[1]);
    }
    close(states[1]);
    states_ = states[0];
    EXPECT_EQ(read(states_, &pid_, sizeof pid_), static_cast<ssize_t>(sizeof pid_));
  }
  ~Person() {
    if (pid_ > 0 && !waited_) kill(pid_, SIGKILL);
    close(states_);
    waitpid(leader_, nullptr, 0);
    close(terminal_);
  }
  Person(const Person&) = delete;
  Person& operator=(const Person&) = delete;

  /// Looks until `seen` is true; false when the program ended before.
  bool look(const std::function<bool()>& seen) {
    char bytes[4096];
    while (!seen()) {
      const ssize_t count = read(terminal_, bytes, sizeof bytes);
      if (count <= 0) return false;
      screen.feed({bytes, static_cast<std::size_t>(count)});
    }
    return true;
  }
  bool sees(int row, const std::string& text) {
    return look([&] { return screen.text(row).find(text) != std::string::npos; });
  }
  /// Looks until `text` is to be seen in the panel.
  bool sees_on_lcd(int row, const std::string& text) { return sees(kTop + row, text); }
  /// Looks until the program wants keys: what is typed before would be echoed.
  bool may_type() {
    return look([&] { return screen.reports_clicks(); });
  }
  void type(const std::string& text) const {
    ASSERT_EQ(write(terminal_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  void click(int column, int row) const {
    type("\x1b[<0;" + std::to_string(column + 1) + ";" + std::to_string(row + 1) + "M");
  }
  void resize(int columns, int rows) {
    winsize size{};
    size.ws_col = static_cast<unsigned short>(columns);
    size.ws_row = static_cast<unsigned short>(rows);
    ASSERT_EQ(ioctl(terminal_, TIOCSWINSZ, &size), 0);
    screen.resize(columns, rows);
  }
  [[nodiscard]] pid_t pid() const { return pid_; }
  /// Waits until it ends or is stopped: what waitpid() gives.
  int next_state() {
    int status = 0;
    EXPECT_EQ(read(states_, &status, sizeof status), static_cast<ssize_t>(sizeof status));
    return status;
  }
  /// How it ended: 128 + a signal, or its exit code. All that it and its guard wrote is shown then.
  int wait() {
    look([] { return false; });
    const int status = next_state();
    waited_ = true;
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  }
  void expect_restored() {
    EXPECT_EQ(screen.unknown(), "");
    EXPECT_FALSE(screen.has_region());
    EXPECT_FALSE(screen.reports_clicks());
    EXPECT_EQ(screen.cursor_column(), 0);
    EXPECT_EQ(screen.cursor_row(), screen.rows() - 1);
    EXPECT_EQ(screen.text(screen.rows() - 1), "") << "the panel is above the cursor";
    termios mode{};
    EXPECT_EQ(tcgetattr(terminal_, &mode), 0);
    EXPECT_NE(mode.c_lflag & ICANON, 0U);
    EXPECT_NE(mode.c_lflag & ECHO, 0U);
  }

  TerminalEmulator screen{kColumns, kRows};

 private:
  int terminal_ = -1;
  int states_ = -1;
  pid_t leader_ = -1;
  pid_t pid_ = -1;
  bool waited_ = false;
};

TEST(ProgramPanel, ShowsTheLcdWithoutBeingAsked) {
  Person person("shows", {});
  ASSERT_TRUE(person.sees_on_lcd(25, "END"));
  EXPECT_EQ(person.screen.text(kTop), "Hello");
  const TerminalEmulator::Cell red{U'r', 0xFF0000, 0xFFFFFF};
  EXPECT_EQ(person.screen.at(5, kTop + 2), red);
  for (int row = 10; row < 14; ++row) {
    for (int column = 10; column < 20; ++column) {
      EXPECT_EQ(person.screen.at(column, kTop + row).paper, 0x0000FF) << column << ' ' << row;
    }
  }
  EXPECT_EQ(person.screen.at(0, kTop + 24).paper, 0xFF0000);
}

TEST(ProgramPanel, TakesKeysAndClicksAndShowsWhatIsPrintedAboveIt) {
  Person person("shows", {});
  ASSERT_TRUE(person.may_type());
  person.type("1");
  ASSERT_TRUE(person.sees_on_lcd(4, "key 1"));
  EXPECT_EQ(person.screen.text(0), "asks: key 1") << "where the program was before";
  EXPECT_EQ(person.screen.text(1), "told 1");
  person.type("2");
  ASSERT_TRUE(person.sees_on_lcd(4, "key 2"));
  person.click(30, kTop + 6);
  ASSERT_TRUE(person.sees(4, "touch"));
  EXPECT_EQ(person.screen.text(4), "touch 213 97") << "in pixels of the LCD";
  person.click(50, kTop + 25);
  ASSERT_TRUE(person.sees_on_lcd(4, "key 4"));
  person.type("4");
  EXPECT_EQ(person.wait(), 0);
  person.expect_restored();
  EXPECT_EQ(person.screen.text(kTop - 1 + 4), "key 8") << "the last picture stays";
}

TEST(ProgramPanel, WorksInVirtualTimeWhenAskedFor) {
  Person person("shows", {{"EYEBRIDGE_PANEL", "term"}, {"EYEBRIDGE_FAST", "true"}});
  ASSERT_TRUE(person.may_type());
  person.type("4");
  EXPECT_EQ(person.wait(), 0);
  person.expect_restored();
}

TEST(ProgramPanel, RestoresTheTerminalHoweverTheProgramEnds) {
  const std::map<std::string, int> ways = {{"return", 0},
                                           {"exit", 3},
                                           {"_exit", 4},
                                           {"abort", 128 + SIGABRT},
                                           {"fault", 128 + SIGSEGV},
                                           {"overflow", 128 + SIGSEGV}};
  for (const auto& [how, code] : ways) {
    SCOPED_TRACE(how);
    Person person("shows", {{"EYEBRIDGE_TEST_HOW", how}});
    ASSERT_TRUE(person.may_type());
    ASSERT_TRUE(person.sees_on_lcd(25, "END"));
    person.type("4");
    EXPECT_EQ(person.wait(), code);
    person.expect_restored();
  }
}

TEST(ProgramPanel, RestoresTheTerminalWhateverSignalEndsTheProgram) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGKILL, SIGUSR1, SIGALRM}) {
    SCOPED_TRACE(signal);
    Person person("shows", {});
    ASSERT_TRUE(person.may_type());
    ASSERT_TRUE(person.sees_on_lcd(25, "END"));
    kill(person.pid(), signal);
    EXPECT_EQ(person.wait(), 128 + signal);
    person.expect_restored();
  }
}

TEST(ProgramPanel, LendsTheTerminalToOthersWhileTheProgramIsStopped) {
  Person person("shows", {});
  ASSERT_TRUE(person.may_type());
  ASSERT_TRUE(person.sees_on_lcd(25, "END"));
  person.type("\x1a");  // Ctrl-Z
  ASSERT_TRUE(WIFSTOPPED(person.next_state()));
  ASSERT_TRUE(person.look([&] { return !person.screen.has_region(); }));
  EXPECT_FALSE(person.screen.reports_clicks());
  person.screen.feed("$ fg\r\n");  // as a shell would
  kill(person.pid(), SIGCONT);
  ASSERT_TRUE(person.look([&] { return person.screen.has_region(); }));
  ASSERT_TRUE(person.may_type());
  ASSERT_TRUE(person.sees_on_lcd(25, "END"));
  person.type("4");
  EXPECT_EQ(person.wait(), 0);
  person.expect_restored();
}

// Its guard is to go on then, or the terminal stays open after the program's end.
TEST(ProgramPanel, CtrlZThatComesBeforeTheGuardIsReadyStopsTheProgramOnly) {
  Person person("shows", {{"LD_PRELOAD", EYEBRIDGE_TEST_PROGRAMS "/liblate_guard.so"},
                          {"ASAN_OPTIONS",
                           "handle_segv=0:handle_sigbus=0:use_sigaltstack=0:"
                           "verify_asan_link_order=0"}});
  ASSERT_TRUE(person.may_type());
  ASSERT_TRUE(person.sees_on_lcd(25, "END"));
  person.type("\x1a");  // Ctrl-Z
  ASSERT_TRUE(WIFSTOPPED(person.next_state()));
  kill(person.pid(), SIGCONT);
  ASSERT_TRUE(person.look([&] { return !person.screen.has_region(); }));
  ASSERT_TRUE(person.may_type());
  ASSERT_TRUE(person.sees_on_lcd(25, "END"));
  person.type("4");
  EXPECT_EQ(person.wait(), 0);
  person.expect_restored();
}

TEST(ProgramPanel, FollowsTheWindow) {
  Person person("shows", {});
  ASSERT_TRUE(person.sees_on_lcd(25, "END"));
  person.resize(60, 20);
  ASSERT_TRUE(person.sees(19, "GO"));
  EXPECT_EQ(person.screen.text(2), "Hello");
}

TEST(ProgramPanel, IsNotThereForNone) {
  Person person("shows", {{"EYEBRIDGE_PANEL", "none"}});
  ASSERT_TRUE(person.sees(0, "asks:"));
  person.type("14");
  EXPECT_EQ(person.wait(), 0);
  EXPECT_EQ(person.screen.unknown(), "");
  EXPECT_FALSE(person.screen.has_region());
  EXPECT_THAT(person.screen.text(0), HasSubstr("key 1"));
  EXPECT_EQ(person.screen.text(kTop), "");
}

TEST(ProgramPanel, IsAnErrorWithoutATerminal) {
  const std::string program = std::string(EYEBRIDGE_TEST_PROGRAMS) + "/shows";
  const auto r = testing::run_program(
      {{"setsid", "-w", program}, {{"EYEBRIDGE_PANEL", "term"}, {"EYEBRIDGE_FAST", "true"}}, ""});
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_THAT(r.err, HasSubstr("EYEBRIDGE_PANEL: 'term' needs a terminal"));
}

}  // namespace
}  // namespace eyebridge
