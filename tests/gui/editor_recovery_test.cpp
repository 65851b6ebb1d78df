// Unsaved edits in the world editor: kept, offered after a kill, and dropped when a person says so.
#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QProcess>
#include <QStandardPaths>
#include <QTest>
#include <csignal>
#include <fstream>

#include <gmock/gmock.h>
#include <sys/resource.h>

#include "disk_spy.hpp"
#include "editor_rig.hpp"

namespace eyebridge::gui {
namespace {

using ::testing::HasSubstr;

constexpr const char* kRoomFile = "# A room.\nfloor 2000 2000\nposition 500 500 90\n0 0 2000 0\n";

class EditorRecovery : public testing::EditorRig {
 protected:
  void SetUp() override {
    EditorRig::SetUp();
    folder_.write("room.wld", kRoomFile);
    folder_.write("two.sim",
                  "world room.wld\nS4 500 500 0\nS4 1500 500 90\nerror robot:2 psd:1 4\n");
  }
  [[nodiscard]] std::string notice(const QString& topic) const {
    return window_->notices().text(topic).toStdString();
  }
  [[nodiscard]] static QDir kept() {
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/editor";
  }
  [[nodiscard]] bool is_kept() const {
    return !QDir(file("state")).isEmpty() && !kept().entryList({"*.autosave"}).isEmpty();
  }
  /// An editor of room.wld ends without a word, and a person opens the file again.
  void leave_edits() {
    open(file("room.wld"));
    drag(at(2, 0), at(2, 1));
    ASSERT_TRUE(QTest::qWaitFor([&] { return is_kept(); }, 60'000));
    open(file("room.wld"));
    ASSERT_NE(notice("recovery"), "");
  }
};

TEST_F(EditorRecovery, DiscardedEditsAreGone) {
  open(file("room.wld"));
  drag(at(2, 0), at(2, 1));
  ASSERT_TRUE(QTest::qWaitFor([&] { return is_kept(); }, 60'000));
  EXPECT_FALSE(window_->close());
  window_->answer(EditorWindow::Answer::Discard);
  EXPECT_FALSE(window_->isVisible());
  EXPECT_FALSE(is_kept());
  EXPECT_EQ(text_of("room.wld"), kRoomFile);
}

TEST_F(EditorRecovery, AKilledEditorsEditsAreOffered) {
  QProcess victim;
  victim.start(EYEBRIDGE_EDITOR_VICTIM, {file("two.sim")});
  ASSERT_TRUE(QTest::qWaitFor([&] { return is_kept(); }, 60'000));
  open(file("two.sim"));
  EXPECT_EQ(notice("recovery"), "") << "it lives: its edits are its own";
  window_.reset();
  victim.kill();  // -9
  ASSERT_TRUE(victim.waitForFinished());
  open(file("two.sim"));
  EXPECT_EQ(plan().robots.size(), 2U);
  ASSERT_THAT(notice("recovery"), HasSubstr("unsaved edits"));
  answer_notice("Recover them");
  ASSERT_EQ(plan().robots.size(), 3U);
  EXPECT_EQ(plan().robots[2].pose, (Pose{1, 1.5, 0}));
  EXPECT_EQ(plan().rest.errors.size(), 1U);
  EXPECT_TRUE(window_->isWindowModified());
  ASSERT_TRUE(window_->save()) << notice("save");
  EXPECT_FALSE(is_kept());
  EXPECT_EQ(text_of("room.wld"), kRoomFile);
}

TEST_F(EditorRecovery, ANewWorldOfAKilledEditorIsOfferedToo) {
  QProcess victim;
  victim.start(EYEBRIDGE_EDITOR_VICTIM, {});
  ASSERT_TRUE(QTest::qWaitFor([&] { return is_kept(); }, 60'000));
  victim.kill();
  ASSERT_TRUE(victim.waitForFinished());
  open("");
  answer_notice("Recover them");
  EXPECT_EQ(plan().robots.size(), 1U);
}

TEST_F(EditorRecovery, WhatWasLeftStaysUntilSomebodyHasAnswered) {
  leave_edits();
  drag(at(2, 0), at(1, 1));
  press_key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_THAT(text_of("room.wld"), HasSubstr("0 0 1000 1000"));
  open(file("room.wld"));
  EXPECT_NE(notice("recovery"), "") << "saving is no answer";
  drag(at(1, 1), at(0.5, 1));
  EXPECT_FALSE(window_->close());
  window_->answer(EditorWindow::Answer::Discard);
  open(file("room.wld"));
  EXPECT_NE(notice("recovery"), "") << "nor is letting go of one's own edits";
  drag(at(1, 1), at(0.5, 1));
  press_key(Qt::Key_Z, Qt::ControlModifier);
  open(file("room.wld"));
  answer_notice("Recover them");
  EXPECT_EQ(plan().walls.at(0).b, (Vec2{2, 1}));
}

TEST_F(EditorRecovery, AfterTheAnswerOwnEditsAreKeptAgain) {
  leave_edits();
  drag(at(2, 0), at(1, 1));
  answer_notice("Discard them");
  ASSERT_TRUE(QTest::qWaitFor([&] { return is_kept(); }, 60'000));
  open(file("room.wld"));
  answer_notice("Recover them");
  EXPECT_EQ(plan().walls.at(0).b, (Vec2{1, 1}));
}

TEST_F(EditorRecovery, WhatCannotBeRecoveredIsPutAside) {
  leave_edits();
  window_.reset();
  const QString name = kept().entryList({"*.autosave"}).value(0);
  std::ofstream(kept().filePath(name).toStdString()) << "half of it";
  open(file("room.wld"));
  answer_notice("Recover them");
  EXPECT_THAT(notice("unreadable"), HasSubstr("They are kept as " + kept().path().toStdString()));
  EXPECT_FALSE(is_kept());
  EXPECT_EQ(eyebridge::testing::file_text(kept().filePath(name + ".unreadable-1").toStdString()),
            "half of it");
}

TEST_F(EditorRecovery, WhoNeverRestsLosesNothing) {
  open(file("room.wld"));
  window_->set_autosave_delay(1000);
  drag(at(2, 0), at(2, 1));
  QElapsedTimer time;
  time.start();
  while (!is_kept() && time.elapsed() < 60'000) {
    press_key(Qt::Key_N);  // each tells of a change
    QApplication::processEvents();
  }
  EXPECT_TRUE(is_kept());
}

TEST_F(EditorRecovery, TheWindowWaitsForNoDisk) {
  open(file("room.wld"));
  const testing::DiskSpy disk(kept().path().toStdString());
  drag(at(2, 0), at(2, 1));
  ASSERT_TRUE(QTest::qWaitFor([&] { return is_kept(); }, 60'000));
  EXPECT_EQ(disk.own_syncs(), 0);
  EXPECT_GT(disk.other_syncs(), 0);
}

TEST_F(EditorRecovery, AFullDiskIsToldUntilThereIsRoomAgain) {
  open(file("room.wld"));
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit little{4, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &little);
  drag(at(2, 0), at(2, 1));
  EXPECT_TRUE(QTest::qWaitFor([&] { return !notice("autosave").empty(); }, 60'000));
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_THAT(notice("autosave"), HasSubstr("Unsaved edits are not kept"));
  EXPECT_FALSE(is_kept());
  drag(at(2, 1), at(1, 1));
  EXPECT_TRUE(QTest::qWaitFor([&] { return is_kept() && notice("autosave").empty(); }, 60'000));
}

TEST_F(EditorRecovery, AWindowThatGoesUnaskedKeepsTheEdits) {
  open(file("room.wld"));
  window_->set_autosave_delay(1'000'000);
  drag(at(2, 0), at(2, 1));
  window_.reset();
  EXPECT_TRUE(is_kept());
}

TEST_F(EditorRecovery, TheSameFileInTwoEditorsIsTold) {
  open(file("room.wld"));
  const auto first = std::move(window_);
  open(file("room.wld"));
  drag(at(2, 0), at(2, 1));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !notice("autosave").empty(); }, 60'000));
  EXPECT_THAT(notice("autosave"), HasSubstr("Another editor"));
}

}  // namespace
}  // namespace eyebridge::gui
