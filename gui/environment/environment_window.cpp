#include "environment/environment_window.hpp"

#include <QAction>
#include <QCloseEvent>
#include <QDockWidget>
#include <QSettings>
#include <QStatusBar>
#include <exception>

#include "eyebridge/base/units.hpp"

namespace eyebridge::gui {
namespace {

constexpr int kRefresh_ms = 16;
constexpr int kFramesPerReading = 12;  // five times a second: who reads numbers is slower
constexpr int kFramesPerScene = 3;     // 20 pictures a second, each some milliseconds without a GPU

}  // namespace

EnvironmentWindow::EnvironmentWindow(hal::Environment& environment, const QString& program,
                                     robios::Crew* crew)
    : environment_(environment),
      crew_(crew),
      program_(program),
      view_(new WorldView(environment, this)) {
  setWindowTitle(tr("%1 – environment").arg(program));
  setCentralWidget(view_);
  make_docks();
  make_status();
  make_file_menu();
  make_time_menu();
  make_robot_menu();
  make_view_menu();
  // As it was left.
  const QSettings settings;
  restoreGeometry(settings.value("environment/geometry").toByteArray());
  restoreState(settings.value("environment/state").toByteArray());
  view_->setFocus();
  connect(&timer_, &QTimer::timeout, this, [this] { refresh(); });
  refresh();
}

EnvironmentWindow::~EnvironmentWindow() {
  if (isVisible()) keep_layout();
}

QDockWidget* EnvironmentWindow::add_dock(const QString& title, const char* name,
                                         Qt::DockWidgetArea area, QWidget* widget) {
  auto* const dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setWidget(widget);
  addDockWidget(area, dock);
  return dock;
}

void EnvironmentWindow::make_docks() {
  readings_ = new Readings(this);
  events_ = new EventLog(this);
  scene_ = new SceneView(environment_.directory(), this);
  errors_ = new ErrorPanel(environment_, this);
  add_dock(tr("Readings"), "readings", Qt::BottomDockWidgetArea, readings_);
  add_dock(tr("Events"), "events", Qt::BottomDockWidgetArea, events_);
  // Opened by who wants them: pictures in 3D take the computer's time.
  scene_dock_ = add_dock(tr("3D"), "scene", Qt::RightDockWidgetArea, scene_);
  scene_dock_->hide();
  add_dock(tr("Errors"), "errors", Qt::RightDockWidgetArea, errors_)->hide();
  make_adding();
  view_->on_menu = [this](QPoint place) { show_robot_menu(place); };
  view_->on_thing_menu = [this](QPoint place, std::size_t object) {
    show_thing_menu(place, static_cast<int>(object) + 1);
  };
  view_->on_look = [this](const hal::WorldLook& look) { events_->add(look); };
  errors_->on_trouble = [this](const QString& text) { trouble_->setText(text); };
}

void EnvironmentWindow::make_adding() {
  adding_ = new AddRobotPanel(crew_, this);
  adding_dock_ = add_dock(tr("Add robot"), "add_robot", Qt::RightDockWidgetArea, adding_);
  things_ = new AddThingPanel(environment_, this);
  things_dock_ = add_dock(tr("Add thing"), "add_thing", Qt::RightDockWidgetArea, things_);
  const auto ask_with = [this](auto& panel, auto& other) {
    const auto place = [this, &panel, &other](bool places) {
      if (places) {
        measure_->setChecked(false);
        other.place_button().setChecked(false);
        view_->on_place = [&panel](const Pose& pose) { panel.add(pose); };
      }
      view_->set_tool(places ? Tool::Place : Tool::Hand);
    };
    connect(&panel.place_button(), &QPushButton::toggled, this, place);
    panel.on_answer = [this](const QString& text) { tell(text); };
  };
  ask_with(*adding_, *things_);
  ask_with(*things_, *adding_);
  adding_dock_->hide();
  things_dock_->hide();
}

void EnvironmentWindow::stop_placing() {
  adding_->place_button().setChecked(false);
  things_->place_button().setChecked(false);
}

MapView& EnvironmentWindow::show_map(const QString& title, const robios::MapBoard& board) {
  auto* const dock = new QDockWidget(title, this);
  dock->setObjectName("map " + title);
  auto* const map = new MapView(board, this);
  dock->setWidget(map);
  addDockWidget(Qt::RightDockWidgetArea, dock);
  restoreDockWidget(dock);  // where it was left, if it was
  dock->show();
  maps_.push_back(map);
  return *map;
}

void EnvironmentWindow::make_status() {
  time_ = new QLabel(this);
  time_->setObjectName("time");
  pointer_ = new QLabel(this);
  trouble_ = new QLabel(this);
  trouble_->setObjectName("trouble");
  statusBar()->addWidget(time_);
  statusBar()->addWidget(pointer_);
  statusBar()->addWidget(trouble_, 1);
  view_->on_pointer = [this](Vec2 place) {
    pointer_->setText(
        QString("x %1  y %2 mm").arg(m_to_mm(place.x), 0, 'f', 0).arg(m_to_mm(place.y), 0, 'f', 0));
  };
  view_->on_trouble = [this](const QString& text) { trouble_->setText(text); };
  trouble_->setText(view_->missing());
}

void EnvironmentWindow::refresh() {
  view_->refresh();
  errors_->follow(view_->look());
  adding_->follow(view_->look());
  remove_->setEnabled(crew_ != nullptr && view_->chosen().has_value());
  // The other side may be paused by another window, or have ended.
  if (pause_->isChecked() != environment_.time().is_paused()) {
    pause_->setChecked(environment_.time().is_paused());
  }
  if (frames_ % kFramesPerReading == 0) {
    readings_->show_robot(view_->look(), view_->mirror(), view_->chosen());
  }
  if (frames_ % kFramesPerScene == 0) {
    scene_->refresh(view_->look(), view_->chosen());
    for (MapView* const map : maps_) map->refresh();
  }
  ++frames_;
  add_to_film();
  show_time();
}

void EnvironmentWindow::add_to_film() {
  if (!film_ || !film_->is_due(view_->look().scene.time)) return;
  try {
    film_->add(view_->grab().toImage(), view_->look().scene.time);
  } catch (const std::exception& error) {
    stop_film();
    trouble_->setText(tr("The film has ended: %1").arg(error.what()));
  }
}

void EnvironmentWindow::closeEvent(QCloseEvent* event) {
  // Now: a process whose last window is closed may end without destroying it.
  stop_film();
  timer_.stop();
  keep_layout();
  QMainWindow::closeEvent(event);
}

void EnvironmentWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  timer_.start(kRefresh_ms);
}

void EnvironmentWindow::keep_layout() {
  QSettings settings;
  settings.setValue("environment/geometry", saveGeometry());
  settings.setValue("environment/state", saveState());
}

void EnvironmentWindow::show_time() {
  time_->setText(tr("%1 s%2")
                     .arg(view_->look().scene.time, 0, 'f', 2)
                     .arg((environment_.time().is_paused() ? tr(", paused") : QString()) +
                          (film_ ? tr(", filming") : QString())));
}

void EnvironmentWindow::tell(const QString& text) {
  trouble_->setText(text);
  events_->add(text);
}

void EnvironmentWindow::tell_end(const QString& how) {
  tell(how);
  setWindowTitle(tr("%1 – ended").arg(windowTitle()));
}

}  // namespace eyebridge::gui
