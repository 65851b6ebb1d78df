#include "environment/environment_window.hpp"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QMenuBar>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>

#include "eyebridge/base/units.hpp"

namespace eyebridge::gui {
namespace {

constexpr int kRefresh_ms = 16;
constexpr int kFramesPerReading = 12;  // five times a second: who reads numbers is slower

}  // namespace

EnvironmentWindow::EnvironmentWindow(hal::Environment& environment, const QString& program)
    : environment_(environment), view_(new WorldView(environment, this)) {
  setWindowTitle(tr("%1 – environment").arg(program));
  setCentralWidget(view_);
  make_docks();
  make_status();
  make_file_menu();
  make_time_menu();
  make_view_menu();
  // As it was left.
  const QSettings settings;
  restoreGeometry(settings.value("environment/geometry").toByteArray());
  restoreState(settings.value("environment/state").toByteArray());
  view_->setFocus();
  connect(&timer_, &QTimer::timeout, this, [this] { refresh(); });
  timer_.start(kRefresh_ms);
  refresh();
}

EnvironmentWindow::~EnvironmentWindow() {
  QSettings settings;
  settings.setValue("environment/geometry", saveGeometry());
  settings.setValue("environment/state", saveState());
}

void EnvironmentWindow::make_docks() {
  const auto add = [this](const QString& title, const char* name, QWidget* widget) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(widget);
    addDockWidget(Qt::BottomDockWidgetArea, dock);
  };
  readings_ = new Readings(this);
  events_ = new EventLog(this);
  add(tr("Readings"), "readings", readings_);
  add(tr("Events"), "events", events_);
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
}

QAction* EnvironmentWindow::add_action(QMenu& menu, const QString& text, const QKeySequence& key,
                                       const std::function<void()>& act) {
  QAction* const action = menu.addAction(text);
  action->setShortcut(key);
  connect(action, &QAction::triggered, this, [act] { act(); });
  return action;
}

QAction* EnvironmentWindow::add_switch(QMenu& menu, const QString& text, const QKeySequence& key,
                                       bool is_on, const std::function<void(bool)>& act) {
  QAction* const action = menu.addAction(text);
  action->setCheckable(true);
  action->setChecked(is_on);
  action->setShortcut(key);
  connect(action, &QAction::toggled, this, act);
  return action;
}

void EnvironmentWindow::make_file_menu() {
  QMenu& menu = *menuBar()->addMenu(tr("&File"));
  add_action(menu, tr("&Save picture..."), QKeySequence::Save, [this] { ask_for_picture(); });
  menu.addSeparator();
  add_action(menu, tr("&Close"), QKeySequence::Close, [this] { close(); });
}

void EnvironmentWindow::make_time_menu() {
  hal::TimeControl& time = environment_.time();
  QMenu& menu = *menuBar()->addMenu(tr("&Time"));
  pause_ =
      add_switch(menu, tr("&Pause"), Qt::Key_Space, time.is_paused(), [this, &time](bool pause) {
        if (pause) {
          time.pause();
        } else {
          time.resume();
        }
        step_->setEnabled(pause);
      });
  step_ = add_action(menu, tr("&Step"), Qt::Key_Period, [this] { environment_.time().step(); });
  step_->setEnabled(time.is_paused());
  factor_ = new QComboBox(this);
  factor_->setToolTip(tr("Seconds of the world in a second"));
  factor_->setFocusPolicy(Qt::NoFocus);
  for (const double factor : {0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 100.0}) {
    factor_->addItem(QString("%1x").arg(factor), factor);
  }
  if (time.factor() == hal::TimeControl::kFastest) {
    factor_->addItem(tr("fastest"), hal::TimeControl::kFastest);
  }
  if (factor_->findData(time.factor()) < 0) {
    factor_->addItem(QString("%1x").arg(time.factor()), time.factor());
  }
  factor_->setCurrentIndex(factor_->findData(time.factor()));
  connect(factor_, &QComboBox::currentIndexChanged, this, [this] {
    if (const auto done = environment_.time().set_factor(factor_->currentData().toDouble());
        !done) {
      trouble_->setText(QString::fromStdString(done.error().what));
    }
  });
  QToolBar& bar = *addToolBar(tr("Time"));
  bar.setObjectName("time_bar");
  bar.addAction(pause_);
  bar.addAction(step_);
  bar.addWidget(factor_);
}

void EnvironmentWindow::make_view_menu() {
  QMenu& menu = *menuBar()->addMenu(tr("&View"));
  constexpr double kZoom = 1.25;
  QAction* const fit = add_action(menu, tr("&Fit"), Qt::Key_F, [this] {
    follow_->setChecked(false);
    view_->fit();
  });
  add_action(menu, tr("Zoom &in"), QKeySequence::ZoomIn, [this] { view_->zoom(kZoom); });
  add_action(menu, tr("Zoom &out"), QKeySequence::ZoomOut, [this] { view_->zoom(1 / kZoom); });
  follow_ = add_switch(menu, tr("F&ollow robot"), Qt::Key_O, false,
                       [this](bool follows) { view_->follow(follows); });
  menu.addSeparator();
  const auto layer = [&](const QString& text, const QKeySequence& key, bool Layers::*member) {
    add_switch(menu, text, key, view_->layers().*member, [this, member](bool on) {
      Layers layers = view_->layers();
      layers.*member = on;
      view_->set_layers(layers);
    });
  };
  layer(tr("&Trails"), Qt::Key_T, &Layers::trails);
  layer(tr("&Distance sensors"), Qt::Key_D, &Layers::distances);
  layer(tr("In&frared"), Qt::Key_I, &Layers::proximities);
  layer(tr("&LIDAR"), Qt::Key_L, &Layers::lidar);
  layer(tr("&Camera"), Qt::Key_C, &Layers::camera);
  add_action(menu, tr("Cl&ear trails"), Qt::Key_E, [this] { view_->clear_trails(); });
  menu.addSeparator();
  for (QDockWidget* dock : findChildren<QDockWidget*>()) menu.addAction(dock->toggleViewAction());
  QToolBar& bar = *addToolBar(tr("View"));
  bar.setObjectName("view_bar");
  bar.addAction(fit);
  bar.addAction(follow_);
}

void EnvironmentWindow::refresh() {
  view_->refresh();
  events_->add(view_->look());
  // The other side may be paused by another window, or have ended.
  if (pause_->isChecked() != environment_.time().is_paused()) {
    pause_->setChecked(environment_.time().is_paused());
  }
  if (frames_++ % kFramesPerReading == 0) {
    readings_->show_robot(view_->look(), view_->mirror(), view_->chosen());
  }
  show_time();
}

void EnvironmentWindow::show_time() {
  time_->setText(tr("%1 s%2")
                     .arg(view_->look().scene.time, 0, 'f', 2)
                     .arg(environment_.time().is_paused() ? tr(", paused") : QString()));
}

void EnvironmentWindow::tell_end(const QString& how) {
  events_->add(how);
  trouble_->setText(how);
}

bool EnvironmentWindow::save_picture(const QString& path) { return view_->grab().save(path); }

void EnvironmentWindow::ask_for_picture() {
  const QString path = QFileDialog::getSaveFileName(this, tr("Save picture"), "environment.png",
                                                    tr("Pictures (*.png *.jpg)"));
  if (path.isEmpty()) return;
  trouble_->setText(save_picture(path) ? tr("Saved %1").arg(path)
                                       : tr("%1 cannot be written").arg(path));
}

}  // namespace eyebridge::gui
