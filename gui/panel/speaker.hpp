#pragma once

#include <QElapsedTimer>
#include <QWidget>

#include "eyebridge/hal/device_notes.hpp"

namespace eyebridge::gui {

/// Lights while the robot's loudspeaker plays, and says what: the tone, or the file; the last one
/// stays to be read.
class Speaker final : public QWidget {
  Q_OBJECT

 public:
  /// `notes` is lent.
  Speaker(const hal::DeviceNotes& notes, QWidget* parent);

  /// Looks whether something plays now.
  void refresh();
  /// The program has ended, and its clock does not go on.
  void put_out();
  [[nodiscard]] bool is_lit() const { return is_lit_; }
  [[nodiscard]] const QString& text() const { return text_; }

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return {40, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void take(const hal::SoundNote& sound);

  const hal::DeviceNotes& notes_;
  std::uint64_t heard_ = 0;  ///< Sounds so far.
  Time end_{0};              ///< Of the last one, on the program's clock.
  QElapsedTimer since_;      ///< It began.
  bool is_lit_ = false;
  QString text_;
};

}  // namespace eyebridge::gui
