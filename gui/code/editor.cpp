#include "code/editor.hpp"

#include <QEvent>
#include <QFontDatabase>
#include <QKeyEvent>
#include <algorithm>

#include <Qsci/qscicommandset.h>
#include <Qsci/qscilexer.h>

#include "code/robios_apis.hpp"

namespace eyebridge::gui {
namespace {

constexpr int kNumbers = 0;  // margins
constexpr int kMarks = 1;
constexpr int kFolds = 2;
constexpr int kMarkWidth = 16;

constexpr int kErrorMark = 1;
constexpr int kWarningMark = 2;
constexpr int kAllMarks = (1 << kErrorMark) | (1 << kWarningMark);

constexpr int kLettersToComplete = 3;

}  // namespace

Editor::Editor(QWidget* parent) : QsciScintilla(parent) {
  setAccessibleName(tr("Program"));
  setUtf8(true);
  setFrameShape(QFrame::NoFrame);
  setAutoIndent(true);
  setBackspaceUnindents(true);
  setIndentationGuides(true);
  setIndentationsUseTabs(false);
  setBraceMatching(SloppyBraceMatch);
  setAutoCompletionSource(AcsAll);
  setAutoCompletionThreshold(kLettersToComplete);
  setAutoCompletionUseSingle(AcusExplicit);
  setCallTipsStyle(CallTipsNoAutoCompletionContext);
  setCallTipsVisible(1);
  setScrollWidthTracking(true);
  setScrollWidth(1);
  set_up_margins();
  set_language(Language::Text);
  connect(this, &QsciScintilla::linesChanged, this, [this] { count_lines(); });
}

void Editor::set_up_margins() {
  setMarginType(kNumbers, NumberMargin);
  setMarginType(kMarks, SymbolMargin);
  setMarginWidth(kMarks, kMarkWidth);
  setMarginMarkerMask(kMarks, kAllMarks);
  markerDefine(RightTriangle, kErrorMark);
  markerDefine(RightTriangle, kWarningMark);
  setFolding(BoxedTreeFoldStyle, kFolds);
  count_lines();
}

void Editor::count_lines() { setMarginWidth(kNumbers, QString(" %1").arg(std::max(lines(), 100))); }

void Editor::set_language(Language language) {
  language_ = language;
  QsciLexer* const before = lexer();
  QsciLexer* const lexer = make_lexer(language, this);
  if (lexer != nullptr) new RobiosApis(lexer, [this] { return api(); });
  setLexer(lexer);
  // QScintilla would take the language's word for it: psdget is found, too.
  SendScintilla(SCI_AUTOCSETIGNORECASE, true);
  delete before;
  const int width = language == Language::Python ? 4 : 2;
  setIndentationWidth(width);
  setTabWidth(indentationsUseTabs() ? 8 : width);
  paint();
}

Api Editor::api() const {
  if (language_ == Language::Python) return Api::Python;
  const bool classic = classic_ ? *classic_ : is_classic(text().toStdString());
  return classic ? Api::Classic : Api::Robios7;
}

void Editor::paint() {
  const QPalette& colours = palette();
  QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  font.setStyleHint(QFont::Monospace);
  const QColor text = colours.color(QPalette::Text);
  const QColor base = colours.color(QPalette::Base);
  const QColor margin = colours.color(QPalette::Window);
  const bool dark = is_dark(colours);
  if (lexer() != nullptr) {
    paint_lexer(*lexer(), colours, font);
  } else {
    setFont(font);
    setColor(text);
    setPaper(base);
  }
  setCaretForegroundColor(text);
  setCaretLineVisible(true);
  setCaretLineBackgroundColor(dark ? base.lighter(130) : base.darker(104));
  setSelectionBackgroundColor(colours.color(QPalette::Highlight));
  setSelectionForegroundColor(colours.color(QPalette::HighlightedText));
  setMarginsBackgroundColor(margin);
  setMarginsForegroundColor(colours.color(QPalette::WindowText));
  setMarginsFont(font);
  setFoldMarginColors(margin, margin);
  setIndentationGuidesForegroundColor(colours.color(QPalette::Mid));
  setMatchedBraceBackgroundColor(colours.color(QPalette::Midlight));
  setMatchedBraceForegroundColor(colours.color(QPalette::Link));
  setUnmatchedBraceForegroundColor(dark ? QColor(0xff, 0x80, 0x80) : QColor(0xc0, 0x10, 0x10));
  setUnmatchedBraceBackgroundColor(base);
  setCallTipsBackgroundColor(colours.color(QPalette::ToolTipBase));
  setCallTipsForegroundColor(colours.color(QPalette::ToolTipText));
  setCallTipsHighlightColor(dark ? QColor(0x8f, 0xb4, 0xff) : QColor(0x1f, 0x3f, 0xa8));
  for (const int mark : {kErrorMark, kWarningMark}) {
    const QColor colour = mark == kErrorMark ? QColor(0xd0, 0x20, 0x20) : QColor(0xd0, 0x90, 0x00);
    setMarkerBackgroundColor(colour, mark);
    setMarkerForegroundColor(colour, mark);
  }
  for (int mark = SC_MARKNUM_FOLDEREND; mark <= static_cast<int>(SC_MARKNUM_FOLDEROPEN); ++mark) {
    setMarkerForegroundColor(margin, mark);
    setMarkerBackgroundColor(colours.color(QPalette::WindowText), mark);
  }
  count_lines();
}

void Editor::changeEvent(QEvent* event) {
  QsciScintilla::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) paint();
}

