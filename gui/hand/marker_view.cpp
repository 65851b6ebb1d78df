#include "hand/marker_view.hpp"

#include <QPainter>
#include <QPolygonF>

#include "widgets/frame_image.hpp"

namespace eyebridge::gui {

MarkerView::MarkerView(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Camera"));
  setToolTip(tr("What the camera in your hand sees"));
}

void MarkerView::show_frame(const camera::FramePtr& frame,
                            const std::vector<hal::SeenMarker>& markers) {
  if (frame == frame_) return;
  frame_ = frame;
  picture_ = frame ? image_of(*frame) : QImage();
  markers_ = markers;
  setAccessibleDescription(tr("%n marker(s)", nullptr, static_cast<int>(markers.size())));
  update();
}

void MarkerView::set_marked(bool marked) {
  is_marked_ = marked;
  update();
}

QRectF MarkerView::place() const {
  const QSizeF size = QSizeF(picture_.size()).scaled(QSizeF(this->size()), Qt::KeepAspectRatio);
  return {QPointF((width() - size.width()) / 2, (height() - size.height()) / 2), size};
}

QPointF MarkerView::place_of(Vec2 pixel) const {
  const QRectF shown = place();
  const double scale = shown.width() / picture_.width();
  // (0, 0) is the middle of the first pixel.
  return shown.topLeft() + scale * QPointF(pixel.x + 0.5, pixel.y + 0.5);
}

void MarkerView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Window));
  if (picture_.isNull()) {
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("No picture yet"));
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(place(), picture_);
  if (is_marked_) paint_markers(painter);
}

void MarkerView::paint_markers(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor colour(230, 0, 180);  // no wall is of it
  QFont number = font();
  number.setBold(true);
  painter.setFont(number);
  for (const hal::SeenMarker& marker : markers_) {
    QPolygonF outline;
    for (const Vec2 corner : marker.corners) outline << place_of(corner);
    painter.setPen(QPen(colour, 3.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(outline);
    const QString text = QString::number(marker.id);
    QRectF label = QRectF(painter.fontMetrics().boundingRect(text)).adjusted(-4, -2, 4, 2);
    label.moveCenter(outline.boundingRect().center());
    painter.fillRect(label, colour);
    painter.setPen(Qt::white);
    painter.drawText(label, Qt::AlignCenter, text);
  }
}

}  // namespace eyebridge::gui
