#include "plan/viewport.hpp"

#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace eyebridge::gui {

void Viewport::fit(Vec2 near, Vec2 far) {
  const Vec2 extent = far - near;
  constexpr double kMargin = 1.05;
  constexpr double kLeast = 0.1;  // metres: of a world that is a point
  centre_ = near + 0.5 * extent;
  scale_ = std::clamp(std::min(size_.width() / (kMargin * std::max(extent.x, kLeast)),
                               size_.height() / (kMargin * std::max(extent.y, kLeast))),
                      kFarthest, kNearest);
}

void Viewport::zoom_at(QPointF pixel, double factor) {
  const Vec2 fixed = to_world(pixel);
  scale_ = std::clamp(scale_ * factor, kFarthest, kNearest);
  centre_ = centre_ + (fixed - to_world(pixel));
}

void Viewport::pan(QPointF pixels) {
  centre_ = centre_ + Vec2{-pixels.x() / scale_, pixels.y() / scale_};
}

QPointF Viewport::to_pixel(Vec2 place) const {
  return {size_.width() / 2 + (place.x - centre_.x) * scale_,
          size_.height() / 2 - (place.y - centre_.y) * scale_};
}

Vec2 Viewport::to_world(QPointF pixel) const {
  return {centre_.x + (pixel.x() - size_.width() / 2) / scale_,
          centre_.y - (pixel.y() - size_.height() / 2) / scale_};
}

double notches_of(const QWheelEvent& event) {
  constexpr double kNotch = 120.0;  // as Qt counts
  return event.angleDelta().y() / kNotch;
}

double zoom_of(const QWheelEvent& event) {
  return std::pow(Viewport::kZoomStep, notches_of(event));
}

}  // namespace eyebridge::gui