bool Editor::list_has_nothing_to_add() const {
  // Both with the zero behind them.
  QByteArray chosen(static_cast<int>(SendScintilla(SCI_AUTOCGETCURRENTTEXT)) + 1, '\0');
  SendScintilla(SCI_AUTOCGETCURRENTTEXT, 0UL, static_cast<void*>(chosen.data()));
  const long at = SendScintilla(SCI_GETCURRENTPOS);
  const long begin = SendScintilla(SCI_WORDSTARTPOSITION, static_cast<unsigned long>(at), 1L);
  const QByteArray written = bytes(static_cast<int>(begin), static_cast<int>(at));
  return qstrcmp(chosen.constData(), written.constData()) == 0;
}

void Editor::keyPressEvent(QKeyEvent* event) {
  // Who has written a word to its end wants a new line.
  const bool enters = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (enters && isListActive() && list_has_nothing_to_add()) cancelList();
  QsciScintilla::keyPressEvent(event);
}

void Editor::go_to(int line, int column) {
  const int row = std::clamp(line, 1, std::max(lines(), 1)) - 1;
  // Without what ends the line.
  QString words = text(row);
  while (words.endsWith('\n') || words.endsWith('\r')) words.chop(1);
  const int index = std::clamp(column - 1, 0, static_cast<int>(words.size()));
  SendScintilla(SCI_ENSUREVISIBLEENFORCEPOLICY, static_cast<unsigned long>(row));
  setCursorPosition(row, index);
  ensureCursorVisible();
}

int Editor::line() const {
  int line = 0;
  int index = 0;
  getCursorPosition(&line, &index);
  return line + 1;
}

void Editor::toggle_comment() {
  const QString sign = comment_of(language_);
  if (sign.isEmpty()) return;
  int first = 0;
  int last = 0;
  int from = 0;
  int to = 0;
  getSelection(&first, &from, &last, &to);
  const bool selects = first >= 0;
  if (!selects) {
    getCursorPosition(&first, &from);
    last = first;
  }
  if (last > first && to == 0) --last;
  bool all = true;
  int least = -1;
  for (int row = first; row <= last; ++row) {
    const QString words = text(row);
    if (words.trimmed().isEmpty()) continue;
    all = all && words.trimmed().startsWith(sign);
    int begin = 0;
    while (words[begin] == ' ' || words[begin] == '\t') ++begin;
    least = least < 0 ? begin : std::min(least, begin);
  }
  if (least < 0) return;
  beginUndoAction();
  for (int row = first; row <= last; ++row) {
    const QString words = text(row);
    if (words.trimmed().isEmpty()) continue;
    if (all) {
      const int begin = static_cast<int>(words.indexOf(sign));
      int end = begin + static_cast<int>(sign.size());
      if (end < words.size() && words[end] == ' ') ++end;
      setSelection(row, begin, row, end);
      removeSelectedText();
    } else {
      insertAt(sign + ' ', row, least);
    }
  }
  endUndoAction();
  if (selects)
    setSelection(first, 0, last,
                 static_cast<int>(text(last).trimmed().isEmpty() ? 0 : lineLength(last) - 1));
}

void Editor::replace_text(const QString& text) {
  const int at = line();
  beginUndoAction();
  selectAll();
  replaceSelectedText(text);
  endUndoAction();
  go_to(at, 1);
}

void Editor::show_text(const QString& text) {
  setEolMode(text.contains("\r\n") ? EolWindows : EolUnix);
  setIndentationsUseTabs(text.startsWith('\t') || text.contains("\n\t"));
  setText(text);
  setCursorPosition(0, 0);  // QScintilla 2.14 puts it behind the text
  set_language(language_);
  setModified(false);
}

void Editor::mark(int line, Message::Severity severity) {
  if (severity == Message::Severity::Note || line < 1 || line > lines()) return;
  const int mark = severity == Message::Severity::Error ? kErrorMark : kWarningMark;
  // A second one would lie behind it: a program that repeats itself would add them for ever.
  if ((markersAtLine(line - 1) & (1U << mark)) != 0) return;
  markerAdd(line - 1, mark);
}

void Editor::clear_marks() {
  markerDeleteAll(kErrorMark);
  markerDeleteAll(kWarningMark);
}

bool Editor::is_marked(int line) const { return (markersAtLine(line - 1) & kAllMarks) != 0; }

void Editor::leave_keys(const QList<QKeySequence>& keys) {
  for (const QKeySequence& key : keys) {
    if (key.count() != 1) continue;
    QsciCommand* const command = standardCommands()->boundTo(key[0].toCombined());
    if (command == nullptr) continue;
    if (command->key() == key[0].toCombined()) command->setKey(0);
    if (command->alternateKey() == key[0].toCombined()) command->setAlternateKey(0);
  }
}

}  // namespace eyebridge::gui
