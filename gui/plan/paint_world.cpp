#include "plan/paint_world.hpp"

#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace eyebridge::gui {
namespace {

const QColor kOutside(88, 92, 98);
const QColor kFloor(244, 244, 240);
const QColor kWallLine(40, 40, 44);

QPen thin(const QColor& colour) {
  QPen pen(colour);
  pen.setCosmetic(true);
  return pen;
}

/// In pixels, its x axis along the body's heading.
void enter(QPainter& painter, const Viewport& view, const Pose& pose) {
  painter.translate(view.to_pixel(pose.position()));
  painter.rotate(-rad_to_deg(pose.theta));
}

/// Beside the robot's disc: a bar of water, as deep as the robot dives, with its mark and the depth
/// in metres.
void paint_depth(QPainter& painter, const Viewport& view, const world::BodyView& body, double depth,
                 double deepest) {
  constexpr double kWidth = 8.0;         // pixels
  constexpr double kLeastLength = 40.0;  // pixels: it can be read
  const double radius = body.radius * view.pixels_per_metre();
  const double length = std::max(2 * radius, kLeastLength);
  const QPointF centre = view.to_pixel(body.pose.position());
  const QRectF bar(centre.x() + radius + kWidth, centre.y() - length / 2, kWidth, length);
  const double mark = bar.top() + (deepest > 0.0 ? std::min(depth / deepest, 1.0) : 0.0) * length;
  painter.setPen(thin(kWallLine));
  painter.setBrush(QColor(225, 240, 250));
  painter.drawRect(bar);
  painter.fillRect(QRectF(bar.topLeft(), QPointF(bar.right(), mark)), QColor(40, 120, 190));
  painter.drawLine(QPointF(bar.left() - kWidth / 2, mark), QPointF(bar.right() + kWidth / 2, mark));
  painter.drawText(QPointF(bar.right() + kWidth, mark + painter.fontMetrics().ascent() / 2.0),
                   QString("%1 m").arg(depth, 0, 'f', 2));
}

}  // namespace

QColor colour_of(Rgb colour) { return {colour.r, colour.g, colour.b}; }

void paint_marker(QPainter& painter, const Viewport& view, const world::Marker& marker) {
  constexpr double kRadius = 0.05;  // metres, about what EyeSim draws
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour_of(marker.colour));
  painter.drawEllipse(view.to_pixel(marker.position), kRadius * view.pixels_per_metre(),
                      kRadius * view.pixels_per_metre());
}

void paint_wall(QPainter& painter, const Viewport& view, const world::Wall& wall) {
  const double width = wall.thickness * view.pixels_per_metre();
  constexpr double kLeastWidth = 2.0;  // pixels: a bare line can be seen
  QPen pen(width > kLeastWidth ? colour_of(wall.colour).darker(150) : kWallLine,
           std::max(width, kLeastWidth));
  pen.setCapStyle(Qt::SquareCap);
  painter.setPen(pen);
  painter.drawLine(view.to_pixel(wall.a), view.to_pixel(wall.b));
}

void paint_thing(QPainter& painter, const Viewport& view, const world::BodyView& body) {
  const double scale = view.pixels_per_metre();
  painter.save();
  enter(painter, view, body.pose);
  painter.setPen(thin(kWallLine));
  painter.setBrush(colour_of(body.colour));
  if (body.corners) {
    QPolygonF outline;
    for (const Vec2 corner : *body.corners) outline << QPointF(scale * corner.x, -scale * corner.y);
    painter.drawPolygon(outline);
  } else {
    painter.drawEllipse(QPointF(0, 0), body.radius * scale, body.radius * scale);
  }
  painter.restore();
}

void paint_robot(QPainter& painter, const Viewport& view, const world::BodyView& body,
                 const QString& number, bool is_chosen, bool is_stalled) {
  const double radius = body.radius * view.pixels_per_metre();
  painter.save();
  enter(painter, view, body.pose);
  QPen rim(is_stalled  ? QColor(220, 0, 0)
           : is_chosen ? QColor(0, 90, 220)
                       : kWallLine,
           is_stalled || is_chosen ? 3.0 : 1.0);
  painter.setPen(rim);
  painter.setBrush(colour_of(body.colour));
  painter.drawEllipse(QPointF(0, 0), radius, radius);
  // The front: a wedge, as on the robots' lids.
  const QPolygonF front({QPointF(radius, 0), QPointF(0.45 * radius, 0.4 * radius),
                         QPointF(0.45 * radius, -0.4 * radius)});
  painter.setPen(Qt::NoPen);
  painter.setBrush(kWallLine);
  painter.drawPolygon(front);
  painter.restore();
  constexpr double kReadable = 8.0;  // pixels
  if (radius < kReadable) return;
  painter.setPen(kWallLine);
  const QPointF centre = view.to_pixel(body.pose.position());
  painter.drawText(QRectF(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius),
                   Qt::AlignCenter, number);
}

