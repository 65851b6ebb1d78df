#include "eyebridge/bridges/guard/line_guard.hpp"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace eyebridge::bridges {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr int kPatience_ms = 20'000;

StopOrders orders_of(const std::string& stop, const std::string& answer) {
  const auto bytes = [](const std::string& text) {
    StopOrders::Bytes out;
    (void)out.add({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    return out;
  };
  StopOrders orders;
  orders.count = 1;
  orders.writes[0] = bytes(stop);
  orders.answer = bytes(answer);
  orders.mask = bytes(std::string(answer.size(), '\xFF'));
  orders.question = bytes("?");
  return orders;
}

/// What can be read from `descriptor` until `wanted` is in it; all of it until its end when that is
/// empty.
std::string read_until(int descriptor, const std::string& wanted = {}) {
  std::string got;
  char buffer[256];
  pollfd wait{descriptor, POLLIN, 0};
  while (wanted.empty() || got.find(wanted) == std::string::npos) {
    if (::poll(&wait, 1, kPatience_ms) <= 0) return got + " (nothing more came)";
    const ssize_t count = ::read(descriptor, buffer, sizeof buffer);
    if (count <= 0) break;
    got.append(buffer, static_cast<std::size_t>(count));
  }
  return got;
}

void write_text(int descriptor, const std::string& text) {
  ASSERT_EQ(::write(descriptor, text.data(), text.size()), static_cast<ssize_t>(text.size()));
}

/// The guard of this process: no other child of it is called so.
pid_t own_guard() {
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "stat");
    std::string name;
    std::string state;
    pid_t process = 0;
    pid_t parent = 0;
    if (file >> process >> name >> state >> parent && name == "(eb:guard)" &&
        parent == ::getpid()) {
      return process;
    }
  }
  return 0;
}

Time now() { return std::chrono::steady_clock::now().time_since_epoch(); }

/// A program in a process of its own, whose line to a robot this process has the other end of.
class LineGuardTest : public testing::Test {
 protected:
  void SetUp() override {
    int slave = -1;
    int board = -1;
    char name[64];
    ASSERT_EQ(::openpty(&board, &slave, name, nullptr, nullptr), 0);
    termios raw{};
    cfmakeraw(&raw);
    ASSERT_EQ(::tcsetattr(slave, TCSANOW, &raw), 0);
    board_.reset(board);
    line_.reset(slave);
    // A guard that is left over must not open the line of the next test.
    static int count = 0;
    path_ =
        ::testing::TempDir() + "line_" + std::to_string(::getpid()) + "_" + std::to_string(++count);
    std::filesystem::remove(path_);
    std::filesystem::create_symlink(name, path_);
  }
  void TearDown() override {
    std::filesystem::remove(path_);
    if (program_ > 0) {
      ::kill(program_, SIGKILL);
      ::waitpid(program_, nullptr, 0);
    }
  }

  /// `body` is the program, with a guard that holds its line.
  void run(const std::function<void(LineGuard&)>& body,
           const StopOrders& orders = orders_of("stop\r", "7.05")) {
    int ends[2];
    ASSERT_EQ(::pipe2(ends, O_CLOEXEC), 0);
    program_ = ::fork();
    ASSERT_GE(program_, 0);
    if (program_ == 0) {
      ::dup2(ends[1], STDERR_FILENO);
      auto guard = LineGuard::start();
      if (!guard || !(*guard)->hold(line_.get(), path_, orders)) ::_exit(3);
      body(**guard);
      ::_exit(0);
    }
    ::close(ends[1]);
    errors_.reset(ends[0]);
    line_.reset();
  }

  void expect_that_only_the_guard_goes_on() {
    pollfd errors{errors_.get(), POLLIN, 0};
    EXPECT_EQ(::poll(&errors, 1, 0), 1);
    EXPECT_EQ(errors.revents, POLLHUP) << "somebody could still write";
    read_until(board_.get(), "stop\r");
    EXPECT_THAT(read_until(board_.get(), "stop\r"), HasSubstr("stop\r"));
    write_text(board_.get(), "7.057.057.05");
    read_until(board_.get());  // until it, too, has ended
  }

  UniqueFd board_;
  UniqueFd line_;
  UniqueFd errors_;  ///< Messages of the program and its guard.
  std::string path_;
  pid_t program_ = -1;
};

