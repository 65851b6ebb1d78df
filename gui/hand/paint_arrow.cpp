#include <QPainter>
#include <QPainterPath>

#include "hand/direction_sign.hpp"

namespace eyebridge::gui {
namespace {

/// At `tip`, pointing up when `degrees` is 0, clockwise from there.
void paint_head(QPainter& painter, QPointF tip, double degrees) {
  painter.save();
  painter.translate(tip);
  painter.rotate(degrees);
  painter.setPen(Qt::NoPen);
  painter.drawPolygon(QPolygonF({{0.0, 0.0}, {0.42, 0.55}, {-0.42, 0.55}}));
  painter.restore();
}

void paint_line(QPainter& painter, const QPainterPath& path) {
  painter.save();
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(path);
  painter.restore();
}

void paint_straight(QPainter& painter) {
  QPainterPath line(QPointF(0.0, 0.95));
  line.lineTo(0.0, -0.45);
  paint_line(painter, line);
  paint_head(painter, {0.0, -0.95}, 0.0);
}

/// Counter-clockwise on the spot: up the right side and over to the left.
void paint_turn(QPainter& painter) {
  QPainterPath line;
  const QRectF circle(-0.65, -0.65, 1.3, 1.3);
  line.arcMoveTo(circle, -90);
  line.arcTo(circle, -90, 278);
  paint_line(painter, line);
  paint_head(painter, {-0.72, 0.62}, 185.0);
}

void paint_curve(QPainter& painter) {
  QPainterPath line(QPointF(0.5, 0.95));
  line.cubicTo(0.5, 0.1, 0.3, -0.35, -0.4, -0.45);
  paint_line(painter, line);
  paint_head(painter, {-0.9, -0.5}, -82.0);
}

}  // namespace

void paint_arrow(QPainter& painter, camera::Arrow arrow) {
  painter.save();
  switch (arrow) {
    case camera::Arrow::None:
      painter.setPen(Qt::NoPen);
      painter.drawRect(QRectF(-0.7, -0.7, 1.4, 1.4));
      break;
    case camera::Arrow::Backward:
      painter.scale(1, -1);
      [[fallthrough]];
    case camera::Arrow::Forward:
      paint_straight(painter);
      break;
    case camera::Arrow::TurnRight:
      painter.scale(-1, 1);
      [[fallthrough]];
    case camera::Arrow::TurnLeft:
      paint_turn(painter);
      break;
    case camera::Arrow::CurveRight:
      painter.scale(-1, 1);
      [[fallthrough]];
    case camera::Arrow::CurveLeft:
      paint_curve(painter);
      break;
    case camera::Arrow::BackLeft:
      painter.scale(1, -1);
      paint_curve(painter);
      break;
    case camera::Arrow::BackRight:
      painter.scale(-1, -1);
      paint_curve(painter);
      break;
    case camera::Arrow::Lost: {
      QPainterPath mark;
      QFont font = painter.font();
      font.setBold(true);
      font.setPixelSize(100);
      mark.addText(QPointF(0, 0), font, "?");
      const QRectF box = mark.boundingRect();
      painter.scale(1.8 / box.height(), 1.8 / box.height());
      painter.translate(-box.center());
      painter.fillPath(mark, painter.brush());
      break;
    }
  }
  painter.restore();
}

}  // namespace eyebridge::gui
