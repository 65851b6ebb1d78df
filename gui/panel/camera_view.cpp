#include "panel/camera_view.hpp"

#include <QPainter>
#include <algorithm>

#include "panel/pixel_fit.hpp"
#include "widgets/frame_image.hpp"

namespace eyebridge::gui {

CameraView::CameraView(const camera::LatestFrame& frames, QWidget* parent)
    : QWidget(parent), frames_(frames) {
  setAccessibleName(tr("Camera"));
  setToolTip(tr("The picture that the program got last from its camera"));
  refresh();
}

void CameraView::refresh() {
  camera::FramePtr frame = frames_.get();
  if (frame == frame_) return;
  frame_ = std::move(frame);
  picture_ = image_of(*frame_);
  setAccessibleDescription(caption());
  update();
}

QString CameraView::caption() const {
  if (picture_.isNull()) return tr("The program has taken no picture yet (CAMInit, CAMGet)");
  const PixelFit fit = fit_pixels(*this, picture_.size(), true);
  const QString scale =
      fit.divisor > 1 ? QString("1/%1").arg(fit.divisor) : QString::number(fit.times);
  return tr("%1 × %2, at %3 s, shown × %4")
      .arg(picture_.width())
      .arg(picture_.height())
      .arg(to_seconds(frame_->time), 0, 'f', 2)
      .arg(scale);
}

void CameraView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Window));
  painter.setPen(palette().color(QPalette::WindowText));
  if (picture_.isNull()) {
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap, caption());
    return;
  }
  const PixelFit fit = fit_pixels(*this, picture_.size(), true);
  painter.setRenderHint(QPainter::SmoothPixmapTransform, fit.divisor > 1);
  painter.drawImage(fit.place, picture_);
  // Below the picture if there is room, else on it.
  const int line = fontMetrics().height() + 4;
  QRect strip(0, std::min(static_cast<int>(fit.place.bottom()), height() - line), width(), line);
  QColor veil = palette().color(QPalette::Window);
  veil.setAlpha(200);
  painter.fillRect(strip, veil);
  painter.drawText(strip, Qt::AlignCenter,
                   fontMetrics().elidedText(caption(), Qt::ElideRight, width()));
}

}  // namespace eyebridge::gui
