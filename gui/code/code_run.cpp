// What the code panel builds and runs.
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>

#include "code/code_window.hpp"

namespace eyebridge::gui {

QString CodeWindow::copy_folder(const Page& page) const {
  const QString key = QString("%1/%2").arg(QCoreApplication::applicationPid()).arg(page.number());
  return build_folder(settings_, key);
}

bool CodeWindow::prepare(Page& page, ProgramSource& source) {
  for (int i = 0; i < tabs_->count(); ++i) {
    Page& other = page_at(i);
    if (!other.is_modified() || other.path().isEmpty() || other.save()) continue;
    tabs_->setCurrentWidget(&other);
    state_->setText(tr("Not run: %1 was not saved").arg(other.name()));
    return false;
  }
  source.language = page.editor().language();
  source.is_classic = page.editor().api() == Api::Classic;
  source.file = page.path();
  if (!source.file.isEmpty()) return true;
  // A copy: who tries an example, or a template, has not to think of a place for it.
  const QDir folder(copy_folder(page));
  folder.mkpath("source");
  source.file = folder.filePath("source/" + page.name());
  source.build = folder.path();
  if (!page.example().isEmpty()) source.home = QFileInfo(page.example()).absolutePath();
  TextFile file;
  file.text = page.editor().text();
  const QString trouble = write_text(source.file, file);
  if (!trouble.isEmpty()) page.tell(trouble, {});
  return trouble.isEmpty();
}

void CodeWindow::run(bool only_build) {
  if (page() == nullptr || runner_->state() != Runner::State::Idle) return;
  ProgramSource source;
  if (!prepare(*page(), source)) return;
  QList<Step> plan = plan_run(source, run_bar_->choice(), settings_);
  if (plan.isEmpty()) {
    state_->setText(tr("%1 is no program; expected a file of C (.c), C++ (.cpp) or Python (.py)")
                        .arg(page()->name()));
    return;
  }
  if (only_build) plan.removeLast();
  if (plan.isEmpty()) {
    state_->setText(tr("Programs in Python need not be built"));
    return;
  }
  output_->start_anew();
  for (int i = 0; i < tabs_->count(); ++i) page_at(i).editor().clear_marks();
  ran_ = page();
  source_ = source;
  findChild<QDockWidget*>("output_dock")->show();
  runner_->start(plan);
}

void CodeWindow::connect_runner() {
  runner_->on_output = [this](const QByteArray& bytes) { output_->add(bytes); };
  runner_->on_state = [this](const QString& how) {
    state_->setText(how);
    show_state();
  };
  runner_->on_end = [this](bool well) {
    output_->flush();
    if (is_closing_) {
      close();
      return;
    }
    if (well || source_.file.isEmpty()) return;
    const bool is_python = source_.language == Language::Python;
    // Where a compiler stumbled first; where Python was when it gave up.
    output_->choose_if(
        [this](const Message& message) {
          return message.severity == Message::Severity::Error &&
                 page_for(QString::fromStdString(message.file), false) != nullptr;
        },
        is_python);
  };
  output_->on_message = [this](const Message& message) { message_came(message); };
  output_->on_chosen = [this](const Message& message) { show_place(message); };
}

void CodeWindow::show_state() {
  const bool idle = runner_->state() == Runner::State::Idle;
  run_->setEnabled(idle && page() != nullptr);
  build_->setEnabled(idle && page() != nullptr);
  stop_->setEnabled(!idle && runner_->state() != Runner::State::Stopping);
}

Page* CodeWindow::page_for(const QString& file, bool opens) {
  QFileInfo named(QFileInfo(source_.file).absoluteDir(), file);
  if (!named.exists() && !source_.home.isEmpty()) named = QFileInfo(QDir(source_.home), file);
  // Compilers and Python may name it by another way than we do.
  const QString path = named.exists() ? named.canonicalFilePath() : named.absoluteFilePath();
  if (path == QFileInfo(source_.file).canonicalFilePath() && ran_) return ran_;
  if (Page* const open = page_of(path)) return open;
  return opens && named.isFile() ? open_file(path) : nullptr;
}

void CodeWindow::message_came(const Message& message) {
  Page* const page = page_for(QString::fromStdString(message.file), false);
  if (page != nullptr) page->editor().mark(message.line, message.severity);
}

void CodeWindow::show_place(const Message& message) {
  Page* const page = page_for(QString::fromStdString(message.file), true);
  if (page == nullptr) {
    state_->setText(tr("%1 is not there").arg(QString::fromStdString(message.file)));
    return;
  }
  tabs_->setCurrentWidget(page);
  page->editor().mark(message.line, message.severity);
  page->editor().go_to(message.line, message.column);
  page->editor().setFocus();
}

}  // namespace eyebridge::gui
