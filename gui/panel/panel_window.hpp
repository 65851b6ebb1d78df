#pragma once

#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <QTimer>
#include <array>

#include "panel/camera_view.hpp"
#include "panel/inspector.hpp"
#include "panel/lcd_widget.hpp"
#include "panel/remote_control.hpp"
#include "panel/speaker.hpp"
#include "soft_keys.hpp"
#include "windows/windows.hpp"

class QDockWidget;
class QMenu;

namespace eyebridge::gui {

/// A robot's panel: its screen and the four keys below, which the mouse, the keys 1 to 4 and F1 to
/// F4 press; beside them, in docks, what its camera gave last, its sensors and actuators, and its
/// remote control.
class PanelWindow final : public QMainWindow {
  Q_OBJECT

 public:
  explicit PanelWindow(const robios::PanelStart& start);
  ~PanelWindow() override;

  [[nodiscard]] bool shows(const robios::Screen& screen) const { return &screen_ == &screen; }
  /// The program has ended, `how` in words: the screen stays, the keys are dead.
  void tell_end(const QString& how);
  /// Writes the screen, pixel for pixel, as PNG or whatever the name says, and says so in the
  /// window; false when it cannot be written.
  bool save_screen(const QString& path);

  [[nodiscard]] LcdWidget& lcd() { return *lcd_; }
  [[nodiscard]] QPushButton& key(int index) { return *keys_.at(static_cast<std::size_t>(index)); }
  [[nodiscard]] RemoteControl& remote() { return *remote_; }
  // Null where the start names no such source.
  [[nodiscard]] CameraView* camera() { return camera_; }
  [[nodiscard]] Inspector* inspector() { return inspector_; }
  [[nodiscard]] Speaker* speaker() { return speaker_; }

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void keep_layout();
  void leave_room_for_the_screen();
  void make_screen();
  void make_docks(const robios::PanelStart& start);
  void make_menus();
  void make_file_menu(QMenu& menu);
  void make_keys_menu(QMenu& menu);
  void make_remote_menu(QMenu& menu);
  QDockWidget* add_dock(const QString& title, const char* name, const QKeySequence& key,
                        QWidget* widget);
  void refresh();
  void refresh_docks();
  void press(int index);
  bool press_by_keyboard(const QKeyEvent& event);
  void ask_for_picture();
  void tell(const QString& text);

  robios::Screen& screen_;
  robios::Keys& presses_;
  LcdWidget* lcd_ = nullptr;
  std::array<QPushButton*, robios::kSoftKeys> keys_{};
  bool are_labelled_ = false;
  CameraView* camera_ = nullptr;
  Inspector* inspector_ = nullptr;
  RemoteControl* remote_ = nullptr;
  Speaker* speaker_ = nullptr;
  QLabel* told_ = nullptr;
  QTimer timer_;
  int frames_ = 0;
};

}  // namespace eyebridge::gui
