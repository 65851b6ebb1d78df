#include "code/code_window.hpp"

#include <QCloseEvent>
#include <QDir>
#include <QDockWidget>
#include <QSettings>
#include <QStatusBar>
#include <QVBoxLayout>
#include <utility>

namespace eyebridge::gui {
namespace {

const QString kGeometryKey = "code/geometry";
const QString kStateKey = "code/state";
const QString kZoomKey = "code/zoom";
// How long a change waits until it is kept on disk, milliseconds: what a crash may cost.
constexpr int kDraftDelay_ms = 1000;
constexpr QSize kFirstSize(1000, 760);

}  // namespace

CodeWindow::CodeWindow(const QStringList& paths, CodeSettings settings)
    : settings_(std::move(settings)),
      recovery_(settings_.drafts, [this] { tell_of_drafts(); }),
      watch_([this] { disk_changed(); }) {
  const QSettings kept;
  zoom_ = kept.value(kZoomKey, 0).toInt();
  make_parts();
  make_file_menu();
  make_edit_menu();
  make_view_menu();
  make_run_menu();
  run_bar_->add_parts(*run_, *stop_);
  connect_runner();
  resize(kFirstSize);
  restoreGeometry(kept.value(kGeometryKey).toByteArray());
  restoreState(kept.value(kStateKey).toByteArray());
  recover();
  for (const QString& path : paths) open_file(path);
  if (page_count() == 0) new_program(templates().front());
  show_state();
}

CodeWindow::~CodeWindow() {
  QSettings kept;
  kept.setValue(kGeometryKey, saveGeometry());
  kept.setValue(kStateKey, saveState());
  kept.setValue(kZoomKey, zoom_);
  // It was not closed: a person has not said what is to become of the texts.
  if (!is_closing_) keep_drafts();
  runner_->on_state = {};
  runner_->on_end = {};
  runner_->on_output = {};
  tabs_->disconnect(this);
  for (int i = 0; i < tabs_->count(); ++i) {
    QDir(copy_folder(page_at(i))).removeRecursively();
    // What our parts still tell while they go finds nobody.
    page_at(i).on_change = {};
    page_at(i).editor().disconnect(this);
  }
}

void CodeWindow::make_parts() {
  auto* const middle = new QWidget(this);
  auto* const column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  tabs_ = new QTabWidget(middle);
  tabs_->setTabsClosable(true);
  tabs_->setMovable(true);
  tabs_->setDocumentMode(true);
  find_bar_ =
      new FindBar([this] { return page() == nullptr ? nullptr : &page()->editor(); }, middle);
  column->addWidget(tabs_, 1);
  column->addWidget(find_bar_);
  setCentralWidget(middle);
  connect(tabs_, &QTabWidget::currentChanged, this, [this] {
    show_titles();
    show_place_of_cursor();
    if (page() != nullptr) page()->editor().setFocus();
  });
  connect(tabs_, &QTabWidget::tabCloseRequested, this,
          [this](int index) { close_page(page_at(index)); });

  output_ = new OutputView(this);
  auto* const dock = new QDockWidget(tr("Output"), this);
  dock->setObjectName("output_dock");
  dock->setWidget(output_);
  addDockWidget(Qt::BottomDockWidgetArea, dock);

  run_bar_ = new RunBar(settings_, this);
  addToolBar(run_bar_);
  runner_ = new Runner(this);

  state_ = new QLabel(this);
  state_->setObjectName("state");
  place_ = new QLabel(this);
  place_->setObjectName("place");
  statusBar()->addWidget(state_, 1);
  statusBar()->addPermanentWidget(place_);

  draft_timer_.setSingleShot(true);
  draft_timer_.setInterval(kDraftDelay_ms);
  connect(&draft_timer_, &QTimer::timeout, this, [this] { keep_drafts(); });
}

Page* CodeWindow::page() const {
  return tabs_->count() == 0 ? nullptr : &page_at(tabs_->currentIndex());
}

void CodeWindow::show_place_of_cursor() {
  if (page() == nullptr) {
    place_->clear();
    return;
  }
  Editor& editor = page()->editor();
  int line = 0;
  int index = 0;
  editor.getCursorPosition(&line, &index);
  QString kind = tr("Text");
  if (editor.language() == Language::Python) kind = tr("Python");
  if (editor.language() == Language::C || editor.language() == Language::Cpp) {
    const QString language = editor.language() == Language::C ? tr("C") : tr("C++");
    const bool classic = editor.api() == Api::Classic;
    kind = tr("%1, %2").arg(language, classic ? tr("classic RoBIOS") : tr("RoBIOS-7"));
  }
  place_->setText(tr("Line %1, column %2   %3").arg(line + 1).arg(index + 1).arg(kind));
}

void CodeWindow::set_zoom(int zoom) {
  zoom_ = zoom;
  for (int i = 0; i < tabs_->count(); ++i) {
    Editor& editor = page_at(i).editor();
    if (editor.SendScintilla(QsciScintilla::SCI_GETZOOM) != zoom) editor.zoomTo(zoom);
  }
}

void CodeWindow::closeEvent(QCloseEvent* event) {
  event->ignore();
  if (!is_closing_) {
    QStringList names;
    for (int i = 0; i < tabs_->count(); ++i) {
      if (page_at(i).is_modified()) names << page_at(i).name();
    }
    const auto go_on = [this] {
      is_closing_ = true;
      close();
    };
    if (!names.isEmpty()) {
      ask_about_unsaved(
          names, [this, go_on] { save_all(go_on); }, go_on);
      return;
    }
    is_closing_ = true;
  }
  if (runner_->state() != Runner::State::Idle) {
    // What is typed from now on would be saved by nobody.
    centralWidget()->setEnabled(false);
    runner_->stop();  // its end closes us
    return;
  }
  draft_timer_.stop();
  for (int i = 0; i < tabs_->count(); ++i) recovery_.forget(page_at(i).number());
  // Now: a process whose last window is closed may end without destroying it.
  recovery_.finish();
  event->accept();
}

}  // namespace eyebridge::gui
