#pragma once

#include <QLabel>
#include <QMainWindow>
#include <QTimer>
#include <functional>
#include <optional>
#include <vector>

#include "environment/add_robot_panel.hpp"
#include "environment/add_thing_panel.hpp"
#include "environment/error_panel.hpp"
#include "environment/event_log.hpp"
#include "environment/film.hpp"
#include "environment/map_view.hpp"
#include "environment/readings.hpp"
#include "environment/scene_view.hpp"
#include "environment/world_view.hpp"

class QAction;
class QComboBox;
class QDockWidget;

namespace eyebridge::gui {

/// The driving environment: the world from above, its time, and what goes on in it.
class EnvironmentWindow final : public QMainWindow {
  Q_OBJECT
 public:
  /// `environment` and `crew` are lent; null where nobody can be added or removed.
  EnvironmentWindow(hal::Environment& environment, const QString& program,
                    robios::Crew* crew = nullptr);
  ~EnvironmentWindow() override;

  [[nodiscard]] hal::Environment& environment() { return environment_; }
  [[nodiscard]] WorldView& view() { return *view_; }
  /// Told of a file that a person wants to edit; empty for a new world.
  std::function<void(const QString&)> on_edit;
  /// The program has ended, `how` in words: the world stays as long as the window.
  void tell_end(const QString& how);
  /// A picture of the view, as PNG or whatever the name says; false when it cannot be written.
  bool save_picture(const QString& path);
  /// Films the view from now on, until stop_film() or the window's end; false where it cannot be
  /// written, which the status bar tells.
  bool start_film(const QString& path);
  void stop_film();
  /// Shows a map beside the world from now on; `board` is lent.
  MapView& show_map(const QString& title, const robios::MapBoard& board);
  [[nodiscard]] SceneView& scene() { return *scene_; }
  /// Asks whether the chosen robot shall be removed; yes removes it.
  void ask_to_remove();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  QDockWidget* add_dock(const QString& title, const char* name, Qt::DockWidgetArea area,
                        QWidget* widget);
  /// Both panels ask for places: one at a time.
  void stop_placing();
  QAction* add_action(QMenu& menu, const QString& text, const QKeySequence& key,
                      const std::function<void()>& act);
  QAction* add_switch(QMenu& menu, const QString& text, const QKeySequence& key, bool is_on,
                      const std::function<void(bool)>& act);
  void make_file_menu();
  void make_time_menu();
  void make_robot_menu();
  void make_removal(QMenu& menu);
  void show_robot_menu(QPoint place);
  void show_thing_menu(QPoint place, int number);
  void ask_for_change(int number);
  /// In the status bar and among the events.
  void tell(const QString& text);
  void tell(const Result<void>& done, const QString& what);
  void remove_robot(std::size_t index);
  void make_view_menu();
  void make_scene_menu(QMenu& menu);
  void make_docks();
  void make_adding();
  void make_status();
  void refresh();
  void add_to_film();
  void keep_layout();
  void show_time();
  void ask_for_picture();
  void ask_for_film();
  void ask_for_file();

  hal::Environment& environment_;
  robios::Crew* const crew_;
  const QString program_;
  WorldView* view_;
  Readings* readings_ = nullptr;
  EventLog* events_ = nullptr;
  SceneView* scene_ = nullptr;
  QDockWidget* scene_dock_ = nullptr;
  std::vector<MapView*> maps_;
  ErrorPanel* errors_ = nullptr;
  AddRobotPanel* adding_ = nullptr;
  AddThingPanel* things_ = nullptr;
  std::optional<Film> film_;
  QAction* film_switch_ = nullptr;
  QAction* drive_ = nullptr;
  QAction* remove_ = nullptr;
  QAction* centre_ = nullptr;
  QAction* measure_ = nullptr;
  QDockWidget* adding_dock_ = nullptr;
  QDockWidget* things_dock_ = nullptr;
  QAction* pause_ = nullptr;
  QAction* step_ = nullptr;
  QAction* follow_ = nullptr;
  QComboBox* factor_ = nullptr;
  QLabel* time_ = nullptr;
  QLabel* pointer_ = nullptr;
  QLabel* trouble_ = nullptr;
  QTimer timer_;
  int frames_ = 0;
};

}  // namespace eyebridge::gui
