#include "code/page.hpp"

#include <QFileInfo>
#include <QVBoxLayout>
#include <utility>

namespace eyebridge::gui {

Page::Page(int number, const QString& name, const QString& text, QWidget* parent)
    : QWidget(parent),
      number_(number),
      name_(name),
      notice_(new NoticeBar(this)),
      editor_(new Editor(this)) {
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(notice_);
  column->addWidget(editor_, 1);
  setFocusProxy(editor_);
  editor_->set_language(language_of(name));
  editor_->show_text(text);
  connect(editor_, &QsciScintilla::textChanged, this, [this] {
    if (on_change) on_change();
  });
  connect(editor_, &QsciScintilla::modificationChanged, this, [this] {
    if (on_change) on_change();
  });
}

void Page::tell(const QString& text, std::vector<NoticeBar::Answer> answers) {
  answers.push_back({tr("Close"), {}});
  notice_->tell(kTopic, text, answers);
}

void Page::set_path(const QString& path) {
  path_ = QFileInfo(path).absoluteFilePath();
  name_ = QFileInfo(path).fileName();
  example_.clear();
  if (editor_->language() != language_of(name_)) editor_->set_language(language_of(name_));
}

QString Page::open(const QString& path) {
  TextFile file;
  if (QString trouble = read_text(path, file); !trouble.isEmpty()) return trouble;
  file_ = file;
  set_path(path);
  editor_->show_text(file_.text);
  if (!QFileInfo(path).isWritable()) {
    tell(tr("%1 is write-protected: changes can be saved elsewhere.").arg(name_),
         {{tr("Save as..."), [this] { on_save_as(); }}});
  }
  if (on_change) on_change();
  return "";
}

QString Page::open_copy(const QString& path) {
  if (QString trouble = read_text(path, file_); !trouble.isEmpty()) return trouble;
  name_ = QFileInfo(path).fileName();
  example_ = QFileInfo(path).absoluteFilePath();
  editor_->set_language(language_of(name_));
  editor_->show_text(file_.text);
  return "";
}

void Page::restore(const Draft& draft) {
  name_ = draft.name;
  if (!draft.path.isEmpty()) {
    set_path(draft.path);
    // What is on disk now is what the person is asked to replace.
    TextFile disk;
    if (read_text(path_, disk).isEmpty()) file_ = disk;
  }
  editor_->set_language(language_of(name_));
  editor_->show_text(file_.text);
  editor_->replace_text(draft.text);
  is_unsaved_ = true;
  std::vector<NoticeBar::Answer> choices;
  if (!path_.isEmpty()) choices.push_back({tr("Go back to the saved file"), [this] { reload(); }});
  tell(tr("These changes to %1 were not saved when the program ended last.").arg(name_), choices);
}

bool Page::save() {
  TextFile disk;
  const bool exists = QFileInfo::exists(path_);
  // What cannot be read is not what we have read: it is not overwritten unasked, either.
  if (exists && (!read_text(path_, disk).isEmpty() || disk.bytes != file_.bytes)) {
    look_at_disk();
    return false;
  }
  return write(path_);
}

bool Page::save_as(const QString& path) {
  if (!write(path)) return false;
  set_path(path);
  if (on_change) on_change();
  return true;
}

bool Page::write(const QString& path) {
  TextFile file = file_;
  file.text = editor_->text();
  if (const QString trouble = write_text(path, file); !trouble.isEmpty()) {
    tell(trouble, {{tr("Save as..."), [this] { on_save_as(); }}});
    return false;
  }
  file_ = file;
  was_removed_ = false;
  notice_->end(kTopic);
  is_unsaved_ = false;
  editor_->setModified(false);
  if (on_change) on_change();
  return true;
}

void Page::reload() {
  TextFile disk;
  if (const QString trouble = read_text(path_, disk); !trouble.isEmpty()) {
    tell(trouble, {});
    return;
  }
  file_ = disk;
  editor_->replace_text(file_.text);
  is_unsaved_ = false;
  editor_->setModified(false);
  if (on_change) on_change();
}

void Page::look_at_disk() {
  if (path_.isEmpty()) return;
  TextFile disk;
  if (!QFileInfo::exists(path_)) {
    was_removed_ = true;
    is_unsaved_ = true;
    tell(tr("%1 was removed from the disk. Saving writes it again.").arg(name_), {});
    if (on_change) on_change();
    return;
  }
  if (const QString trouble = read_text(path_, disk); !trouble.isEmpty()) {
    tell(trouble, {{tr("Overwrite it"), [this] { static_cast<void>(write(path_)); }},
                   {tr("Save as..."), [this] { on_save_as(); }}});
    return;
  }
  if (disk.bytes == file_.bytes) {
    // It is back, if it was gone.
    if (was_removed_) {
      was_removed_ = false;
      is_unsaved_ = false;
      notice_->end(kTopic);
      if (on_change) on_change();
    }
    return;
  }
  tell(is_modified()
           ? tr("%1 was changed on the disk, and here, too. Loading it can be undone.").arg(name_)
           : tr("%1 was changed on the disk.").arg(name_),
       {{tr("Load it"), [this] { reload(); }},
        {tr("Overwrite it"), [this] { static_cast<void>(write(path_)); }},
        {tr("Save as..."), [this] { on_save_as(); }}});
}

}  // namespace eyebridge::gui
