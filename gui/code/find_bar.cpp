#include "code/find_bar.hpp"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPushButton>
#include <utility>

#include "code/editor.hpp"

namespace eyebridge::gui {

FindBar::FindBar(std::function<Editor*()> editor, QWidget* parent)
    : QWidget(parent), editor_(std::move(editor)), replace_row_(new QWidget(this)) {
  setObjectName("find_bar");
  const auto add_field = [](QLayout& row, const QString& name, const char* object) {
    auto* const field = new QLineEdit;
    field->setPlaceholderText(name);
    field->setAccessibleName(name);
    field->setObjectName(object);
    row.addWidget(field);
    return field;
  };
  const auto add_button = [this](QLayout& row, const QString& text, void (FindBar::*act)()) {
    auto* const button = new QPushButton(text);
    connect(button, &QPushButton::clicked, this, act);
    row.addWidget(button);
  };
  const auto add_box = [](QLayout& row, const QString& text, const char* object) {
    auto* const box = new QCheckBox(text);
    box->setObjectName(object);
    row.addWidget(box);
    return box;
  };
  auto* const find_row = new QWidget(this);
  auto* const first = new QHBoxLayout(find_row);
  wanted_ = add_field(*first, tr("Find"), "find");
  add_button(*first, tr("&Next"), &FindBar::find_next);
  add_button(*first, tr("&Previous"), &FindBar::find_previous);
  matches_case_ = add_box(*first, tr("Match &case"), "case");
  whole_words_ = add_box(*first, tr("Whole &words"), "words");
  is_pattern_ = add_box(*first, tr("Pa&ttern"), "pattern");
  is_pattern_->setToolTip(
      tr("A regular expression: . any letter, * any number of it, [a-z], \\( \\)"));
  auto* const second = new QHBoxLayout(replace_row_);
  replacement_ = add_field(*second, tr("Replace by"), "replacement");
  add_button(*second, tr("&Replace"), &FindBar::replace);
  add_button(*second, tr("Replace &all"), &FindBar::replace_all);
  told_ = new QLabel(this);
  told_->setObjectName("found");
  auto* const rows = new QGridLayout(this);
  rows->setContentsMargins(8, 2, 8, 2);
  rows->setSpacing(2);
  rows->addWidget(find_row, 0, 0);
  rows->addWidget(replace_row_, 1, 0);
  rows->addWidget(told_, 0, 1);
  for (QLayout* const row : {static_cast<QLayout*>(first), static_cast<QLayout*>(second)}) {
    row->setContentsMargins(0, 0, 0, 0);
  }
  hide();
}

void FindBar::open(bool replaces) {
  Editor* const editor = editor_();
  if (editor == nullptr) return;
  const QString selected = editor->selectedText();
  if (!selected.isEmpty() && !selected.contains('\n')) wanted_->setText(selected);
  replace_row_->setVisible(replaces);
  tell("");
  show();
  wanted_->setFocus();
  wanted_->selectAll();
}

void FindBar::close_bar() {
  hide();
  if (Editor* const editor = editor_()) editor->setFocus();
}

void FindBar::tell(const QString& text) { told_->setText(text); }

bool FindBar::find(bool forward, bool from_selection_start) {
  Editor* const editor = editor_();
  if (editor == nullptr || wanted_->text().isEmpty()) return false;
  int line = -1;
  int index = -1;
  if (editor->hasSelectedText()) {
    int last = 0;
    int to = 0;
    editor->getSelection(&line, &index, &last, &to);
    if (forward && !from_selection_start) line = last, index = to;
  }
  const bool found =
      editor->findFirst(wanted_->text(), is_pattern_->isChecked(), matches_case_->isChecked(),
                        whole_words_->isChecked(), true, forward, line, index);
  tell(found ? tr("Line %1").arg(editor->line()) : tr("Not found"));
  return found;
}

void FindBar::find_next() { find(true, false); }

void FindBar::find_previous() { find(false, false); }

void FindBar::replace() {
  Editor* const editor = editor_();
  if (editor == nullptr) return;
  // What is selected may be something else: only what was found is replaced.
  if (!find(true, true)) return;
  editor->replace(replacement_->text());
  find_next();
}

void FindBar::replace_all() {
  Editor* const editor = editor_();
  if (editor == nullptr || wanted_->text().isEmpty()) return;
  int count = 0;
  int line = 0;
  int index = 0;
  editor->getCursorPosition(&line, &index);
  editor->beginUndoAction();
  bool found =
      editor->findFirst(wanted_->text(), is_pattern_->isChecked(), matches_case_->isChecked(),
                        whole_words_->isChecked(), false, true, 0, 0);
  // A pattern that nothing matches ("a*") would be found for ever in the same place.
  while (found && editor->hasSelectedText()) {
    editor->replace(replacement_->text());
    ++count;
    found = editor->findNext();
  }
  editor->endUndoAction();
  editor->setCursorPosition(line, index);
  tell(tr("%n replaced", "", count));
}

void FindBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    close_bar();
  } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    if (event->modifiers().testFlag(Qt::ShiftModifier)) {
      find_previous();
    } else if (replacement_->hasFocus()) {
      replace();
    } else {
      find_next();
    }
  } else {
    QWidget::keyPressEvent(event);
  }
}

}  // namespace eyebridge::gui
