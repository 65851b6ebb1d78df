// What becomes of files.
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <csignal>
#include <filesystem>

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "code_room.hpp"

namespace eyebridge::gui {
namespace {

using ::testing::HasSubstr;

class CodeFiles : public testing::CodeRoom {
 protected:
  void answer(QMessageBox::StandardButton button) {
    auto& box = dialog<QMessageBox>();
    QTest::mouseClick(box.button(button), Qt::LeftButton);
  }
  std::string notice() { return page().notice().text(Page::kTopic).toStdString(); }
};

TEST_F(CodeFiles, SavedAsItWasRead) {
  for (const char* const text :
       {"a\r\nb\r\n", "\xef\xbb\xbfmark\n", "caf\xe9\n", "caf\xc3\xa9\n", "", "no end"}) {
    open({write("a.c", text)});
    EXPECT_FALSE(page().is_modified());
    press(Qt::Key_Home, Qt::ControlModifier);
    type("x");
    press(Qt::Key_S, Qt::ControlModifier);
    std::string expected = text;
    expected.insert(expected.starts_with("\xef\xbb\xbf") ? 3 : 0, "x");
    EXPECT_EQ(file("a.c"), expected);
    press(Qt::Key_Backspace);
    press(Qt::Key_S, Qt::ControlModifier);
    EXPECT_EQ(file("a.c"), text);
  }
  open({write("a.c", "a\r\n")});
  press(Qt::Key_End, Qt::ControlModifier);
  type("\n");
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(file("a.c"), "a\r\n\r\n") << "new lines end as the others";
}

TEST_F(CodeFiles, WhatIsNoTextIsNotOpened) {
  open();
  EXPECT_EQ(window().open_file(write("a.bin", std::string("a\0b", 3))), nullptr);
  EXPECT_THAT(window().state().toStdString(),
              HasSubstr("a.bin is no text: there are zero bytes in it"));
  EXPECT_EQ(window().open_file(path("nowhere.c")), nullptr);
  EXPECT_THAT(window().state().toStdString(), HasSubstr("nowhere.c cannot be read"));
  EXPECT_EQ(window().open_file(path(".")), nullptr);
  EXPECT_THAT(window().state().toStdString(), HasSubstr("is a folder; expected a text file"));
  EXPECT_EQ(window().page_count(), 1);
}

TEST_F(CodeFiles, AFileIsOpenOnce) {
  open({write("a.c", "int a;\n"), write("b.c", "")});
  ASSERT_EQ(window().page_count(), 2);
  EXPECT_EQ(window().open_file(path("./a.c"))->name(), "a.c");
  EXPECT_EQ(window().page_count(), 2);
  EXPECT_EQ(page().name(), "a.c");
  press(Qt::Key_PageDown, Qt::ControlModifier);
  EXPECT_EQ(page().name(), "b.c");
  press(Qt::Key_PageUp, Qt::ControlModifier);
  EXPECT_EQ(page().name(), "a.c");
}

TEST_F(CodeFiles, SaveAsKeepsTheOldFileAndTakesTheNewLanguage) {
  open({write("a.c", "int a;\n")});
  press(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
  auto& chooser = dialog<QFileDialog>();
  chooser.selectFile(path("b.py"));
  auto* const buttons = chooser.findChild<QDialogButtonBox*>();
  QTest::mouseClick(buttons->button(QDialogButtonBox::Save), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return page().name() == "b.py"; }, 60'000));
  EXPECT_EQ(file("b.py"), "int a;\n");
  EXPECT_EQ(file("a.c"), "int a;\n");
  EXPECT_EQ(editor().language(), Language::Python);
  type("x");
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(file("b.py"), "xint a;\n");
}

TEST_F(CodeFiles, ExamplesStayAsTheyAre) {
  const QDir examples(QString(EYEBRIDGE_SOURCE_DIR "/examples"));
  const std::string before =
      eyebridge::testing::file_text(EYEBRIDGE_SOURCE_DIR "/examples/square.c");
  open();
  action("square.c").trigger();
  EXPECT_EQ(editor().text().toStdString(), before);
  EXPECT_EQ(page().path(), "");
  type("// mine\n");
  press(Qt::Key_S, Qt::ControlModifier);
  dialog<QFileDialog>().reject();
  EXPECT_FALSE(window().save_as(page(), examples.filePath("square.c")));
  EXPECT_THAT(notice(), HasSubstr("is an example, which stays as it is"));
  EXPECT_EQ(eyebridge::testing::file_text(EYEBRIDGE_SOURCE_DIR "/examples/square.c"), before);
  EXPECT_TRUE(window().save_as(page(), path("square.c")));
  EXPECT_EQ(file("square.c"), "// mine\n" + before);
}

TEST_F(CodeFiles, WhatChangedOnDiskIsOfferedAndNothingIsLost) {
  open({write("a.c", "int a;\n")});
  write("a.c", "int b;\n");
  ASSERT_TRUE(QTest::qWaitFor([&] { return page().notice().isVisible(); }, 60'000));
  EXPECT_EQ(notice(), "a.c was changed on the disk.");
  click_notice("Load it");
  EXPECT_EQ(editor().text(), "int b;\n");
  EXPECT_FALSE(page().is_modified());
  type("x");
  write("a.c", "int c;\n");
  ASSERT_TRUE(QTest::qWaitFor([&] { return page().notice().isVisible(); }, 60'000));
  EXPECT_THAT(notice(), HasSubstr("changed on the disk, and here, too"));
  EXPECT_EQ(editor().text(), "xint b;\n");
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(file("a.c"), "int c;\n") << "not overwritten unasked";
  click_notice("Load it");
  EXPECT_EQ(editor().text(), "int c;\n");
  editor().undo();
  EXPECT_EQ(editor().text(), "xint b;\n") << "it can be had back";
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(file("a.c"), "xint b;\n");
}

TEST_F(CodeFiles, OverwritesWhenAPersonSaysSo) {
  open({write("a.c", "int a;\n")});
  type("x");
  write("a.c", "int c;\n");
  ASSERT_TRUE(QTest::qWaitFor([&] { return page().notice().isVisible(); }, 60'000));
  click_notice("Overwrite it");
  EXPECT_EQ(file("a.c"), "xint a;\n");
  EXPECT_FALSE(page().notice().isVisible());
}

TEST_F(CodeFiles, AFileThatIsReplacedIsStillWatched) {
  open({write("a.c", "int a;\n")});
  for (const char* const text : {"int b;\n", "int c;\n"}) {
    write("new", text);
    std::filesystem::rename(path("new").toStdString(), path("a.c").toStdString());
    ASSERT_TRUE(QTest::qWaitFor([&] { return page().notice().isVisible(); }, 60'000)) << text;
    click_notice("Load it");
    EXPECT_EQ(editor().text(), text);
  }
}

TEST_F(CodeFiles, AFileThatIsRemovedCanBeSavedAgain) {
  open({write("a.c", "int a;\n")});
  std::filesystem::remove(path("a.c").toStdString());
  ASSERT_TRUE(QTest::qWaitFor([&] { return page().notice().isVisible(); }, 60'000));
  EXPECT_EQ(notice(), "a.c was removed from the disk. Saving writes it again.");
  EXPECT_TRUE(page().is_modified());
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(file("a.c"), "int a;\n");
  EXPECT_FALSE(page().is_modified());
}

TEST_F(CodeFiles, AFileThatComesBackLaterIsSeen) {
  open({write("a.c", "int a;\n")});
  std::filesystem::remove(path("a.c").toStdString());
  ASSERT_TRUE(QTest::qWaitFor([&] { return page().notice().isVisible(); }, 60'000));
  write("a.c", "int b;\n");
  const auto is_told = [&] {
    return notice().find("was changed on the disk") != std::string::npos;
  };
  EXPECT_TRUE(QTest::qWaitFor(is_told, 60'000)) << notice();
}

TEST_F(CodeFiles, WhereNothingCanBeWrittenTheTextIsKept) {
  open({write("a.c", "int a;\n")});
  type("x");
  EXPECT_FALSE(window().save_as(page(), "/proc/a.c"));
  EXPECT_THAT(notice(), HasSubstr("/proc/a.c cannot be saved: "));
  EXPECT_THAT(notice(), HasSubstr("The text is kept here; save it elsewhere"));
  EXPECT_EQ(editor().text(), "xint a;\n");
  EXPECT_TRUE(page().is_modified());
  EXPECT_EQ(page().path(), path("a.c"));
  click_notice("Save as...");
  dialog<QFileDialog>().reject();
}

TEST_F(CodeFiles, ADiskWithoutRoomKeepsTheOldFile) {
  open({write("a.c", "int a;\n")});
  type("much too long");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit little{4, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &little);
  press(Qt::Key_S, Qt::ControlModifier);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_THAT(notice(), HasSubstr("a.c cannot be saved: "));
  EXPECT_EQ(file("a.c"), "int a;\n");
  EXPECT_TRUE(page().is_modified());
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(file("a.c"), "much too longint a;\n");
}

TEST_F(CodeFiles, WhatCannotBeReadIsNotOverwrittenUnasked) {
  open({write("a.c", "int a;\n")});
  type("x");
  const std::string picture("not\0text", 8);
  write("a.c", picture);
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_THAT(notice(), HasSubstr("a.c is no text"));
  EXPECT_EQ(file("a.c"), picture);
  EXPECT_TRUE(page().is_modified());
  click_notice("Overwrite it");
  EXPECT_EQ(file("a.c"), "xint a;\n");
  EXPECT_FALSE(page().is_modified());
}

// Saving replaces the file: as root it once put a text in the place of a device.
TEST_F(CodeFiles, WhatIsNoOrdinaryFileIsNeitherReadNorReplaced) {
  open({write("a.c", "int a;\n")});
  const std::string pipe = path("pipe.c").toStdString();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_symlink(pipe, path("link.c").toStdString());
  for (const char* const name : {"pipe.c", "link.c"}) {
    EXPECT_EQ(window().open_file(path(name)), nullptr);
    EXPECT_THAT(window().state().toStdString(), HasSubstr("is no ordinary file"));
    EXPECT_FALSE(window().save_as(page(), path(name)));
    EXPECT_THAT(notice(), HasSubstr("it is no ordinary file. The text is kept here"));
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
  }
  EXPECT_EQ(page().path(), path("a.c"));
}

TEST_F(CodeFiles, ClosingAsksAboutUnsavedTexts) {
  open({write("a.c", "int a;\n")});
  type("x");
  EXPECT_FALSE(window().close());
  answer(QMessageBox::Cancel);
  EXPECT_TRUE(window().isVisible());
  EXPECT_FALSE(window().close());
  answer(QMessageBox::Save);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window().isVisible(); }, 60'000));
  EXPECT_EQ(file("a.c"), "xint a;\n");
}

TEST_F(CodeFiles, ClosingATabAsksToo) {
  open({write("a.c", "int a;\n"), write("b.c", "int b;\n")});
  type("x");
  press(Qt::Key_W, Qt::ControlModifier);
  EXPECT_EQ(window().page_count(), 2);
  answer(QMessageBox::Save);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window().page_count() == 1; }, 60'000));
  EXPECT_EQ(file("b.c"), "xint b;\n");
  press(Qt::Key_W, Qt::ControlModifier);
  EXPECT_EQ(window().page_count(), 0);
  EXPECT_FALSE(action("Run").isEnabled());
  for (const char* const text :
       {"Save", "Undo", "Find next", "Go to line...", "Next tab", "Build"}) {
    action(text).trigger();  // nothing to do it to
  }
}

TEST_F(CodeFiles, ClosingStopsWhatRuns) {
  open({write("a.py", "from eye import *\nprint('here', flush=True)\nwhile True: OSWait(100)\n")});
  window().run_bar().windows().setChecked(false);
  window().run_bar().fast().setChecked(false);
  press(Qt::Key_F5);
  ASSERT_TRUE(QTest::qWaitFor([&] { return output().contains("here"); }, 60'000))
      << output().toStdString();
  window().close();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window().isVisible(); }, 60'000));
  EXPECT_EQ(window().runner().state(), Runner::State::Idle);
}

TEST_F(CodeFiles, WhileItClosesNothingIsTypedThatNobodyWouldSave) {
  open({write("a.py",
              "import signal, time\nsignal.signal(signal.SIGTERM, lambda *_: time.sleep(0.5) or "
              "exit())\nprint('here', flush=True)\nwhile True: time.sleep(0.1)\n")});
  const QString before = editor().text();
  window().run_bar().windows().setChecked(false);
  press(Qt::Key_F5);
  ASSERT_TRUE(QTest::qWaitFor([&] { return output().contains("here"); }, 60'000))
      << output().toStdString();
  EXPECT_FALSE(window().close());
  ASSERT_EQ(window().runner().state(), Runner::State::Stopping);
  QTest::keyClick(&editor(), 'x');
  EXPECT_EQ(editor().text(), before);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window().isVisible(); }, 60'000));
}

TEST_F(CodeFiles, RecentFilesAreInTheMenu) {
  open({write("a.c", "int a;\n")});
  press(Qt::Key_W, Qt::ControlModifier);
  QMenu* recent = nullptr;
  for (QMenu* const menu : window().findChildren<QMenu*>()) {
    if (menu->title().remove('&') == "Open recent") recent = menu;
  }
  ASSERT_NE(recent, nullptr);
  emit recent->aboutToShow();
  EXPECT_EQ(recent->actions().front()->text(), path("a.c"));
  recent->actions().front()->trigger();
  EXPECT_EQ(page().name(), "a.c");
}

}  // namespace
}  // namespace eyebridge::gui
