#include "panel/lcd_widget.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <QScreen>
#include <cmath>

#include "panel/pixel_fit.hpp"
#include "widgets/frame_image.hpp"

namespace eyebridge::gui {
namespace {

constexpr int kAround = 120;  // pixels: menus, keys, margins and a window's frame

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
  setAccessibleName(tr("The robot's screen"));
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

int LcdWidget::scale() const { return fit_pixels(*this, picture_.size(), true).times; }

QSize LcdWidget::sizeHint() const { return picture_.size(); }

QSize LcdWidget::minimumSizeHint() const {
  // Never less than pixel for pixel, but where the display is too small for that and the keys.
  const QSize room = screen()->availableSize() - QSize(kAround, kAround);
  QSize least = picture_.size();
  while (least.width() > room.width() || least.height() > room.height()) least /= 2;
  return least;
}

void LcdWidget::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Dark));
  painter.drawImage(fit_pixels(*this, picture_.size(), true).place, picture_);
}

void LcdWidget::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const PixelFit fit = fit_pixels(*this, picture_.size(), true);
  const QPointF place = (event->position() - fit.place.topLeft()) / fit.unit;
  const QPoint pixel(static_cast<int>(std::floor(place.x())),
                     static_cast<int>(std::floor(place.y())));
  if (picture_.rect().contains(pixel)) keys_.touch(pixel.x(), pixel.y());
}

}  // namespace eyebridge::gui
