// How programs end, whatever way, and what is left of their run.

#include <csignal>
#include <filesystem>
#include <thread>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include "eyebridge/base/unique_fd.hpp"
#include "named_program.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using testing::kClocks;
using testing::ProgramRun;
using testing::run_named;
using testing::ScratchFolder;

void expect_results(const ScratchFolder& folder) {
  for (const char* name : {"map.png", "lcd.png", "trace.csv"}) {
    EXPECT_GT(std::filesystem::file_size(folder.path() + "/" + name), 100U) << name;
  }
}

ProgramRun end_by(const std::string& how, std::map<std::string, std::string> settings,
                  const ScratchFolder& folder) {
  settings["EYEBRIDGE_TEST_HOW"] = how;
  settings["EYEBRIDGE_OUT"] = folder.path();
  return run_named("ends", settings);
}

TEST(ProgramEnd, ResultsAreWrittenHoweverAProgramEnds) {
  const std::map<std::string, int> ways = {
      {"return", 5}, {"timer", 7}, {"signal", 128 + 15}, {"main left", 128 + 15}};
  for (const auto& clock : kClocks) {
    for (const auto& [how, code] : ways) {
      const ScratchFolder folder;
      const ProgramRun r = end_by(how, clock, folder);
      EXPECT_EQ(r.exit_code, code) << how << r.err;
      expect_results(folder);
    }
  }
}

TEST(ProgramEnd, ATimeLimitEndsThreadsThatPollAndMainsThatSleep) {
  for (const auto& clock : kClocks) {
    for (const char* how : {"wait", "idle"}) {
      const ScratchFolder folder;
      auto settings = clock;
      settings["EYEBRIDGE_TIME_LIMIT"] = "1s";
      EXPECT_EQ(end_by(how, settings, folder).exit_code, 0) << how;
      expect_results(folder);
    }
  }
}

TEST(ProgramEnd, CallsAfterTheEndMoveNothing) {
  const ScratchFolder folder;
  EXPECT_THAT(end_by("return", {}, folder).out, HasSubstr("late call 1\n"));
}

TEST(ProgramEnd, AFullDiskFailsTheRunButDoesNotStopTheRobot) {
  const ScratchFolder folder;
  std::filesystem::create_symlink("/dev/full", folder.path() + "/trace.csv");
  const ProgramRun r = run_named("textbook", {{"EYEBRIDGE_KEYS", "KEY1@1s,KEY2@2s,KEY4@60s"},
                                              {"EYEBRIDGE_OUT", folder.path()}});
  EXPECT_EQ(r.exit_code, 1);
  EXPECT_THAT(r.err, HasSubstr("trace.csv: No space left on device"));
  EXPECT_THAT(r.out, HasSubstr("size 320")) << "the program ran to its end";
  EXPECT_TRUE(std::filesystem::exists(folder.path() + "/map.png")) << "the rest is written";
}

TEST(ProgramEnd, PicturesThatCannotBeWrittenFailTheRun) {
  for (const char* taken : {"map.png", "lcd.png", "frames"}) {
    const ScratchFolder folder;
    const std::string path = folder.path() + "/" + taken;
    folder.write("trace.csv", "");  // of an earlier run
    if (std::string(taken) == "frames") {
      folder.write(taken, "a file where a folder belongs");
    } else {
      std::filesystem::create_directory(path);
    }
    const ProgramRun r = run_named("textbook", {{"EYEBRIDGE_KEYS", "KEY1@1s,KEY2@2s,KEY4@60s"},
                                                {"EYEBRIDGE_OUT", folder.path()}});
    EXPECT_EQ(r.exit_code, 1) << taken;
    EXPECT_THAT(r.err, HasSubstr(taken));
  }
}

TEST(ProgramEnd, AFailureOfTheProgramCountsMoreThanOneOfItsResults) {
  const ScratchFolder folder;
  folder.write("trace.csv", "");
  std::filesystem::create_directory(folder.path() + "/map.png");
  EXPECT_EQ(end_by("return", {}, folder).exit_code, 5);
}

TEST(ProgramEnd, AReportOrRecordingThatIsNotWholeFailsTheRun) {
  const ProgramRun report = run_named("driving", {{"EYEBRIDGE_REPORT", "/dev/full"}});
  EXPECT_EQ(report.exit_code, 1);
  EXPECT_THAT(report.err, HasSubstr("the report /dev/full could not be written: No space left"));
  // The system's limit for the size of a file is a disk that is full.
  const ScratchFolder folder;
  const std::string program = std::string(EYEBRIDGE_TEST_PROGRAMS) + "/textbook";
  const ProgramRun record =
      testing::run_program({{"sh", "-c", "trap '' XFSZ; ulimit -f 100; exec " + program},
                            {{"EYEBRIDGE_FAST", "true"},
                             {"EYEBRIDGE_KEYS", "KEY1@1s,KEY2@2s,KEY4@60s"},
                             {"EYEBRIDGE_RECORD", folder.path() + "/full.ebrec"}},
                            ""});
  EXPECT_EQ(record.exit_code, 1);
  EXPECT_THAT(record.err, HasSubstr("full.ebrec is not whole: "));
  EXPECT_THAT(record.out, HasSubstr("size 320")) << "the program ran to its end";
}

