#pragma once

#include <QImage>
#include <QWidget>
#include <memory>

#include "plan/viewport.hpp"
#include "windows/map_board.hpp"

namespace eyebridge::gui {

/// A map that a program has: what it believes, or what is there. White is free, black occupied,
/// grey unknown. The wheel zooms to the pointer, a drag moves it, a double click shows all.
class MapView final : public QWidget {
  Q_OBJECT
 public:
  /// `board` is lent.
  MapView(const robios::MapBoard& board, QWidget* parent);

  /// Draws anew, if the board has something new.
  void refresh();
  /// All of the map.
  void fit();
  [[nodiscard]] const Viewport& viewport() const { return viewport_; }

  [[nodiscard]] QSize sizeHint() const override { return {320, 320}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  const robios::MapBoard& board_;
  std::shared_ptr<const robios::MapLook> look_;
  QImage picture_;  ///< Upper left cell first.
  Viewport viewport_;
  bool is_placed_ = false;  ///< A person has moved it: it does not fit itself any more.
  QPointF last_;            ///< Of the mouse.
};

}  // namespace eyebridge::gui
