#include "editor/editor_window.hpp"

#include <QAction>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QScrollArea>
#include <QSettings>
#include <QVBoxLayout>
#include <utility>

#include "eyebridge/base/units.hpp"
#include "widgets/recent_files.hpp"

namespace eyebridge::gui {
namespace {

constexpr double kNewSide = 4.0;    // metres
constexpr double kUsualGrid = 0.1;  // metres
constexpr int kPanelWidth = 270;    // pixels
constexpr int kAutosaveDelay_ms = 2000;

}  // namespace

EditorWindow::EditorWindow(const QString& path)
    : document_(empty_plan(kNewSide, kNewSide)), watch_([this] { disk_changed(); }) {
  auto* const middle = new QWidget(this);
  auto* const column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  notices_ = new NoticeBar(middle);
  canvas_ = new Canvas(document_, middle);
  column->addWidget(notices_);
  column->addWidget(canvas_, 1);
  setCentralWidget(middle);

  properties_ = new PropertyPanel(document_, this);
  auto* const scroll = new QScrollArea(this);
  scroll->setWidget(properties_);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(kPanelWidth);
  auto* const dock = new QDockWidget(tr("Properties"), this);
  dock->setObjectName("properties");
  dock->setWidget(scroll);
  addDockWidget(Qt::RightDockWidgetArea, dock);

  make_file_menu();
  make_edit_menu();
  make_tool_menu();
  make_view_menu();
  make_status();
  const QSettings settings;
  restoreGeometry(settings.value("editor/geometry").toByteArray());
  restoreState(settings.value("editor/state").toByteArray());

  document_.on_change = [this] { refresh(); };
  connect(&document_.history(), &QUndoStack::cleanChanged, this, [this] { refresh(); });
  autosave_timer_.setSingleShot(true);
  autosave_timer_.setInterval(kAutosaveDelay_ms);
  connect(&autosave_timer_, &QTimer::timeout, this, [this] { keep_edits(); });
  if (path.isEmpty() || !open(path)) take({});
  canvas_->setFocus();
}

EditorWindow::~EditorWindow() {
  document_.on_change = {};
  disconnect(&document_.history(), nullptr, this, nullptr);  // it still tells when it ends
  keep_edits();                                              // nobody has said what becomes of them
  QSettings settings;
  settings.setValue("editor/geometry", saveGeometry());
  settings.setValue("editor/state", saveState());
}

QString EditorWindow::path() const { return QString::fromStdString(files_.path.string()); }

void EditorWindow::refresh() {
  const Plan& plan = document_.settled();
  if (!files::same_meaning(plan.rest, described_)) show_catalogue();
  if (plan.texture != textured_) show_texture();
  canvas_->refresh();
  properties_->refresh();
  setWindowModified(!document_.history().isClean());
  if (!document_.history().isClean()) {
    // From the first edit: who goes on working would put it off for ever.
    if (!autosave_timer_.isActive()) autosave_timer_.start();
  } else {
    autosave_timer_.stop();
    drop_own();
  }
}

void EditorWindow::take(PlanFiles files) {
  if (files.path.empty()) files.plan = empty_plan(kNewSide, kNewSide);
  for (const char* topic : {"disk", "save", "warnings", "run", "recovery", "unreadable"})
    notices_->end(topic);
  files_ = std::move(files);
  autosave_.reset();
  const auto on_change = std::exchange(document_.on_change, {});
  document_.history().clear();
  document_.select({});
  const Plan plan = files_.plan;
  document_.edit({}, [&](Plan& changed) { changed = plan; });
  document_.history().clear();  // it is where we begin
  document_.on_change = on_change;
  // Not before: a clean history means that there is nothing to recover.
  take_autosave();
  show_files();
  tell_warnings();
  // In a maze walls lie on the grid, and starts in the middle of its cells.
  const auto& cell = files_.plan.cell;
  grid_->setValue(m_to_mm(cell ? *cell / 2 : kUsualGrid));
  canvas_->fit();
  refresh();
}

void EditorWindow::show_files() {
  const QString name = files_.path.empty() ? tr("unnamed") : QFileInfo(path()).fileName();
  setWindowTitle(tr("%1[*] – world editor").arg(name));
  watch_.follow({files_.path, files_.ground});
  if (!files_.path.empty()) remember_file(kRecentWorlds, path());
  show_catalogue();
  show_texture();
}

bool EditorWindow::open(const QString& path) {
  try {
    take(open_plan(path.toStdString()));
    return true;
  } catch (const ConfigError& error) {
    notices_->tell("open", QString::fromStdString(error.what()));
    return false;
  }
}

void EditorWindow::make_new() { take({}); }

void EditorWindow::closeEvent(QCloseEvent* event) {
  if (document_.history().isClean()) {
    drop_own();
    event->accept();
    return;
  }
  event->ignore();
  when_free([this] { close(); });
}

}  // namespace eyebridge::gui