TEST(ProgramEnd, ResultsReplaceNothingButResults) {
  const ScratchFolder folder;
  const std::string work = folder.write("robot.c", "int main() {}\n");
  const ProgramRun report = run_named("driving", {{"EYEBRIDGE_REPORT", work}});
  EXPECT_EQ(report.exit_code, 2);
  EXPECT_THAT(report.err, HasSubstr("EYEBRIDGE_REPORT: cannot write " + work));
  EXPECT_EQ(testing::file_text(work), "int main() {}\n");
  folder.write("map.png", "drawn by hand");
  const ProgramRun out = run_named("driving", {{"EYEBRIDGE_OUT", folder.path()}});
  EXPECT_EQ(out.exit_code, 2);
  EXPECT_THAT(out.err, HasSubstr("found map.png and no trace.csv"));
  EXPECT_EQ(testing::file_text(folder.path() + "/map.png"), "drawn by hand");
  // A folder of results that came from somewhere has links in it.
  const std::string came = folder.path() + "/came";
  std::filesystem::create_directory(came);
  folder.write("came/trace.csv", "");
  for (const char* const name : {"lcd.png", "lcd.txt", "map.png", "collisions.csv"}) {
    std::filesystem::create_symlink(work, came + "/" + name);
  }
  std::filesystem::create_symlink(folder.path(), came + "/frames");
  const ProgramRun linked = run_named("driving", {{"EYEBRIDGE_OUT", came}});
  EXPECT_EQ(linked.exit_code, 0) << linked.err;
  EXPECT_EQ(testing::file_text(work), "int main() {}\n");
  EXPECT_FALSE(std::filesystem::is_symlink(came + "/lcd.txt"));
  // Twice into one place is what people do.
  for (int i = 0; i < 2; ++i) {
    const ProgramRun again = run_named("driving", {{"EYEBRIDGE_OUT", folder.path() + "/own"},
                                                   {"EYEBRIDGE_REPORT", folder.path() + "/r"}});
    EXPECT_EQ(again.exit_code, 0) << again.err;
  }
}

TEST(ProgramEnd, TwoRunsDoNotWriteOneFolderOfResults) {
  const ScratchFolder folder;
  UniqueFd other(open(folder.path().c_str(), O_RDONLY | O_DIRECTORY));  // as a run has it
  ASSERT_EQ(flock(other.get(), LOCK_EX), 0);
  const ProgramRun refused = run_named("driving", {{"EYEBRIDGE_OUT", folder.path()}});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("another run writes its results there now"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() + "/trace.csv"));
  other.reset();
  EXPECT_EQ(run_named("driving", {{"EYEBRIDGE_OUT", folder.path()}}).exit_code, 0);
}

/// A program at a terminal of its own; the test is the person.
class AtATerminal {
 public:
  AtATerminal(const std::string& name, const std::string& out) {
    pid_ = forkpty(&person_, nullptr, nullptr, nullptr);
    if (pid_ != 0) return;
    setenv("EYEBRIDGE_OUT", out.c_str(), 1);
    const std::string program = std::string(EYEBRIDGE_TEST_PROGRAMS) + "/" + name;
    execl(program.c_str(), program.c_str(), nullptr);
    _exit(127);
  }
  ~AtATerminal() { close(person_); }
  AtATerminal(const AtATerminal&) = delete;
  AtATerminal& operator=(const AtATerminal&) = delete;

  [[nodiscard]] bool has_ended() const {
    siginfo_t end{};
    EXPECT_EQ(waitid(P_PID, static_cast<id_t>(pid_), &end, WEXITED | WNOHANG | WNOWAIT), 0);
    return end.si_pid != 0;
  }
  [[nodiscard]] bool takes_lines() const {
    termios mode{};
    EXPECT_EQ(tcgetattr(person_, &mode), 0);
    return (mode.c_lflag & ICANON) != 0;
  }
  /// Reads what the program prints until `text` comes; fails when it ends before.
  void await(const std::string& text) {
    char c = 0;
    while (printed_.find(text) == std::string::npos && read(person_, &c, 1) == 1) printed_ += c;
    ASSERT_THAT(printed_, HasSubstr(text));
  }
  void type(char c) const { ASSERT_EQ(write(person_, &c, 1), 1); }
  int wait() {
    int status = 0;
    char text[256];
    while (read(person_, text, sizeof text) > 0) {
    }
    EXPECT_EQ(waitpid(pid_, &status, 0), pid_);
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  }

 private:
  int person_ = -1;
  pid_t pid_ = -1;
  std::string printed_;
};

TEST(ProgramEnd, CtrlCWhileAKeyIsAwaitedLeavesTheTerminalAsItWas) {
  const ScratchFolder folder;
  AtATerminal program("awaits_key", folder.path());
  program.await("waiting");
  while (program.takes_lines() && !program.has_ended()) std::this_thread::yield();
  program.type('\x03');
  EXPECT_EQ(program.wait(), 128 + SIGINT);
  EXPECT_TRUE(program.takes_lines());
  expect_results(folder);
}

}  // namespace
}  // namespace eyebridge
