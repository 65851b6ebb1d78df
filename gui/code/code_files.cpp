// What the code panel opens, saves and closes.
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPointer>

#include "code/code_window.hpp"
#include "widgets/ask_for_file.hpp"
#include "widgets/recent_files.hpp"

namespace eyebridge::gui {
namespace {

QString canonical(const QString& path) {
  const QFileInfo file(path);
  return file.exists() ? file.canonicalFilePath() : file.absoluteFilePath();
}

}  // namespace

Page& CodeWindow::page_at(int index) const { return *static_cast<Page*>(tabs_->widget(index)); }

Page* CodeWindow::page_of(const QString& path) const {
  const QString wanted = canonical(path);
  for (int i = 0; i < tabs_->count(); ++i) {
    Page& page = page_at(i);
    const QString& own = page.path().isEmpty() ? page.example() : page.path();
    if (!own.isEmpty() && canonical(own) == wanted) return &page;
  }
  return nullptr;
}

Page& CodeWindow::add_page(const QString& name, const QString& text) {
  return add_page(recovery_.new_number(), name, text);
}

Page& CodeWindow::add_page(int number, const QString& name, const QString& text) {
  auto* const page = new Page(number, name, text, this);
  Editor& editor = page->editor();
  editor.leave_keys(keys_);
  editor.zoomTo(zoom_);
  page->on_change = [this, page] { page_changed(*page); };
  page->on_save_as = [this, page] { ask_where(*page, {}); };
  connect(&editor, &QsciScintilla::cursorPositionChanged, this, [this] { show_place_of_cursor(); });
  connect(&editor, &QsciScintillaBase::SCN_ZOOM, this, [this, &editor] {
    set_zoom(static_cast<int>(editor.SendScintilla(QsciScintilla::SCI_GETZOOM)));
  });
  tabs_->addTab(page, name);
  tabs_->setCurrentWidget(page);
  show_titles();
  show_state();
  return *page;
}

void CodeWindow::recover() {
  const QList<Draft> drafts = recovery_.take_lost();
  for (const Draft& draft : drafts) {
    Page& page = add_page(draft.number, draft.name, "");
    page.restore(draft);
    page_changed(page);
  }
  if (!recovery_.trouble().isEmpty()) state_->setText(recovery_.trouble());
}

bool CodeWindow::show_file(const QString& path) {
  Page* const open = page_of(path);
  if (open != nullptr) tabs_->setCurrentWidget(open);
  return open != nullptr;
}

Page* CodeWindow::open_file(const QString& path) {
  const QString examples = canonical(settings_.examples) + '/';
  if (!settings_.examples.isEmpty() && canonical(path).startsWith(examples))
    return open_example(path);
  if (Page* const open = page_of(path)) {
    tabs_->setCurrentWidget(open);
    return open;
  }
  TextFile file;
  if (const QString trouble = read_text(path, file); !trouble.isEmpty()) {
    state_->setText(trouble);
    return nullptr;
  }
  Page& page = add_page(QFileInfo(path).fileName(), "");
  // A second time: it may have been taken away in between.
  if (const QString trouble = page.open(path); !trouble.isEmpty()) {
    state_->setText(trouble);
    remove_page(page);
    return nullptr;
  }
  remember_file(kRecentPrograms, page.path());
  return &page;
}

Page* CodeWindow::open_example(const QString& path) {
  Page* const open = page_of(path);
  if (open != nullptr && !open->is_modified()) {
    tabs_->setCurrentWidget(open);
    return open;
  }
  Page& page = add_page(QFileInfo(path).fileName(), "");
  if (const QString trouble = page.open_copy(path); !trouble.isEmpty()) {
    state_->setText(trouble);
    remove_page(page);
    return nullptr;
  }
  page_changed(page);
  return &page;
}

Page* CodeWindow::new_program(const Template& begin) {
  const QFileInfo usual(begin.name);
  QString name = begin.name;
  const auto is_taken = [&] {
    for (int i = 0; i < tabs_->count(); ++i) {
      if (page_at(i).name() == name) return true;
    }
    return false;
  };
  for (int i = 2; is_taken(); ++i) {
    name = QString("%1-%2.%3").arg(usual.baseName()).arg(i).arg(usual.suffix());
  }
  Page& page = add_page(name, QString::fromUtf8(begin.text));
  page.editor().setFocus();
  return &page;
}

void CodeWindow::page_changed(Page& page) {
  watch_.add(page.path().toStdString());
  show_titles();
  show_place_of_cursor();
  if (!draft_timer_.isActive()) draft_timer_.start();
}

void CodeWindow::show_titles() {
  for (int i = 0; i < tabs_->count(); ++i) {
    Page& page = page_at(i);
    tabs_->setTabText(i, page.is_modified() ? page.name() + '*' : page.name());
    const QString copy = tr("Not saved yet");
    tabs_->setTabToolTip(i, page.path().isEmpty() ? copy : page.path());
  }
  const Page* const front = page();
  setWindowTitle(front == nullptr ? tr("EyeBridge code")
                                  : tr("%1[*] – EyeBridge code").arg(front->name()));
  setWindowModified(front != nullptr && front->is_modified());
}

void CodeWindow::keep_now() {
  if (!is_closing_) keep_drafts();
  recovery_.finish();
}

void CodeWindow::keep_drafts() {
  for (int i = 0; i < tabs_->count(); ++i) {
    const Page& page = page_at(i);
    if (!page.is_modified()) {
      recovery_.forget(page.number());
    } else if (!recovery_.keep(page.draft())) {
      tell_of_drafts();
    }
  }
}

void CodeWindow::tell_of_drafts() {
  state_->setText(tr("Unsaved texts cannot be kept in %1: save them").arg(settings_.drafts));
}

void CodeWindow::ask_for_files() {
  const QString folder = page() == nullptr ? QString() : QFileInfo(page()->path()).path();
  auto* const dialog = new QFileDialog(this, tr("Open"), folder,
                                       tr("Programs (*.c *.h *.cpp *.hpp *.py);;All files (*)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFiles);
  connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& paths) {
    for (const QString& path : paths) open_file(path);
  });
  dialog->open();
}

bool CodeWindow::save_as(Page& page, const QString& path) {
  const QString examples = canonical(settings_.examples) + '/';
  if (!settings_.examples.isEmpty() && canonical(path).startsWith(examples)) {
    page.tell(tr("%1 is an example, which stays as it is. Choose another folder.").arg(path),
              {{tr("Save as..."), [this, &page] { ask_where(page, {}); }}});
    return false;
  }
  const QString before = page.path();
  const bool saved = page.save_as(path);
  page_changed(page);
  leave_file(before);
  if (saved) remember_file(kRecentPrograms, page.path());
  return saved;
}

void CodeWindow::save(Page& page, const std::function<void()>& then) {
  if (page.path().isEmpty()) {
    ask_where(page, then);
    return;
  }
  if (page.save() && then) then();
}

void CodeWindow::save_all(const std::function<void()>& then) {
  for (int i = 0; i < tabs_->count(); ++i) {
    Page& page = page_at(i);
    if (!page.is_modified()) continue;
    tabs_->setCurrentIndex(i);
    // The rest when this one is done, which may take a person some time.
    save(page, [this, then] { save_all(then); });
    return;
  }
  if (then) then();
}

void CodeWindow::ask_where(Page& page, const std::function<void()>& then) {
  ask_where_to_save(*this, tr("Save as"), page.path().isEmpty() ? page.name() : page.path(), {},
                    [this, still = QPointer(&page), then](const QString& path) {
                      if (still && save_as(*still, path) && then) then();
                    });
}

void CodeWindow::ask_about_unsaved(const QStringList& names, const std::function<void()>& save,
                                   const std::function<void()>& discard) {
  auto* const box =
      new QMessageBox(QMessageBox::Question, tr("Unsaved changes"),
                      tr("%1: changes are not saved.").arg(names.join(tr(", "))),
                      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  connect(box, &QMessageBox::finished, this, [save, discard](int answer) {
    if (answer == QMessageBox::Save) save();
    if (answer == QMessageBox::Discard) discard();
  });
  box->open();
}

void CodeWindow::close_page(Page& page) {
  if (!page.is_modified()) {
    remove_page(page);
    return;
  }
  tabs_->setCurrentWidget(&page);
  const QPointer<Page> still(&page);
  const auto remove = [this, still] {
    if (still) remove_page(*still);
  };
  const auto save_it = [this, still, remove] {
    if (still) save(*still, remove);
  };
  ask_about_unsaved({page.name()}, save_it, remove);
}

void CodeWindow::remove_page(Page& page) {
  page.on_change = {};
  if (ran_ == &page) ran_.clear();
  recovery_.forget(page.number());
  QDir(copy_folder(page)).removeRecursively();
  tabs_->removeTab(tabs_->indexOf(&page));
  leave_file(page.path());
  page.deleteLater();
  show_titles();
  show_state();
}

void CodeWindow::leave_file(const QString& path) {
  if (!path.isEmpty() && page_of(path) == nullptr) watch_.leave(path.toStdString());
}

void CodeWindow::disk_changed() {
  for (const auto& path : watch_.take_changed()) {
    if (Page* const page = page_of(QString::fromStdString(path.string()))) page->look_at_disk();
  }
}

}  // namespace eyebridge::gui