TEST_F(LineGuardTest, AProgramThatIsGoneHasItsRobotStopped) {
  run([](LineGuard& guard) { (void)guard.turning(now()); });
  for (int i = 0; i < 3; ++i) {
    EXPECT_THAT(read_until(board_.get(), "stop\r"), HasSubstr("stop\r"));
    write_text(board_.get(), "7.05");
  }
  const std::string said = read_until(errors_.get());
  EXPECT_THAT(said, HasSubstr("guard of " + path_ + ": the program is gone"));
  EXPECT_THAT(said, HasSubstr("the robot stands, confirmed after "));
}

TEST_F(LineGuardTest, TwoAnswersMayBeToWhatTheProgramHadAsked) {
  run([](LineGuard& guard) { (void)guard.turning(now()); });
  write_text(board_.get(), "7.057.05");
  EXPECT_THAT(read_until(board_.get(), "stop\rstop\r"), HasSubstr("stop\rstop\r"));
  write_text(board_.get(), "7");
  write_text(board_.get(), ".05");
  EXPECT_THAT(read_until(errors_.get()), HasSubstr("the robot stands"));
}

TEST_F(LineGuardTest, ARobotThatStandsIsLeftAlone) {
  run([](LineGuard& guard) {
    (void)guard.turning(now());
    (void)guard.still();
  });
  EXPECT_EQ(read_until(errors_.get()), "");
  EXPECT_THAT(read_until(board_.get()), Not(HasSubstr("stop")));
}

TEST_F(LineGuardTest, ARobotThatNeverDroveIsStoppedWithoutAWord) {
  run([](LineGuard&) {});
  EXPECT_THAT(read_until(board_.get(), "stop\r"), HasSubstr("stop\r"));
  write_text(board_.get(), "7.057.057.05");
  EXPECT_EQ(read_until(errors_.get()), "");
  read_until(board_.get());  // until the guard has ended
}

TEST_F(LineGuardTest, WhoReadsItsMessagesIsNotKeptWaitingByARobotThatDoesNotAnswer) {
  run([](LineGuard& guard) { (void)guard.turning(now()); });
  EXPECT_THAT(read_until(errors_.get()),
              HasSubstr("for two minutes, of which nothing more is said here\n"));
  expect_that_only_the_guard_goes_on();
}

TEST_F(LineGuardTest, WhoReadsItsMessagesIsNotKeptWaitingWhereThereAreNone) {
  run([](LineGuard&) {});
  EXPECT_EQ(read_until(errors_.get()), "");
  expect_that_only_the_guard_goes_on();
}

TEST_F(LineGuardTest, MessagesThatNobodyReadsDoNotKeepItFromItsRobot) {
  run([](LineGuard& guard) {
    (void)guard.turning(now());
    const int flags = ::fcntl(STDERR_FILENO, F_GETFL);
    ::fcntl(STDERR_FILENO, F_SETFL, flags | O_NONBLOCK);
    const std::string page(4096, 'x');
    while (::write(STDERR_FILENO, page.data(), page.size()) > 0) {
    }
    ::fcntl(STDERR_FILENO, F_SETFL, flags);
  });
  EXPECT_THAT(read_until(board_.get(), "stop\r"), HasSubstr("stop\r"));
  write_text(board_.get(), "7.057.057.05");
  read_until(board_.get());  // until the guard has ended
}

TEST_F(LineGuardTest, AProgramThatIsKilledWhileItIsSilentIsGoneNotBack) {
  run([](LineGuard& guard) {
    (void)guard.turning(now());
    ::pause();
  });
  EXPECT_THAT(read_until(board_.get(), "stop\r"), HasSubstr("stop\r"));
  ::kill(program_, SIGKILL);
  const std::string said = read_until(errors_.get(), "program is gone");
  EXPECT_THAT(said, HasSubstr("the program is gone, and wheels may turn"));
  EXPECT_THAT(said, Not(HasSubstr("is back")));
  read_until(board_.get(), "stop\r");
  write_text(board_.get(), "7.057.057.05");
  EXPECT_THAT(read_until(errors_.get()), HasSubstr("the robot stands"));
}

TEST_F(LineGuardTest, AProgramThatIsSilentHasItsRobotStoppedAndGoesOn) {
  run([](LineGuard& guard) {
    (void)guard.turning(now());
    ::pause();
  });
  EXPECT_THAT(read_until(board_.get(), "stop\r"), HasSubstr("stop\r"));
  write_text(board_.get(), "7.057.057.05");
  EXPECT_THAT(read_until(errors_.get(), "stands"), HasSubstr("has been silent for half a second"));
  EXPECT_EQ(::waitpid(program_, nullptr, WNOHANG), 0);
}

