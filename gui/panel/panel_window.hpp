#pragma once

#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QWidget>
#include <array>

#include "panel/lcd_widget.hpp"
#include "soft_keys.hpp"
#include "windows/windows.hpp"

namespace eyebridge::gui {

/// A robot's panel: its screen and the four keys below, which the mouse, the keys 1 to 4 and F1 to
/// F4 press.
class PanelWindow final : public QWidget {
  Q_OBJECT
 public:
  explicit PanelWindow(const robios::PanelStart& start);
  ~PanelWindow() override;

  /// The program has ended, `how` in words: the screen stays, the keys are dead.
  void tell_end(const QString& how);
  [[nodiscard]] LcdWidget& lcd() { return *lcd_; }
  [[nodiscard]] QPushButton& key(int index) { return *keys_.at(static_cast<std::size_t>(index)); }

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void refresh();
  void press(int index);

  robios::Screen& screen_;
  robios::Keys& presses_;
  LcdWidget* lcd_;
  std::array<QPushButton*, robios::kSoftKeys> keys_{};
  bool are_labelled_ = false;
  QLabel* end_;
  QTimer timer_;
};

}  // namespace eyebridge::gui
