// Writing a program, running it, finding what is wrong with it: as a person does it.
#include <QDir>
#include <QToolButton>

#include <gmock/gmock.h>

#include "album.hpp"
#include "code_room.hpp"
#include "person.hpp"

namespace eyebridge::gui {
namespace {

using ::testing::HasSubstr;

class CodeRun : public testing::CodeRoom {
 protected:
  void open_without_windows(const QStringList& paths = {}) {
    open(paths);
    window().run_bar().windows().setChecked(false);
    window().run_bar().fast().setChecked(true);
    window().run_bar().choose_world("");
  }
  std::string said() { return output().toStdString(); }
};

TEST_F(CodeRun, ATemplateIsBrokenMendedAndRun) {
  open_without_windows();
  ASSERT_THAT(editor().text().toStdString(), HasSubstr("PSDGet(PSD_FRONT)"));
  // Broken: the ';' behind the menu goes.
  editor().go_to(4, 1);
  press(Qt::Key_End);
  press(Qt::Key_Backspace);
  press(Qt::Key_F5);
  wait_for_end();
  EXPECT_EQ(window().state(), "Not built: see the messages below");
  EXPECT_THAT(said(), HasSubstr("error: expected"));
  EXPECT_TRUE(editor().is_marked(4)) << said();
  editor().go_to(1, 1);
  click_output("error: expected");
  EXPECT_EQ(editor().line(), 4);
  ASSERT_TRUE(editor().hasFocus());
  press(Qt::Key_End);
  type(";");
  press(Qt::Key_F5);
  wait_for_end();
  EXPECT_THAT(said(), HasSubstr("wall at 1")) << window().state().toStdString();
  EXPECT_FALSE(editor().is_marked(4));
  EXPECT_THAT(window().state().toStdString(), HasSubstr("Ended with exit code 0 after"));
}

TEST_F(CodeRun, TheOtherTemplatesRunAsTheyAre) {
  open_without_windows();
  action("C++ program").trigger();
  press(Qt::Key_F5);
  wait_for_end();
  EXPECT_THAT(said(), HasSubstr("back at ")) << window().state().toStdString();
  action("Python program").trigger();
  press(Qt::Key_F5);
  wait_for_end();
  EXPECT_THAT(said(), HasSubstr("wall at 1")) << window().state().toStdString();
}

TEST_F(CodeRun, ATracebackLeadsToItsLine) {
  const QString path =
      write("walk.py", "from eye import *\n\ndef walk():\n    VWStraigt(100, 50)\n\nwalk()\n");
  open_without_windows({path});
  press(Qt::Key_F5);
  wait_for_end();
  EXPECT_THAT(said(), HasSubstr("NameError"));
  EXPECT_EQ(editor().line(), 4) << "where it gave up, not where it was called from";
  EXPECT_TRUE(editor().is_marked(4));
  EXPECT_TRUE(editor().is_marked(6));
  click_output("line 6");
  EXPECT_EQ(editor().line(), 6);
  press(Qt::Key_F8);
  EXPECT_EQ(editor().line(), 4);
  press(Qt::Key_F8, Qt::ShiftModifier);
  EXPECT_EQ(editor().line(), 6);
}

TEST_F(CodeRun, AMessageOpensATabThatWasClosed) {
  open_without_windows({write("fail.py", "x = 1\nprint(y)\n"), write("other.py", "")});
  window().tabs().setCurrentIndex(0);
  press(Qt::Key_F5);
  wait_for_end();
  press(Qt::Key_W, Qt::ControlModifier);
  ASSERT_EQ(page().name(), "other.py");
  click_output("line 2");
  ASSERT_EQ(page().name(), "fail.py") << said();
  EXPECT_EQ(editor().line(), 2);
}

TEST_F(CodeRun, AMessageOfAWorldOpensTheWorld) {
  const QString world = write("bad.wld", "floor 2000 1000\n0 0 2000 x\n");
  open_without_windows({write("p.py", "from eye import *\nprint(PSDGet(1))\n")});
  window().run_bar().choose_world(world);
  press(Qt::Key_F5);
  wait_for_end();
  EXPECT_EQ(window().page_count(), 1);
  click_output("bad.wld:2:");
  ASSERT_EQ(window().page_count(), 2) << said();
  EXPECT_EQ(page().name(), "bad.wld");
  EXPECT_EQ(editor().line(), 2);
}

TEST_F(CodeRun, AControlFileDrivesItsRobotsAndItsMistakesAreFound) {
  const std::string head =
      "def run(robot, keep_going, belief_space, map_space, interact):\n"
      "    robot('Robot 1').start()\n"
      "    robot('Robot 1').set_wheel('left', 8)\n"
      "    robot('Robot 1').set_wheel('right', 8)\n"
      "    interact.wait(1)\n"
      "    belief_space.update('Robot 1')\n"
      "    interact.print('free', belief_space.is_known(*robot(1).pose[:2]))\n";
  open_without_windows({write("drive.py", head + "    robot('Robot 9')\n")});
  press(Qt::Key_F5);
  wait_for_end();
  EXPECT_THAT(said(), HasSubstr("free ")) << window().state().toStdString();
  click_output("drive.py:8");
  EXPECT_EQ(editor().line(), 8) << said();
}

TEST_F(CodeRun, ClassicProgramsAreBuiltAsSuch) {
  open_without_windows({QString(EYEBRIDGE_SOURCE_DIR "/examples/classic_patrol.c")});
  window().run_bar().choose_world(settings_.worlds + "/empty-room.wld");
  press(Qt::Key_F5);
  wait_for_end();
  EXPECT_THAT(said(), HasSubstr("leg 6:")) << window().state().toStdString();
}

TEST_F(CodeRun, AnExampleOfSeveralFilesIsBuiltWithAllOfThem) {
  open_without_windows({QString(EYEBRIDGE_SOURCE_DIR "/examples/maze_explorer/maze_explorer.cpp")});
  action("Build").trigger();
  wait_for_end();
  EXPECT_EQ(window().state(), "Built") << said();
}

TEST_F(CodeRun, WhatHasAFileIsSavedBeforeItRuns) {
  const QString path = write("a.py", "print('before')\n");
  open_without_windows({path});
  press(Qt::Key_End, Qt::ControlModifier);
  type("print('after')\n");
  press(Qt::Key_F5);
  wait_for_end();
  EXPECT_THAT(said(), HasSubstr("before\nafter"));
  EXPECT_THAT(file("a.py"), HasSubstr("after"));
  EXPECT_FALSE(page().is_modified());
}

TEST_F(CodeRun, WhatIsPrintedIsSeenAtOnceAndStopEndsTheProgram) {
  open_without_windows({write("wait.c",
                              "#include \"eyebot.h\"\nint main() {\n  printf(\"here\\n\");\n"
                              "  for (;;) OSWait(100);\n}\n")});
  window().run_bar().fast().setChecked(false);
  press(Qt::Key_F5);
  ASSERT_TRUE(QTest::qWaitFor([&] { return output().contains("here"); }, 60'000)) << said();
  EXPECT_EQ(window().state(), "Running");
  EXPECT_FALSE(action("Run").isEnabled());
  for (QToolButton* const button : window().run_bar().findChildren<QToolButton*>()) {
    if (button->defaultAction() == &action("Stop")) QTest::mouseClick(button, Qt::LeftButton);
  }
  wait_for_end();
  EXPECT_EQ(window().state(), "Stopped");
  EXPECT_TRUE(action("Run").isEnabled());
}

TEST_F(CodeRun, TheRobotsWindowsComeWhereTheyAreWantedAndGoWithTheProgram) {
  open_without_windows({write("wait.c",
                              "#include \"eyebot.h\"\nint main() {\n  LCDPrintf(\"here\");\n"
                              "  for (;;) OSWait(100);\n}\n")});
  window().run_bar().windows().setChecked(true);
  window().run_bar().fast().setChecked(false);
  press(Qt::Key_F5);
  testing::Person person;
  person.window("wait – robot");
  press(Qt::Key_F5, Qt::ShiftModifier);
  wait_for_end();
  EXPECT_EQ(window().state(), "Stopped");
  person.wait_until_gone("wait – robot");
}

TEST_F(CodeRun, CopiesOfTextsWithoutFilesGoWithThem) {
  open_without_windows();
  press(Qt::Key_F5);
  wait_for_end();
  const QDir builds(settings_.builds);
  EXPECT_EQ(builds.entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(), 1);
  press(Qt::Key_W, Qt::ControlModifier);
  EXPECT_TRUE(builds.isEmpty());
}

TEST_F(CodeRun, LooksAsAPersonHasSeenIt) {
  open_without_windows();
  editor().SendScintilla(QsciScintilla::SCI_SETCARETPERIOD, 0UL);
  editor().go_to(4, 1);
  press(Qt::Key_End);
  press(Qt::Key_Backspace);
  press(Qt::Key_F5);
  wait_for_end();
  QApplication::processEvents();
  EXPECT_TRUE(testing::looks_as(window().grab().toImage(), "code_panel"));
}

TEST_F(CodeRun, WhatIsNoProgramSaysSo) {
  open_without_windows({write("notes.txt", "to do\n")});
  press(Qt::Key_F5);
  EXPECT_EQ(window().state(),
            "notes.txt is no program; expected a file of C (.c), C++ (.cpp) or Python (.py)");
  window().open_file(write("part.h", "int part;\n"));
  press(Qt::Key_F5);
  EXPECT_THAT(window().state().toStdString(), HasSubstr("part.h is no program"));
  window().open_file(write("a.py", "print(1)\n"));
  action("Build").trigger();
  EXPECT_EQ(window().state(), "Programs in Python need not be built");
}

TEST_F(CodeRun, ACompilerThatIsNotThereIsNamed) {
  settings_.c_compiler = path("nowhere/eyebridge-cc");
  open_without_windows();
  press(Qt::Key_F5);
  wait_for_end();
  EXPECT_THAT(window().state().toStdString(), HasSubstr("nowhere/eyebridge-cc cannot be started"));
}

TEST_F(CodeRun, TheWorldIsTheOneThatWasChosen) {
  open_without_windows(
      {write("a.py", "from eye import *\nprint('objects', SIMGetObjectCount())\n")});
  QComboBox& worlds = window().run_bar().worlds();
  const int index = worlds.findText("soccer.sim");
  ASSERT_GE(index, 0);
  worlds.setCurrentIndex(index);
  press(Qt::Key_F5);
  wait_for_end();
  EXPECT_THAT(said(), HasSubstr("objects 1"));
}

}  // namespace
}  // namespace eyebridge::gui
