#include "environment/tape.hpp"

#include <QFontMetricsF>
#include <QPainter>

#include "eyebridge/base/units.hpp"

namespace eyebridge::gui {

QString tape_text(const Tape& tape) {
  const Vec2 way = tape.to - tape.from;
  return QString("%1 mm, %2°")
      .arg(m_to_mm(norm(way)), 0, 'f', 0)
      .arg(rad_to_deg(arc_tan2(way.y, way.x)), 0, 'f', 1);
}

void paint_tape(QPainter& painter, const Viewport& view, const Tape& tape) {
  const QColor colour(0, 60, 200);
  const QPointF from = view.to_pixel(tape.from);
  const QPointF to = view.to_pixel(tape.to);
  painter.setPen(QPen(colour, 2.0, Qt::DashLine));
  painter.drawLine(from, to);
  constexpr double kEnd = 4.0;  // pixels
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawEllipse(from, kEnd, kEnd);
  painter.drawEllipse(to, kEnd, kEnd);
  // Beside the end, on a ground of its own: there may be anything below.
  const QString text = tape_text(tape);
  constexpr double kMargin = 3.0;
  QRectF box = QFontMetricsF(painter.font()).boundingRect(text);
  box.moveTopLeft(to + QPointF(3 * kEnd, 3 * kEnd));
  box.adjust(-kMargin, -kMargin, kMargin, kMargin);
  painter.setBrush(QColor(255, 255, 255, 220));
  painter.drawRect(box);
  painter.setPen(colour);
  painter.drawText(box, Qt::AlignCenter, text);
}

void paint_place(QPainter& painter, const Viewport& view, const Pose& place) {
  constexpr double kLength = 40.0;  // pixels
  constexpr double kTip = 10.0;
  painter.save();
  painter.translate(view.to_pixel(place.position()));
  painter.rotate(-rad_to_deg(place.theta));
  painter.setPen(QPen(QColor(0, 120, 0), 3.0));
  painter.drawLine(QPointF(0, -kTip), QPointF(0, kTip));
  painter.drawLine(QPointF(0, 0), QPointF(kLength, 0));
  painter.drawLine(QPointF(kLength, 0), QPointF(kLength - kTip, kTip));
  painter.drawLine(QPointF(kLength, 0), QPointF(kLength - kTip, -kTip));
  painter.restore();
}

}  // namespace eyebridge::gui