void paint_ground(QPainter& painter, const Viewport& view, const world::WorldModel& model,
                  const QImage& texture) {
  painter.fillRect(painter.viewport(), kOutside);
  const QRectF floor(view.to_pixel({model.corner.x, model.far_corner().y}),
                     view.to_pixel({model.far_corner().x, model.corner.y}));
  painter.fillRect(floor, kFloor);
  if (!texture.isNull()) painter.drawImage(floor, texture);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const world::Marker& marker : model.markers) paint_marker(painter, view, marker);
  for (const world::Wall& wall : model.walls) paint_wall(painter, view, wall);
}

void paint_bodies(QPainter& painter, const Viewport& view, const hal::WorldLook& look,
                  std::optional<std::size_t> chosen) {
  for (const world::BodyView& body : look.scene.bodies) {
    const auto robot = std::ranges::find(look.robots, body.id, &hal::RobotLook::body);
    if (robot == look.robots.end()) {
      paint_thing(painter, view, body);
      continue;
    }
    const auto index = static_cast<std::size_t>(robot - look.robots.begin());
    paint_robot(painter, view, body, QString::number(index + 1), chosen == index,
                robot->stalled != robot::kStallNone);
    if (robot->depth) {
      paint_depth(painter, view, body, *robot->depth, *robot->depth + robot->altitude);
    }
  }
}

void paint_rays(QPainter& painter, const Viewport& view, std::span<const SensorRay> rays,
                const QColor& colour) {
  std::vector<QLineF> lines;
  lines.reserve(rays.size());
  for (const SensorRay& ray : rays) {
    lines.emplace_back(view.to_pixel(ray.from), view.to_pixel(ray.to));
  }
  // Thousands in a frame: smooth lines would take a hundred times longer.
  const bool was_smooth = painter.testRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(thin(colour));
  painter.drawLines(lines.data(), static_cast<int>(lines.size()));
  painter.setRenderHint(QPainter::Antialiasing, was_smooth);
}

void paint_scan(QPainter& painter, const Viewport& view, std::span<const SensorRay> rays,
                const QColor& colour) {
  constexpr int kDot = 2;  // pixels; whole ones are filled several times faster
  std::vector<QRect> dots;
  dots.reserve(rays.size());
  for (const SensorRay& ray : rays) {
    const QPointF corner = view.to_pixel(ray.to) - QPointF(0.5 * kDot, 0.5 * kDot);
    dots.emplace_back(qRound(corner.x()), qRound(corner.y()), kDot, kDot);
  }
  const bool was_smooth = painter.testRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawRects(dots.data(), static_cast<int>(dots.size()));
  painter.setRenderHint(QPainter::Antialiasing, was_smooth);
}

void paint_camera_cone(QPainter& painter, const Viewport& view, const hal::RobotLook& robot,
                       double reach, bool is_chosen) {
  if (!robot.eye) return;
  const Vec2 place{robot.eye->x, robot.eye->y};
  const double half = robot.eye->horizontal_field_of_view / 2;
  QPainterPath cone(view.to_pixel(place));
  for (const double side : {half, -half}) {
    const double bearing = robot.eye->heading + side;
    cone.lineTo(view.to_pixel(place + reach * Heading::from_angle(bearing).forward()));
  }
  cone.closeSubpath();
  if (is_chosen) {
    painter.fillPath(cone, QColor(255, 200, 0, 60));
  } else {  // what shows through costs as much as all else
    painter.strokePath(cone, thin(QColor(220, 175, 0)));
  }
}

void paint_bumpers(QPainter& painter, const Viewport& view, const hal::RobotLook& robot,
                   const std::vector<bool>& touched) {
  constexpr double kWidth = 5.0;  // pixels
  const double radius = robot.model->radius() * view.pixels_per_metre() + kWidth / 2;
  const QPointF centre = view.to_pixel(robot.pose.position());
  const QRectF circle(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius);
  QPen pen(QColor(220, 0, 0), kWidth);
  pen.setCapStyle(Qt::FlatCap);
  painter.setPen(pen);
  const auto sixteenths = [](double angle) { return qRound(16 * rad_to_deg(angle)); };
  for (std::size_t i = 0; i < touched.size(); ++i) {
    if (!touched[i]) continue;
    const robot::BumperModel& bumper = robot.model->bumpers[i];
    double span = bumper.end - bumper.start;
    if (span <= 0) span += 2 * kPi;
    painter.drawArc(circle, sixteenths(robot.pose.theta + bumper.start), sixteenths(span));
  }
}

}  // namespace eyebridge::gui
