#pragma once

#include <QImage>
#include <QWidget>
#include <cstdint>

#include "keys.hpp"
#include "screen.hpp"

namespace eyebridge::gui {

/// A robot's screen, pixel for pixel, at the largest whole scale that fits; by a whole fraction on
/// displays that are too small for that. A click is a touch.
class LcdWidget final : public QWidget {
  Q_OBJECT

 public:
  /// Both are lent.
  LcdWidget(robios::Screen& screen, robios::Keys& keys, QWidget* parent);

  /// Takes the picture anew if it has changed; true then.
  bool refresh();
  /// Pixels of the display for one of the screen.
  [[nodiscard]] int scale() const;
  [[nodiscard]] const QImage& picture() const { return picture_; }

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  robios::Screen& screen_;
  robios::Keys& keys_;
  std::uint64_t revision_;
  QImage picture_;
};

}  // namespace eyebridge::gui
