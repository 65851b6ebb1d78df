#pragma once

#include <QRectF>
#include <QWidget>

namespace eyebridge::gui {

/// A picture in the middle of a widget, each of its pixels as many of the display's: nothing is
/// blurred, whatever the display's scaling.
struct PixelFit {
  int times = 1;    ///< Pixels of the display along an edge of one of the picture, at least 1 …
  int divisor = 1;  ///< … or how many of the picture one of the display has, if it must shrink.
  QRectF place;     ///< In the widget.
  double unit = 1;  ///< Of the widget's units for a pixel of the picture.
};

/// The largest fit; smaller than 1 : 1 only where `may_shrink`. `picture` is not empty.
PixelFit fit_pixels(const QWidget& widget, QSize picture, bool may_shrink);

}  // namespace eyebridge::gui
