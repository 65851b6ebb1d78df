// The editor of the code panel, as a person types.
#include <QPalette>

#include <Qsci/qscilexer.h>
#include <gmock/gmock.h>

#include "code/editor.hpp"
#include "code_room.hpp"

namespace eyebridge::gui {
namespace {

using ::testing::HasSubstr;

class CodeEditor : public testing::CodeRoom {
 protected:
  void open_text(const char* name, const char* text) {
    open({write(name, text)});
    QTest::keyClick(&editor(), Qt::Key_End, Qt::ControlModifier);
  }
  std::string text() { return editor().text().toStdString(); }
};

TEST_F(CodeEditor, ALineIsMarkedOnceHoweverManyMessagesNameIt) {
  open({write("a.c", "int a;\n")});
  for (int i = 0; i < 3; ++i) editor().mark(1, Message::Severity::Error);
  EXPECT_TRUE(editor().is_marked(1));
  constexpr unsigned long kErrorMark = 1;
  editor().SendScintilla(QsciScintilla::SCI_MARKERDELETE, 0UL, kErrorMark);  // one of them
  EXPECT_FALSE(editor().is_marked(1));
}

TEST_F(CodeEditor, NamesOfRobiosAreOfferedWhileTyping) {
  open_text("a.c", "#include \"eyebot.h\"\n");
  type("VWStr");
  ASSERT_TRUE(editor().isListActive());
  QTest::keyClick(&editor(), Qt::Key_Tab);
  EXPECT_THAT(text(), HasSubstr("\nVWStraight"));
  type("(");
  EXPECT_TRUE(editor().isCallTipActive());
  type("100, 50)");
  EXPECT_FALSE(editor().isCallTipActive());
}

TEST_F(CodeEditor, CapitalsNeedNotBeTyped) {
  open_text("a.py", "from eye import *\n");
  type("psdg");
  ASSERT_TRUE(editor().isListActive());
  QTest::keyClick(&editor(), Qt::Key_Return);
  EXPECT_THAT(text(), HasSubstr("\nPSDGet"));
}

TEST_F(CodeEditor, MembersOfTheModuleAreOfferedThoseOfOthersAreNot) {
  open_text("a.py", "import eye\nimport os\n");
  type("eye.VWStra");
  EXPECT_TRUE(editor().isListActive());
  QTest::keyClick(&editor(), Qt::Key_Escape);
  type("\nos.VWStra");
  EXPECT_FALSE(editor().isListActive());
}

TEST_F(CodeEditor, ClassicNamesAreOfferedInClassicPrograms) {
  open_text("a.c", "#include \"eyebot.h\"\nVWHandle vw = VWInit(VW_DRIVE, 1);\n");
  EXPECT_EQ(editor().api(), Api::Classic);
  EXPECT_THAT(window().findChild<QLabel*>("place")->text().toStdString(),
              HasSubstr("classic RoBIOS"));
  type("VWDriveStr");
  EXPECT_TRUE(editor().isListActive());
  QTest::keyClick(&editor(), Qt::Key_Escape);
  action("RoBIOS-7").trigger();
  EXPECT_EQ(editor().api(), Api::Robios7);
  type("\nVWDriveCur");
  EXPECT_FALSE(editor().isListActive());
  action("As it looks").trigger();
  EXPECT_EQ(editor().api(), Api::Classic);
}

TEST_F(CodeEditor, CallTipsOfFunctionsWithAnyNumberOfArgumentsStay) {
  open_text("a.c", "");
  type("LCDPrintf(\"%d %d %d\", 1, 2, ");
  EXPECT_TRUE(editor().isCallTipActive());
  type("3); NoSuchThing(");
  EXPECT_FALSE(editor().isCallTipActive());
}

TEST_F(CodeEditor, LinesAreIndentedLikeTheOneBefore) {
  open_text("a.c", "");
  type("int main() {\nint x;\n}\n");
  EXPECT_EQ(text(), "int main() {\n  int x;\n}\n");
}

TEST_F(CodeEditor, PythonIsIndentedBehindAColon) {
  open_text("a.py", "");
  type("while 1:\npass\n");
  EXPECT_EQ(text(), "while 1:\n    pass\n    ");
}

TEST_F(CodeEditor, CommentsComeAndGo) {
  open_text("a.c", "int a;\n  int b;\n\nint c;\n");
  editor().setSelection(0, 0, 3, 0);
  press(Qt::Key_Slash, Qt::ControlModifier);
  EXPECT_EQ(text(), "// int a;\n//   int b;\n\nint c;\n");
  press(Qt::Key_Slash, Qt::ControlModifier);
  EXPECT_EQ(text(), "int a;\n  int b;\n\nint c;\n");
  editor().go_to(4, 3);
  press(Qt::Key_Slash, Qt::ControlModifier);
  EXPECT_EQ(text(), "int a;\n  int b;\n\n// int c;\n");
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(text(), "int a;\n  int b;\n\nint c;\n");
}

TEST_F(CodeEditor, LastLineWithoutItsEndIsCommentedToo) {
  open_text("a.py", "x = 1\ny = 2");
  press(Qt::Key_A, Qt::ControlModifier);
  press(Qt::Key_Slash, Qt::ControlModifier);
  EXPECT_EQ(text(), "# x = 1\n# y = 2");
  press(Qt::Key_Slash, Qt::ControlModifier);
  EXPECT_EQ(text(), "x = 1\ny = 2");
  // A sign at the very end.
  press(Qt::Key_End, Qt::ControlModifier);
  type("\n#");
  press(Qt::Key_Slash, Qt::ControlModifier);
  EXPECT_EQ(text(), "x = 1\ny = 2\n");
}

TEST_F(CodeEditor, UndoGoesBackToTheSavedText) {
  open_text("a.py", "x = 1\n");
  type("y = 2");
  EXPECT_TRUE(page().is_modified());
  EXPECT_EQ(window().tabs().tabText(0), "a.py*");
  while (editor().isUndoAvailable()) press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(page().is_modified());
  EXPECT_EQ(window().tabs().tabText(0), "a.py");
  press(Qt::Key_Y, Qt::ControlModifier);
  EXPECT_TRUE(page().is_modified());
}

TEST_F(CodeEditor, LineIsGoneToWhereverItIs) {
  open_text("a.c", "int f() {\n  int a;\n}\nint b;\n");
  editor().foldAll();
  press(Qt::Key_G, Qt::ControlModifier);
  auto& line = dialog<QInputDialog>();
  line.setIntValue(2);
  line.accept();
  EXPECT_EQ(editor().line(), 2);
  EXPECT_TRUE(editor().SendScintilla(QsciScintilla::SCI_GETLINEVISIBLE, 1UL)) << "unfolded";
  editor().go_to(99, 99);
  EXPECT_EQ(editor().line(), 5);
  editor().go_to(-1, 99);
  int row = 0;
  int index = 0;
  editor().getCursorPosition(&row, &index);
  EXPECT_EQ(row, 0);
  EXPECT_EQ(index, 9) << "the line's end";
}

TEST_F(CodeEditor, BracesAndFolds) {
  open_text("a.c", "int f() {\n  int a;\n}\n");
  editor().go_to(3, 1);
  press(Qt::Key_M, Qt::ControlModifier);
  EXPECT_EQ(editor().line(), 1);
  press(Qt::Key_H, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(editor().contractedFolds(), QList<int>{0});
}

TEST_F(CodeEditor, DarkPalettesHaveDarkGroundAndLightLetters) {
  open_text("a.c", "int main() { return 0; } // end\n");
  const auto ground = [&] { return editor().grab().toImage().pixelColor(600, 300).lightness(); };
  EXPECT_GT(ground(), 200);
  QPalette dark;
  dark.setColor(QPalette::Base, QColor(20, 20, 20));
  dark.setColor(QPalette::Text, QColor(230, 230, 230));
  editor().setPalette(dark);
  EXPECT_LT(ground(), 60);
  // Every kind of word can be told from the ground.
  for (int style = 0; style < 20; ++style) {
    EXPECT_GT(editor().lexer()->color(style).lightness(), 110) << style;
  }
}

TEST_F(CodeEditor, ZoomIsThatOfAllTabsAndOfTheNextTime) {
  open_text("a.c", "");
  window().open_file(write("b.c", ""));
  const auto zoom = [&](int tab) {
    window().tabs().setCurrentIndex(tab);
    return editor().SendScintilla(QsciScintilla::SCI_GETZOOM);
  };
  press(Qt::Key_Plus, Qt::ControlModifier);
  press(Qt::Key_Plus, Qt::ControlModifier);
  EXPECT_EQ(zoom(0), 2);
  EXPECT_EQ(zoom(1), 2);
  open({path("a.c")});
  EXPECT_EQ(zoom(0), 2);
  press(Qt::Key_0, Qt::ControlModifier);
  EXPECT_EQ(zoom(0), 0);
}

TEST_F(CodeEditor, FindsAndReplaces) {
  open_text("a.c", "one two one\nOne ones\n");
  editor().go_to(1, 1);
  press(Qt::Key_F, Qt::ControlModifier);
  auto* const wanted = window().findChild<QLineEdit*>("find");
  ASSERT_TRUE(wanted->hasFocus());
  QTest::keyClicks(wanted, "one");
  QTest::keyClick(wanted, Qt::Key_Return);
  QTest::keyClick(wanted, Qt::Key_Return);
  EXPECT_EQ(editor().selectedText(), "one");
  QTest::keyClick(wanted, Qt::Key_Return);
  EXPECT_EQ(editor().selectedText(), "One");
  EXPECT_EQ(window().findChild<QLabel*>("found")->text(), "Line 2");
  QTest::keyClick(wanted, Qt::Key_Return, Qt::ShiftModifier);
  EXPECT_EQ(editor().line(), 1);
  QTest::keyClick(wanted, Qt::Key_Escape);
  EXPECT_FALSE(window().find_bar().isVisible());
  EXPECT_TRUE(editor().hasFocus());

  press(Qt::Key_H, Qt::ControlModifier);
  auto* const by = window().findChild<QLineEdit*>("replacement");
  window().findChild<QCheckBox*>("case")->setChecked(true);
  window().findChild<QCheckBox*>("words")->setChecked(true);
  wanted->setText("one");
  by->setText("oneone");
  window().find_bar().replace_all();
  EXPECT_EQ(text(), "oneone two oneone\nOne ones\n");
  EXPECT_EQ(window().findChild<QLabel*>("found")->text(), "2 replaced");
  action("Undo").trigger();
  EXPECT_EQ(text(), "one two one\nOne ones\n") << "one step";
  by->setFocus();
  editor().go_to(1, 5);
  QTest::keyClick(by, Qt::Key_Return);
  EXPECT_EQ(text(), "one two oneone\nOne ones\n") << "the next one only";
}

TEST_F(CodeEditor, PatternsThatMatchNothingEndToo) {
  open_text("a.c", "one\n");
  press(Qt::Key_H, Qt::ControlModifier);
  window().findChild<QLineEdit*>("find")->setText("x*");
  window().findChild<QCheckBox*>("pattern")->setChecked(true);
  window().find_bar().replace_all();
  EXPECT_EQ(text(), "one\n");
  window().findChild<QLineEdit*>("find")->setText("nowhere");
  window().find_bar().find_next();
  EXPECT_EQ(window().findChild<QLabel*>("found")->text(), "Not found");
}

}  // namespace
}  // namespace eyebridge::gui
