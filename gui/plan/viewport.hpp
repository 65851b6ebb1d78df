#pragma once

#include <QPointF>
#include <QSizeF>

#include "eyebridge/base/pose.hpp"

class QWheelEvent;

namespace eyebridge::gui {

/// Which part of the world a view shows: the world's y points up, the view's down.
class Viewport {
 public:
  static constexpr double kFarthest = 1.0;     ///< Least pixels a metre.
  static constexpr double kNearest = 20000.0;  ///< Most.
  static constexpr double kZoomStep = 1.25;    ///< Of a key or a notch of the wheel.

  /// Pixels of the view. Its middle stays where it is in the world.
  void resize(QSizeF size) { size_ = size; }
  /// Shows the world from one corner to another, metres, with a margin.
  void fit(Vec2 near, Vec2 far);
  void centre_on(Vec2 place) { centre_ = place; }
  /// What lies under `pixel` stays there.
  void zoom_at(QPointF pixel, double factor);
  /// Moves the picture with the mouse.
  void pan(QPointF pixels);

  [[nodiscard]] QPointF to_pixel(Vec2 place) const;
  [[nodiscard]] Vec2 to_world(QPointF pixel) const;
  [[nodiscard]] double pixels_per_metre() const { return scale_; }

  friend bool operator==(const Viewport&, const Viewport&) = default;

 private:
  QSizeF size_{1, 1};
  Vec2 centre_;
  double scale_ = 100.0;
};

/// How far the wheel was turned, forwards > 0.
double notches_of(const QWheelEvent& event);
/// By how much that enlarges what a Viewport shows.
double zoom_of(const QWheelEvent& event);

}  // namespace eyebridge::gui
