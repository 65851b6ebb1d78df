#pragma once

#include <QPointer>
#include <QString>
#include <QWidget>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "windows/windows.hpp"

namespace eyebridge::gui {

class EnvironmentWindow;
class HandWindow;
class PanelWindow;

/// The windows of a process and their thread. Robot programs have the process's main thread (it is
/// their main() or their interpreter), so that Qt's main thread is another one: on Linux it can be
/// any, if it is always the same.
class GuiWindows final : public robios::Windows {
 public:
  explicit GuiWindows(robios::WindowsStart start);
  ~GuiWindows() override;

  void open_panel(const robios::PanelStart& start) override;
  void close_panel(const robios::Screen& screen) override;
  void open_hand_view(const robios::HandStart& start) override;
  void open_environment(hal::Environment& environment, robios::Crew* crew) override;
  void open_map(const robios::MapStart& start) override;
  void edit(const std::string& path) override;
  void complete_files() override;
  void finish(const std::string& how) override;

  /// Qt is about to end the process, as its display is gone: ends the run politely first. Returns
  /// at once in other threads than the windows', where it never returns.
  void display_went_away();
  /// For tests: runs `action` in the windows' thread and waits for it.
  void in_thread(const std::function<void()>& action);

 private:
  void run();
  void run_application();
  /// Returns when the windows' thread is gone.
  void join();
  void show(QWidget& window);
  void open_editor(const QString& file);
  /// Whether `file` is what `window` edits; a tab with it comes to the front there.
  static bool is_open_in(QWidget& window, const QString& file);
  static void bring_to_front(QWidget& window);
  void last_window_closed();
  /// Completes and keeps what persons made: films, edits that are not saved. The windows' thread.
  void keep_all();
  /// False when the windows have ended: it will not be done.
  bool post(std::function<void()> action);

  const robios::WindowsStart start_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_ready_ = false;   ///< The event loop can be posted to.
  bool has_ended_ = false;  ///< It has ended: windows are gone.
  // The rest: the windows' thread.
  bool program_has_ended_ = false;
  bool is_removing_ = false;  ///< A panel goes that nobody closed.
  std::vector<std::unique_ptr<PanelWindow>> panels_;
  std::vector<std::unique_ptr<HandWindow>> hand_views_;
  std::vector<std::unique_ptr<EnvironmentWindow>> environments_;
  const hal::HandGuide* guide_ = nullptr;  ///< Of the robot that a person carries, if one is.
  std::vector<QPointer<QWidget>>
      editors_;         ///< They go when they are closed, and so do their locks.
  std::thread thread_;  ///< Last: it uses the others.
};

}  // namespace eyebridge::gui
