// Processes of the code panel: how they end, and what is seen of them.
#include "code/runner.hpp"

#include <QTest>
#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "code/output_view.hpp"
#include "run_program.hpp"

namespace eyebridge::gui {
namespace {

using ::testing::HasSubstr;

class Run : public ::testing::Test {
 protected:
  Run() {
    runner_.on_output = [this](const QByteArray& bytes) { output_ += bytes; };
    runner_.on_state = [this](const QString& how) { state_ = how; };
    runner_.on_end = [this](bool well) { well_ = well; };
  }
  void shell(const char* script) {
    runner_.start({{Step::Kind::Run, "/bin/sh", {"-c", script}, "/"}});
  }
  void wait_for(const char* text) {
    ASSERT_TRUE(QTest::qWaitFor([&] { return output_.contains(text); }, 60'000))
        << output_.toStdString();
  }
  void wait_for_end() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return runner_.state() == Runner::State::Idle; }, 60'000));
  }

  Runner runner_{nullptr};
  QByteArray output_;
  QString state_;
  std::optional<bool> well_;
};

TEST_F(Run, BothOutputsComeInTheirOrder) {
  shell("echo one; echo two >&2; echo three");
  wait_for_end();
  EXPECT_EQ(output_.toStdString(), "one\ntwo\nthree\n");
  EXPECT_EQ(well_, true);
  EXPECT_THAT(state_.toStdString(), HasSubstr("Ended with exit code 0 after"));
}

TEST_F(Run, AStepThatFailsIsTheLast) {
  runner_.start({{Step::Kind::Run, "/bin/sh", {"-c", "echo first; exit 3"}, "/"},
                 {Step::Kind::Run, "/bin/sh", {"-c", "echo second"}, "/"}});
  wait_for_end();
  EXPECT_EQ(output_.toStdString(), "first\n");
  EXPECT_EQ(well_, false);
  EXPECT_THAT(state_.toStdString(), HasSubstr("exit code 3"));
}

TEST_F(Run, ACrashIsNamed) {
  shell("kill -SEGV $$");
  wait_for_end();
  EXPECT_EQ(state_, "Crashed: Segmentation fault");
}

TEST_F(Run, NothingToReadIsThereToWaitFor) {
  shell("cat; echo end");
  wait_for_end();
  EXPECT_EQ(output_.toStdString(), "end\n");
}

TEST_F(Run, WhoListensIsAskedToEnd) {
  shell("trap 'echo asked; exit 0' TERM; echo ready; while :; do sleep 0.01; done");
  wait_for("ready");
  runner_.stop();
  EXPECT_EQ(state_, "Stopping");
  wait_for_end();
  EXPECT_TRUE(output_.endsWith("asked\n")) << output_.toStdString();
  EXPECT_EQ(state_, "Stopped");
  EXPECT_EQ(well_, false);
}

TEST_F(Run, WhoDoesNotListenIsKilled) {
  shell("trap '' TERM; echo ready; while :; do sleep 0.01; done");
  wait_for("ready");
  runner_.stop();
  wait_for_end();
  EXPECT_EQ(state_, "Stopped");
}

TEST_F(Run, WhatAProgramStartedEndsWithIt) {
  shell("sleep 1000 & echo $!; wait");
  wait_for("\n");
  runner_.stop();
  wait_for_end();
  const auto pid = static_cast<pid_t>(output_.trimmed().toInt());
  ASSERT_GT(pid, 1);
  // Gone, or waiting for init to look after it.
  const std::string stat = "/proc/" + std::to_string(pid) + "/stat";
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        const std::string text = eyebridge::testing::file_text(stat);
        return text.empty() || text.find(") Z") != text.npos;
      },
      60'000));
}

// The windows' thread takes no signals, and children inherit what their parent blocks.
TEST_F(Run, SignalsThatAreBlockedHereReachThePrograms) {
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  shell("grep SigBlk /proc/self/status");
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  wait_for_end();
  EXPECT_EQ(output_.toStdString(), "SigBlk:\t0000000000000000\n");
}

TEST_F(Run, WhatCannotBeStartedSaysWhy) {
  runner_.start({{Step::Kind::Run, "/nowhere/eyebridge", {}, "/"}});
  wait_for_end();
  EXPECT_THAT(state_.toStdString(), HasSubstr("/nowhere/eyebridge cannot be started: "));
  runner_.start({{Step::Kind::Run, "/bin/true", {}, "/nowhere"}});
  wait_for_end();
  EXPECT_THAT(state_.toStdString(), HasSubstr("/bin/true cannot be started: "));
  shell("echo again");
  wait_for_end();
  EXPECT_EQ(output_.toStdString(), "again\n") << "the next run is as any";
}

TEST(OutputView, MuchOutputIsLeftOutAndTheWindowLives) {
  OutputView view(nullptr);
  view.add(QByteArray("first\n"));
  view.flush();
  QByteArray line(99, 'x');
  line += '\n';
  for (int i = 0; i < 20'000; ++i) view.add(line);
  view.add("last\n");
  view.flush();
  const QString text = view.toPlainText();
  EXPECT_TRUE(text.contains(" kB left out]"));
  EXPECT_TRUE(text.endsWith("last\n"));
  EXPECT_LE(view.blockCount(), OutputView::kMostLines);
}

TEST(OutputView, BytesMayBeCutAnywhereAndLinesMayHaveNoEnd) {
  OutputView view(nullptr);
  for (const char c : std::string("caf\xc3\xa9 \x1b[31mred\x1b[0m\r\n\a"))
    view.add(QByteArray(1, c));
  view.flush();
  EXPECT_EQ(view.toPlainText().toStdString(), "caf\xc3\xa9 red\n");
  view.start_anew();
  view.add(QByteArray(3 * OutputView::kLongestLine, 'x'));
  view.flush();
  EXPECT_EQ(view.blockCount(), 3);
}

TEST(OutputView, AMessageThatComesInPiecesIsOne) {
  OutputView view(nullptr);
  std::vector<int> lines;
  view.on_message = [&](const Message& message) { lines.push_back(message.line); };
  for (const char* const piece : {"a.c:1", "2:3: err", "or: x\nb.c", ":4: y\n"}) {
    view.add(piece);
    view.flush();
  }
  EXPECT_EQ(lines, (std::vector{12, 4}));
}

}  // namespace
}  // namespace eyebridge::gui
