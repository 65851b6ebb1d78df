#pragma once

#include <QPixmap>
#include <cstdint>
#include <vector>

#include "environment/trails.hpp"
#include "plan/viewport.hpp"

namespace eyebridge::gui {

/// The robots' trails on the ground, kept from frame to frame: only what is new is painted, as a
/// hundred robots' trails of some minutes would take a frame's time many times over. One thread.
class TrailLayer {
 public:
  /// `ground`, which is another pixmap whenever `view` is another, with the trails of the robots of
  /// `look`. Points that a trail has lost are seen a little longer. Valid until the next call.
  const QPixmap& paint(const QPixmap& ground, const Viewport& view, const Trails& trails,
                       const hal::WorldLook& look);

 private:
  /// How much of a robot's trail is in the picture.
  struct Done {
    std::uint64_t points = 0;  ///< With those that are gone.
    QPointF last;              ///< Where the line has come to, pixels.
  };

  [[nodiscard]] bool is_stale(const QPixmap& ground, const Trails& trails) const;
  static void paint_new(QPainter& painter, const Viewport& view, const Trails::Trail& trail,
                        const QColor& colour, Done& done);

  QPixmap picture_;
  qint64 ground_ = 0;  ///< Its key.
  std::uint64_t version_ = 0;
  std::vector<std::uint64_t> gone_;  ///< Of the trails, when the picture was begun.
  std::vector<Done> done_;
};

}  // namespace eyebridge::gui
