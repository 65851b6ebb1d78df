#pragma once

#include <QImage>
#include <QWidget>
#include <vector>

#include "eyebridge/camera/latest_frame.hpp"
#include "eyebridge/hal/hand_guide.hpp"

namespace eyebridge::gui {

/// What the camera in a person's hand sees, with a frame round each marker and its number.
class MarkerView final : public QWidget {
  Q_OBJECT

 public:
  explicit MarkerView(QWidget* parent);

  /// `frame` may be null: then there is none yet.
  void show_frame(const camera::FramePtr& frame, const std::vector<hal::SeenMarker>& markers);
  void set_marked(bool marked);
  [[nodiscard]] const QImage& picture() const { return picture_; }
  [[nodiscard]] const std::vector<hal::SeenMarker>& markers() const { return markers_; }
  /// Where a pixel of the picture is in the widget.
  [[nodiscard]] QPointF place_of(Vec2 pixel) const;

  [[nodiscard]] QSize sizeHint() const override { return {480, 360}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {160, 120}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QRectF place() const;
  void paint_markers(QPainter& painter) const;

  camera::FramePtr frame_;
  QImage picture_;
  std::vector<hal::SeenMarker> markers_;
  bool is_marked_ = true;
};

}  // namespace eyebridge::gui
