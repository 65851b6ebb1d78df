// What becomes of unsaved texts, and of programs, when the code panel ends without a word.
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <csignal>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include "code_room.hpp"
#include "disk_spy.hpp"
#include "person.hpp"
#include "running_program.hpp"

namespace eyebridge::gui {
namespace {

using eyebridge::testing::RunningProgram;
using ::testing::HasSubstr;

class CodeDrafts : public testing::CodeRoom {
 protected:
  void answer(QMessageBox::StandardButton button) {
    auto& box = dialog<QMessageBox>();
    QTest::mouseClick(box.button(button), Qt::LeftButton);
  }
  std::string notice() { return page().notice().text(Page::kTopic).toStdString(); }
  /// What is kept for after a crash, one text behind the other.
  std::string drafts_text() {
    std::string texts;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(settings_.drafts.toStdString())) {
      if (entry.path().extension() == ".json") texts += eyebridge::testing::file_text(entry.path());
    }
    return texts;
  }
  /// How many texts are kept for after a crash.
  int drafts() {
    int count = 0;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(settings_.drafts.toStdString())) {
      count += entry.path().extension() == ".json" ? 1 : 0;
    }
    return count;
  }
};

TEST_F(CodeDrafts, ClosingWithoutSavingForgets) {
  open({write("a.c", "int a;\n")});
  type("x");
  ASSERT_TRUE(QTest::qWaitFor([&] { return drafts() == 1; }, 60'000));
  EXPECT_FALSE(window().close());
  answer(QMessageBox::Discard);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window().isVisible(); }, 60'000));
  EXPECT_EQ(file("a.c"), "int a;\n");
  EXPECT_EQ(drafts(), 0);
}

TEST_F(CodeDrafts, TheWindowWaitsForNoDisk) {
  open({write("a.c", "int a;\n")});
  const testing::DiskSpy disk(settings_.drafts.toStdString());
  type("x");
  ASSERT_TRUE(QTest::qWaitFor([&] { return disk.own_syncs() + disk.other_syncs() > 0; }, 60'000));
  ASSERT_TRUE(QTest::qWaitFor([&] { return drafts() == 1; }, 60'000));
  EXPECT_EQ(disk.own_syncs(), 0);
}

TEST_F(CodeDrafts, WhatTheDiskRefusesIsTold) {
  open({write("a.c", "int a;\n")});
  testing::DiskSpy disk(settings_.drafts.toStdString());
  type("x");
  ASSERT_TRUE(QTest::qWaitFor([&] { return drafts() == 1; }, 60'000));
  disk.refuse_name(".json");  // in the place of the first one
  type("y");
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return window().state().contains("Unsaved texts cannot be kept in"); }, 60'000));
}

TEST_F(CodeDrafts, TextsOfAWindowThatWasNotClosedAreThereAgain) {
  open({write("a.c", "int a;\n")});
  type("x");
  action("Python program").trigger();
  type("y");
  open();  // the window goes, a new one comes
  ASSERT_EQ(window().page_count(), 2);
  EXPECT_EQ(page().name(), "program.py");
  EXPECT_TRUE(page().is_modified());
  EXPECT_THAT(editor().text().toStdString(), HasSubstr("yfrom eye import"));
  window().tabs().setCurrentIndex(0);
  EXPECT_EQ(editor().text(), "xint a;\n");
  EXPECT_EQ(file("a.c"), "int a;\n");
  EXPECT_THAT(notice(), HasSubstr("These changes to a.c were not saved"));
  click_notice("Go back to the saved file");
  EXPECT_EQ(editor().text(), "int a;\n");
  EXPECT_FALSE(page().is_modified());
}

TEST_F(CodeDrafts, KillDoesNotLoseWhatWasTyped) {
  const std::string program = write("a.c", "int a;\n").toStdString();
  const std::vector<std::string> command{EYEBRIDGE_BIN "/code_program",
                                         settings_.drafts.toStdString(), program};
  const eyebridge::testing::ProgramStart start{
      command, {{"XDG_CONFIG_HOME", folder_.path()}}, folder_.path()};
  std::filesystem::create_directory(settings_.drafts.toStdString());
  testing::Person person;
  {
    RunningProgram panel(start);
    const auto window = person.window("a.c");
    for (int i = 0; i < 3; ++i) person.type(window, 'k');
    // The third letter may come after the first draft.
    const auto is_kept = [&] { return drafts_text().find("kkkint") != std::string::npos; };
    ASSERT_TRUE(QTest::qWaitFor(is_kept, 60'000)) << panel.said();
    EXPECT_EQ(panel.finish(SIGKILL), 128 + SIGKILL);
  }
  EXPECT_EQ(file("a.c"), "int a;\n");
  open();
  ASSERT_EQ(page().name(), "a.c");
  EXPECT_EQ(editor().text(), "kkkint a;\n");
  EXPECT_TRUE(page().is_modified());
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(file("a.c"), "kkkint a;\n");
}

TEST_F(CodeDrafts, AProgramEndsWithAPanelThatIsKilled) {
  const std::string program =
      write("a.py", "import os, time\nwith open('" + path("pid.new").toStdString() +
                        "', 'w') as f: f.write(str(os.getpid()))\nos.rename('" +
                        path("pid.new").toStdString() + "', '" + path("pid").toStdString() +
                        "')\nwhile True: time.sleep(0.1)\n")
          .toStdString();
  const std::vector<std::string> command{EYEBRIDGE_BIN "/code_program",
                                         settings_.drafts.toStdString(), program};
  const eyebridge::testing::ProgramStart start{
      command,
      {{"XDG_CONFIG_HOME", folder_.path()},
       {"EYEBRIDGE_TEST_COMMAND", settings_.eyebridge.toStdString()}},
      folder_.path()};
  testing::Person person;
  RunningProgram panel(start);
  constexpr std::uint32_t kF5 = 0xffc2;  // of keysymdef.h
  person.press(person.window("a.py"), kF5);
  ASSERT_TRUE(QTest::qWaitFor([&] { return QFileInfo::exists(path("pid")); }, 60'000))
      << panel.said();
  const std::string pid = file("pid");
  EXPECT_EQ(panel.finish(SIGKILL), 128 + SIGKILL);
  // Gone, or waiting for init to look after it.
  const auto is_over = [&] {
    const std::string stat = eyebridge::testing::file_text("/proc/" + pid + "/stat");
    return stat.empty() || stat.find(") Z") != std::string::npos;
  };
  const bool ended = QTest::qWaitFor(is_over, 60'000);
  EXPECT_TRUE(ended);
  if (!ended) kill(static_cast<pid_t>(std::stoi(pid)), SIGKILL);
}

TEST_F(CodeDrafts, DraftsOfAPanelThatLivesAreItsOwn) {
  open({write("a.c", "int a;\n")});
  type("x");
  ASSERT_TRUE(QTest::qWaitFor([&] { return drafts() == 1; }, 60'000));
  CodeWindow second({}, settings_);
  EXPECT_EQ(second.page_count(), 1);
  EXPECT_EQ(second.page()->name(), "program.c");
}

TEST_F(CodeDrafts, DraftsThatAreNoneAreLeftAndNamed) {
  std::filesystem::create_directories(settings_.drafts.toStdString() + "/old");
  std::ofstream(settings_.drafts.toStdString() + "/old/1.json") << "{\"text\": 3}";
  open();
  EXPECT_THAT(window().state().toStdString(),
              HasSubstr("old/1.json cannot be recovered: it is no draft"));
  EXPECT_TRUE(QFileInfo::exists(settings_.drafts + "/old/1.json"));
}

}  // namespace
}  // namespace eyebridge::gui
