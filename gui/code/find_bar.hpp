#pragma once

#include <QCheckBox>
#include <QCoreApplication>
#include <QLabel>
#include <QLineEdit>
#include <QWidget>
#include <functional>

namespace eyebridge::gui {

class Editor;

/// Finds and replaces in the text that is in front. Enter finds the next, Shift+Enter the one
/// before, Escape closes the bar.
class FindBar final : public QWidget {
  Q_DECLARE_TR_FUNCTIONS(FindBar)
 public:
  /// `editor` gives the text in front; null when there is none.
  FindBar(std::function<Editor*()> editor, QWidget* parent);

  /// Shows the bar, with what is selected as what to look for, and the field to replace it by.
  void open(bool replaces);
  void find_next();
  void find_previous();
  void replace();
  void replace_all();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  bool find(bool forward, bool from_selection_start);
  void close_bar();
  void tell(const QString& text);

  std::function<Editor*()> editor_;
  QLineEdit* wanted_;
  QLineEdit* replacement_;
  QWidget* replace_row_;
  QCheckBox* matches_case_;
  QCheckBox* whole_words_;
  QCheckBox* is_pattern_;
  QLabel* told_;
};

}  // namespace eyebridge::gui
