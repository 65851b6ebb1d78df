// The menus of the environment's window, and what they save.
#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QMenuBar>
#include <QToolBar>
#include <exception>

#include "environment/environment_window.hpp"
#include "widgets/ask_for_file.hpp"
#include "widgets/recent_files.hpp"
#include "widgets/save_picture.hpp"

namespace eyebridge::gui {

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
  film_switch_ =
      add_switch(menu, tr("&Film..."), QKeySequence("Ctrl+R"), false, [this](bool films) {
        if (films) {
          ask_for_film();
        } else {
          stop_film();
        }
      });
  menu.addSeparator();
  add_action(menu, tr("&New world"), QKeySequence::New, [this] {
    if (on_edit) on_edit({});
  });
  add_action(menu, tr("&Edit world or program..."), QKeySequence::Open, [this] { ask_for_file(); });
  offer_recent_files(*menu.addMenu(tr("Open &recent")), {kRecentWorlds, kRecentPrograms},
                     [this](const QString& path) {
                       if (on_edit) on_edit(path);
                     });
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
  factor_->setObjectName("factor");
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

void EnvironmentWindow::make_robot_menu() {
  QMenu& menu = *menuBar()->addMenu(tr("&Robot"));
  add_action(menu, tr("&Next"), Qt::Key_N, [this] { view_->choose_next(); });
  QAction* const adding = adding_dock_->toggleViewAction();
  adding->setShortcut(Qt::Key_A);
  menu.addAction(adding);
  QAction* const things = things_dock_->toggleViewAction();
  things->setShortcut(QKeySequence("Shift+A"));
  menu.addAction(things);
  drive_ = add_switch(menu, tr("&Drive with the arrow keys"), Qt::Key_K, false,
                      [this](bool drives) { view_->set_driving(drives); });
  make_removal(menu);
}

void EnvironmentWindow::make_view_menu() {
  QMenu& menu = *menuBar()->addMenu(tr("&View"));
  constexpr double kZoom = Viewport::kZoomStep;
  QAction* const fit = add_action(menu, tr("&Fit"), Qt::Key_F, [this] {
    follow_->setChecked(false);
    view_->fit();
  });
  add_action(menu, tr("Zoom &in"), QKeySequence::ZoomIn, [this] { view_->zoom(kZoom); });
  add_action(menu, tr("Zoom &out"), QKeySequence::ZoomOut, [this] { view_->zoom(1 / kZoom); });
  follow_ = add_switch(menu, tr("F&ollow robot"), Qt::Key_O, false,
                       [this](bool follows) { view_->follow(follows); });
  centre_ =
      add_action(menu, tr("Centre on &robot"), Qt::Key_R, [this] { view_->centre_on_robot(); });
  measure_ = add_switch(menu, tr("&Measure"), Qt::Key_M, false, [this](bool measures) {
    if (measures) stop_placing();
    view_->set_tool(measures ? Tool::Tape : Tool::Hand);
  });
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
  layer(tr("&Bumpers"), Qt::Key_B, &Layers::bumpers);
  layer(tr("&Uncertainty of the pose"), Qt::Key_U, &Layers::uncertainty);
  add_action(menu, tr("Cl&ear trails"), Qt::Key_E, [this] { view_->clear_trails(); });
  menu.addSeparator();
  make_scene_menu(menu);
  for (QDockWidget* dock : findChildren<QDockWidget*>()) menu.addAction(dock->toggleViewAction());
  QToolBar& bar = *addToolBar(tr("View"));
  bar.setObjectName("view_bar");
  bar.addAction(fit);
  bar.addAction(follow_);
  bar.addAction(measure_);
  bar.addAction(drive_);
  bar.addAction(scene_dock_->toggleViewAction());
}

void EnvironmentWindow::make_scene_menu(QMenu& menu) {
  scene_dock_->toggleViewAction()->setShortcut(Qt::Key_3);
  QMenu& eye = *menu.addMenu(tr("3D &from"));
  auto* const group = new QActionGroup(this);
  const auto add = [&](const QString& text, const QKeySequence& key, SceneView::From from) {
    QAction* const action =
        add_switch(eye, text, key, scene_->from() == from, [this, from](bool on) {
          if (on) scene_->set_from(from);
        });
    group->addAction(action);
  };
  add(tr("&Anywhere"), QKeySequence("Ctrl+1"), SceneView::From::Free);
  add(tr("&Behind the robot"), QKeySequence("Ctrl+2"), SceneView::From::BehindRobot);
  add(tr("The robot's &camera"), QKeySequence("Ctrl+3"), SceneView::From::RobotsCamera);
}

bool EnvironmentWindow::save_picture(const QString& path) {
  return gui::save_picture(view_->grab().toImage(), path);
}

void EnvironmentWindow::ask_for_picture() {
  ask_where_to_save_picture(
      *this, tr("Save picture"), "environment.png", [this](const QString& path) {
        trouble_->setText(save_picture(path) ? tr("Saved %1").arg(path)
                                             : tr("%1 cannot be written").arg(path));
      });
}

void EnvironmentWindow::ask_for_file() {
  gui::ask_for_file(*this, tr("Edit"), QString::fromStdString(environment_.directory()),
                    tr("Worlds and programs (*.wld *.maz *.sim *.c *.cpp *.h *.py)"),
                    [this](const QString& path) {
                      if (on_edit) on_edit(path);
                    });
}

bool EnvironmentWindow::start_film(const QString& path) {
  try {
    film_.emplace(path, view_->grab().toImage(), view_->look().scene.time);
    trouble_->setText({});
  } catch (const std::exception& error) {
    trouble_->setText(QString::fromStdString(error.what()));
  }
  film_switch_->setChecked(film_.has_value());
  return film_.has_value();
}

void EnvironmentWindow::stop_film() {
  if (auto* const asks = findChild<QDialog*>("film")) asks->deleteLater();
  film_.reset();
  film_switch_->setChecked(false);
}

void EnvironmentWindow::ask_for_film() {
  if (film_) return;  // by start_film()
  auto& dialog = ask_where_to_save(*this, tr("Film"), program_ + ".mp4", tr("Videos (*.mp4 *.avi)"),
                                   [this](const QString& path) { start_film(path); });
  dialog.setObjectName("film");
  connect(&dialog, &QDialog::rejected, this, [this] { film_switch_->setChecked(false); });
}

}  // namespace eyebridge::gui
