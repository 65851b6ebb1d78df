#pragma once

#include <QLabel>
#include <QMainWindow>
#include <QTimer>

#include "hand/direction_sign.hpp"
#include "hand/marker_view.hpp"
#include "windows/windows.hpp"

class QDockWidget;

namespace eyebridge::gui {

/// For the person who carries a robot's camera: which way, how far and how fast the program wants
/// to go; what the camera sees, with the markers that were found; where that is, and how surely.
class HandWindow final : public QMainWindow {
  Q_OBJECT

 public:
  explicit HandWindow(const robios::HandStart& start);
  ~HandWindow() override;

  /// The program has ended, `how` in words.
  void tell_end(const QString& how);
  /// A picture of the window, as PNG or whatever the name says; false when it cannot be written.
  bool save_window(const QString& path);

  [[nodiscard]] DirectionSign& sign() { return *sign_; }
  [[nodiscard]] MarkerView& camera() { return *camera_; }
  /// Below: the pose and its uncertainty, or why there is none.
  [[nodiscard]] QString place_text() const { return place_->text(); }

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void keep_layout();
  void make_menus(QDockWidget& camera);
  void refresh();
  void show_place(const hal::HandLook& look);

  const hal::HandGuide& guide_;
  const camera::LatestFrame* const frames_;
  DirectionSign* sign_;
  MarkerView* camera_;
  QLabel* place_;
  QTimer timer_;
};

}  // namespace eyebridge::gui