TEST_F(LineGuardTest, ALineThatWasLostIsOpenedAgain) {
  const int line = line_.get();
  run([line](LineGuard& guard) {
    (void)guard.turning(now());
    if (!guard.let_go()) ::_exit(3);
    ::close(line);
  });
  std::string heard;
  pollfd said{errors_.get(), POLLIN, 0};
  while (heard.find('?') == std::string::npos) {
    ASSERT_EQ(said.revents & POLLHUP, 0) << "the guard has ended: " << read_until(errors_.get());
    // Nobody has the line open for a moment: that is an end of file here.
    heard += read_until(board_.get(), "?");
    ASSERT_GE(::poll(&said, 1, 0), 0);
  }
  EXPECT_THAT(heard, Not(HasSubstr("stop"))) << "nobody knows yet that it is the same board";
  write_text(board_.get(), "7.05");
  EXPECT_THAT(read_until(board_.get(), "stop\r"), HasSubstr("stop\r"));
  write_text(board_.get(), "7.057.057.05");
  EXPECT_THAT(read_until(errors_.get()), HasSubstr("the robot stands"));
}

TEST_F(LineGuardTest, ANewProgramHasTheLineAndTheGuardLeaves) {
  run([](LineGuard& guard) { (void)guard.turning(now()); });
  EXPECT_THAT(read_until(board_.get(), "stop\r"), HasSubstr("stop\r"));
  const UniqueFd line(::open(path_.c_str(), O_RDWR | O_NOCTTY));
  ASSERT_EQ(::flock(line.get(), LOCK_EX), 0);
  EXPECT_THAT(read_until(errors_.get()), HasSubstr("another program has the robot now"));
}

TEST_F(LineGuardTest, OfFramesTheMaskedBitsCount) {
  int ends[2];
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends), 0);
  line_.reset(ends[0]);
  board_.reset(ends[1]);
  StopOrders orders = orders_of("stop", "id 4 ");
  orders.mask.bytes[3] = 0xF0;  // any digit
  orders.frames = true;
  orders.question.size = 0;
  run([](LineGuard& guard) { (void)guard.turning(now()); }, orders);
  EXPECT_EQ(read_until(board_.get(), "stop"), "stop");
  for (int i = 0; i < 3; ++i) write_text(board_.get(), "or 7 is another frame");
  for (int i = 0; i < 3; ++i) write_text(board_.get(), "is id 7 no beginning");
  EXPECT_THAT(read_until(board_.get(), "stopstop"), HasSubstr("stopstop"));
  for (int i = 0; i < 3; ++i) write_text(board_.get(), "id 7 and more");
  EXPECT_THAT(read_until(errors_.get()), HasSubstr("the robot stands"));
}

TEST_F(LineGuardTest, AFrameOfAnotherProgramMakesTheGuardLeave) {
  int ends[2];
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends), 0);
  line_.reset(ends[0]);
  board_.reset(ends[1]);
  StopOrders orders = orders_of("stop", "stands");
  orders.frames = true;
  orders.question.size = 0;
  const std::string taken = "speed";
  (void)orders.taken.add({reinterpret_cast<const std::uint8_t*>(taken.data()), taken.size()});
  run([](LineGuard& guard) { (void)guard.turning(now()); }, orders);
  EXPECT_EQ(read_until(board_.get(), "stop"), "stop");
  write_text(board_.get(), "spee");
  EXPECT_THAT(read_until(board_.get(), "stopstop"), HasSubstr("stopstop"));
  write_text(board_.get(), "speed 0");
  EXPECT_THAT(read_until(errors_.get()), HasSubstr("another program has the robot now"));
}

TEST_F(LineGuardTest, AGuardThatWasEndedIsAnError) {
  int ends[2];
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
  const auto guard = LineGuard::start();
  ASSERT_TRUE(guard) << guard.error().what;
  ASSERT_TRUE((*guard)->hold(ends[0], "", orders_of("stop", "7.05")));
  ASSERT_TRUE((*guard)->let_go());  // it answers: it has its name by now
  ::close(ends[0]);
  ::close(ends[1]);
  const pid_t process = own_guard();
  ASSERT_GT(process, 0);
  ASSERT_EQ(::kill(process, SIGKILL), 0);
  Result<void> told;
  for (Time time = now(); told; time += std::chrono::seconds(1)) told = (*guard)->turning(time);
  EXPECT_EQ(told.error().code, Errc::Disconnected);
  EXPECT_THAT(told.error().what, HasSubstr("the guard, which stops the motors"));
}

}  // namespace
}  // namespace eyebridge::bridges
