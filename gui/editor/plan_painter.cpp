#include "editor/plan_painter.hpp"

#include <QPainter>
#include <string>
#include <vector>

#include "editor/edits.hpp"
#include "eyebridge/robot/body_colours.hpp"
#include "plan/paint_world.hpp"

namespace eyebridge::gui {
namespace {

constexpr double kHandle = 4.0;      // pixels: half of a square handle
constexpr double kFinestGrid = 8.0;  // pixels between lines

// The floor is light in every palette, so these are fixed.
const QColor kGridLine(0, 0, 0, 28);
const QColor kWayLine(0, 110, 160);
const QColor kStartFill(0, 140, 70, 70);
const QColor kStartLine(0, 110, 50);

void paint_grid(QPainter& painter, const Viewport& view, const Plan& plan, double step) {
  if (step <= 0) return;
  while (step * view.pixels_per_metre() < kFinestGrid) step *= 10;
  painter.setPen(QPen(kGridLine, 1.0));
  for (int i = 1; i * step < plan.width; ++i) {
    painter.drawLine(view.to_pixel({i * step, 0}), view.to_pixel({i * step, plan.height}));
  }
  for (int i = 1; i * step < plan.height; ++i) {
    painter.drawLine(view.to_pixel({0, i * step}), view.to_pixel({plan.width, i * step}));
  }
}

void paint_way(QPainter& painter, const Viewport& view, const Plan& plan, const Item& item) {
  const world::Path* const way = way_of(plan, item);
  const auto pose = pose_of(plan, item);
  if (way == nullptr || !pose) return;
  painter.setPen(QPen(kWayLine, 2.0, Qt::DashLine));
  QPointF last = view.to_pixel(pose->position());
  for (const Vec2 point : way->points) {
    painter.drawLine(last, view.to_pixel(point));
    last = view.to_pixel(point);
  }
  if (way->loop) painter.drawLine(last, view.to_pixel(pose->position()));
  painter.setPen(Qt::NoPen);
  painter.setBrush(kWayLine);
  for (const Vec2 point : way->points) painter.drawEllipse(view.to_pixel(point), 3.5, 3.5);
}

void paint_start(QPainter& painter, const Viewport& view, const world::StartPose& start) {
  const double radius = kStartRadius * view.pixels_per_metre();
  painter.save();
  painter.translate(view.to_pixel(start.pose.position()));
  painter.setPen(QPen(kStartLine, 1.5));
  painter.setBrush(kStartFill);
  painter.drawEllipse(QPointF(0, 0), radius, radius);
  painter.save();
  painter.rotate(-rad_to_deg(start.pose.theta));
  painter.drawLine(QPointF(-0.6 * radius, 0), QPointF(0.9 * radius, 0));
  painter.drawLine(QPointF(0.9 * radius, 0), QPointF(0.4 * radius, 0.4 * radius));
  painter.drawLine(QPointF(0.9 * radius, 0), QPointF(0.4 * radius, -0.4 * radius));
  painter.restore();
  if (start.letter != 0) {
    painter.drawText(QPointF(radius + 2, -radius), QString(QChar(start.letter)));
  }
  painter.restore();
}

void paint_robots(QPainter& painter, const Viewport& view, const Plan& plan,
                  const Catalogue& catalogue) {
  const std::vector<int> numbers = run_numbers(
      plan.robots, [&](const std::string& model) { return catalogue.find(model).is_object; });
  for (std::size_t i = 0; i < plan.robots.size(); ++i) {
    const auto pose = pose_of_robot(plan, i);
    if (!pose) continue;
    const Catalogue::Entry entry = catalogue.find(plan.robots[i].model);
    if (entry.is_object) {
      world::BodyView body = world::view_of(entry.object, 0);
      body.pose = *pose;
      paint_thing(painter, view, body);
      continue;
    }
    world::BodyView body;
    body.pose = *pose;
    body.radius = entry.radius;
    body.colour = entry.is_known ? robot::body_colour(static_cast<std::size_t>(numbers[i] - 1))
                                 : Rgb{200, 200, 200};
    paint_robot(painter, view, body, QString::number(numbers[i]), false, false);
  }
}

void paint_handle(QPainter& painter, QPointF at) {
  painter.drawRect(QRectF(at.x() - kHandle, at.y() - kHandle, 2 * kHandle, 2 * kHandle));
}

}  // namespace

void paint_plan_ground(QPainter& painter, const Viewport& view, const Plan& plan,
                       const QImage& texture, double grid) {
  world::WorldModel ground = ground_of(plan, true);
  ground.walls.clear();
  paint_ground(painter, view, ground, texture);
  paint_grid(painter, view, plan, grid);
  // The walls over the grid, the markers with them.
  for (const world::Wall& wall : plan.walls) paint_wall(painter, view, wall);
}

void paint_plan_items(QPainter& painter, const Viewport& view, const Plan& plan,
                      const Catalogue& catalogue) {
  for (const world::Marker& marker : plan.markers) paint_marker(painter, view, marker);
  for (const world::StartPose& start : plan.starts) paint_start(painter, view, start);
  for (std::size_t i = 0; i < plan.things.size(); ++i)
    paint_way(painter, view, plan, {Kind::Thing, i});
  for (std::size_t i = 0; i < plan.robots.size(); ++i)
    paint_way(painter, view, plan, {Kind::Robot, i});
  for (const Thing& thing : plan.things) {
    paint_thing(painter, view, world::view_of(thing.spec, 0));
  }
  paint_robots(painter, view, plan, catalogue);
}

void paint_selection(QPainter& painter, const Viewport& view, const Plan& plan,
                     const Catalogue& catalogue, const Selection& selection, const QColor& colour) {
  for (const Item& item : selection) {
    if (!has(plan, item)) continue;
    if (item.kind == Kind::Wall) {
      const world::Wall& wall = plan.walls[item.index];
      painter.setPen(QPen(colour, 4.0));
      painter.drawLine(view.to_pixel(wall.a), view.to_pixel(wall.b));
      painter.setPen(QPen(colour, 1.5));
      painter.setBrush(Qt::white);
      for (const Vec2 end : {wall.a, wall.b}) paint_handle(painter, view.to_pixel(end));
      continue;
    }
    const auto pose = pose_of(plan, item);
    if (!pose) continue;
    const double radius = radius_of(plan, catalogue, item) * view.pixels_per_metre() + kHandle;
    painter.setPen(QPen(colour, 2.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(view.to_pixel(pose->position()), radius, radius);
  }
}

void paint_way_points(QPainter& painter, const Viewport& view, const Plan& plan, const Item& item,
                      const std::optional<WayPoint>& picked, const QColor& colour) {
  const world::Path* const way = way_of(plan, item);
  if (way == nullptr) return;
  painter.setPen(QPen(colour, 1.5));
  for (std::size_t i = 0; i < way->points.size(); ++i) {
    painter.setBrush(picked == WayPoint{item, i} ? colour : QColor(Qt::white));
    paint_handle(painter, view.to_pixel(way->points[i]));
  }
}

}  // namespace eyebridge::gui
