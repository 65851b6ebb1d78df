#include "environment/trail_layer.hpp"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "plan/paint_world.hpp"

namespace eyebridge::gui {
namespace {

constexpr double kLineWidth = 2.0;  // pixels
constexpr double kLeastWay = 1.0;   // pixels: nearer points are not seen
// Points that a trail may have lost before they vanish: then all is painted anew.
constexpr std::uint64_t kMostLost = 250;

}  // namespace

bool TrailLayer::is_stale(const QPixmap& ground, const Trails& trails) const {
  if (picture_.isNull() || ground_ != ground.cacheKey() || version_ != trails.version())
    return true;
  for (std::size_t i = 0; i < gone_.size(); ++i) {
    if (trails.of(i).gone > gone_[i] + kMostLost) return true;
  }
  return false;
}

const QPixmap& TrailLayer::paint(const QPixmap& ground, const Viewport& view, const Trails& trails,
                                 const hal::WorldLook& look) {
  if (is_stale(ground, trails)) {
    picture_ = ground;
    ground_ = ground.cacheKey();
    version_ = trails.version();
    done_.clear();
    gone_.clear();
  }
  for (std::size_t i = gone_.size(); i < look.robots.size(); ++i) {
    gone_.push_back(trails.of(i).gone);
  }
  done_.resize(std::max(done_.size(), look.robots.size()));
  QPainter painter;
  for (std::size_t i = 0; i < look.robots.size(); ++i) {
    const Trails::Trail& trail = trails.of(i);
    if (done_[i].points == trail.gone + trail.points.size()) continue;
    const auto body =
        std::ranges::find(look.scene.bodies, look.robots[i].body, &world::BodyView::id);
    if (body == look.scene.bodies.end()) continue;
    if (!painter.isActive()) {
      painter.begin(&picture_);
      painter.setRenderHint(QPainter::Antialiasing);
    }
    paint_new(painter, view, trail, colour_of(body->colour).darker(120), done_[i]);
  }
  return picture_;
}

void TrailLayer::paint_new(QPainter& painter, const Viewport& view, const Trails::Trail& trail,
                           const QColor& colour, Done& done) {
  QPainterPath path(done.last);
  bool any = false;
  const std::uint64_t first = std::max(done.points, trail.gone) - trail.gone;
  for (auto i = static_cast<std::size_t>(first); i < trail.points.size(); ++i) {
    const Trails::Point& point = trail.points[i];
    const QPointF pixel = view.to_pixel(point.place);
    // The oldest one that is left has lost what it was joined to.
    if (point.begins || (i == 0 && done.points <= trail.gone)) {
      path.moveTo(pixel);
    } else {
      const QPointF way = pixel - done.last;
      if (QPointF::dotProduct(way, way) < kLeastWay * kLeastWay) continue;
      path.lineTo(pixel);
      any = true;
    }
    done.last = pixel;
  }
  done.points = trail.gone + trail.points.size();
  if (any) painter.strokePath(path, QPen(colour, kLineWidth));
}

}  // namespace eyebridge::gui
