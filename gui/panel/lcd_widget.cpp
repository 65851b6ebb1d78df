#include "panel/lcd_widget.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

namespace eyebridge::gui {
namespace {

QImage image_of(const camera::Frame& frame) {
  const QImage lent(frame.bytes.data(), frame.width, frame.height, frame.stride,
                    QImage::Format_RGB888);
  return lent.copy();
}

}  // namespace

LcdWidget::LcdWidget(robios::Screen& screen, robios::Keys& keys, QWidget* parent)
    : QWidget(parent),
      screen_(screen),
      keys_(keys),
      revision_(screen.revision()),
      picture_(image_of(screen.snapshot())) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setCursor(Qt::PointingHandCursor);
  setToolTip(tr("The robot's screen: a click is a touch"));
}

bool LcdWidget::refresh() {
  // Before the picture: what changes in between is fetched the next time.
  const std::uint64_t revision = screen_.revision();
  if (revision == revision_) return false;
  revision_ = revision;
  picture_ = image_of(screen_.snapshot());
  update();
  return true;
}

int LcdWidget::scale() const {
  return std::max(1, std::min(width() / picture_.width(), height() / picture_.height()));
}

QPoint LcdWidget::corner() const {
  const QSize shown = scale() * picture_.size();
  return {std::max(0, (width() - shown.width()) / 2), std::max(0, (height() - shown.height()) / 2)};
}

QSize LcdWidget::sizeHint() const { return picture_.size(); }

void LcdWidget::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Dark));
  painter.drawImage(QRect(corner(), scale() * picture_.size()), picture_);
}

void LcdWidget::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const QPoint from_corner = event->position().toPoint() - corner();
  if (!QRect(QPoint(0, 0), scale() * picture_.size()).contains(from_corner)) return;
  keys_.touch(from_corner.x() / scale(), from_corner.y() / scale());
}

}  // namespace eyebridge::gui
