#pragma once

#include <QLabel>
#include <QMainWindow>
#include <QTimer>
#include <functional>

#include "environment/event_log.hpp"
#include "environment/readings.hpp"
#include "environment/world_view.hpp"

class QAction;
class QComboBox;

namespace eyebridge::gui {

/// The driving environment: the world from above, its time, and what goes on in it.
class EnvironmentWindow final : public QMainWindow {
 public:
  /// `environment` is lent.
  EnvironmentWindow(hal::Environment& environment, const QString& program);
  ~EnvironmentWindow() override;

  [[nodiscard]] hal::Environment& environment() { return environment_; }
  [[nodiscard]] WorldView& view() { return *view_; }
  /// The program has ended, `how` in words: the world stays as long as the window.
  void tell_end(const QString& how);
  /// A picture of the view, as PNG or whatever the name says; false when it cannot be written.
  bool save_picture(const QString& path);

 private:
  QAction* add_action(QMenu& menu, const QString& text, const QKeySequence& key,
                      const std::function<void()>& act);
  QAction* add_switch(QMenu& menu, const QString& text, const QKeySequence& key, bool is_on,
                      const std::function<void(bool)>& act);
  void make_file_menu();
  void make_time_menu();
  void make_view_menu();
  void make_docks();
  void make_status();
  void refresh();
  void show_time();
  void ask_for_picture();

  hal::Environment& environment_;
  WorldView* view_;
  Readings* readings_ = nullptr;
  EventLog* events_ = nullptr;
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
