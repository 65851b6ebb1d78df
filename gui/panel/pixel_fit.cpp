#include "panel/pixel_fit.hpp"

#include <algorithm>
#include <cmath>

namespace eyebridge::gui {

PixelFit fit_pixels(const QWidget& widget, QSize picture, bool may_shrink) {
  const double ratio = widget.devicePixelRatioF();
  const double room = std::min(widget.width() * ratio / picture.width(),
                               widget.height() * ratio / picture.height());
  PixelFit fit;
  fit.times = std::max(1, static_cast<int>(std::floor(room)));
  if (may_shrink && room > 0.0 && room < 1.0) fit.divisor = static_cast<int>(std::ceil(1.0 / room));
  fit.unit = fit.times / (fit.divisor * ratio);
  const QSizeF size = QSizeF(picture) * fit.unit;
  // On whole pixels of the display.
  const auto corner = [&](double all, double own) {
    return std::floor(std::max(0.0, (all - own) / 2) * ratio) / ratio;
  };
  fit.place = {
      QPointF(corner(widget.width(), size.width()), corner(widget.height(), size.height())), size};
  return fit;
}

}  // namespace eyebridge::gui
