#pragma once

#include <QCoreApplication>
#include <QKeySequence>
#include <optional>

#include <Qsci/qsciscintilla.h>

#include "code/completions.hpp"
#include "code/language.hpp"
#include "code/messages.hpp"

namespace eyebridge::gui {

/// A program's text: colours, completion, call tips, line numbers, folding, marks at lines that
/// messages name. Lines and columns count from 1, columns in characters.
class Editor final : public QsciScintilla {
  Q_DECLARE_TR_FUNCTIONS(Editor)
 public:
  explicit Editor(QWidget* parent);

  void set_language(Language language);
  [[nodiscard]] Language language() const { return language_; }
  /// Which RoBIOS the text is written against, as it is now. A person may have said so.
  [[nodiscard]] Api api() const;
  /// Classic RoBIOS or not; by the text when that is not said.
  void set_classic(std::optional<bool> classic) { classic_ = classic; }

  /// Puts the cursor there, or as near as there is text, and shows the line, unfolded.
  void go_to(int line, int column);
  [[nodiscard]] int line() const;
  /// Makes the lines of the selection comments, or text again when all of them are comments.
  void toggle_comment();
  /// Replaces the whole text; can be undone. The cursor stays in its line.
  void replace_text(const QString& text);
  /// Of a file: its kind of line ends and of indentation are kept.
  void show_text(const QString& text);

  void mark(int line, Message::Severity severity);
  void clear_marks();
  /// Whether a mark is at the line.
  [[nodiscard]] bool is_marked(int line) const;
  /// Keys that the window's menus want, some of which QScintilla has commands for.
  void leave_keys(const QList<QKeySequence>& keys);

 protected:
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void set_up_margins();
  void paint();
  void count_lines();
  [[nodiscard]] bool list_has_nothing_to_add() const;

  Language language_ = Language::Text;
  std::optional<bool> classic_;
};

}  // namespace eyebridge::gui
