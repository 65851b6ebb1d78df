#include "editor/canvas.hpp"

#include <QKeyEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/edits.hpp"
#include "editor/plan_painter.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::gui {

Canvas::Canvas(Document& document, QWidget* parent) : QWidget(parent), document_(document) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(200, 150);
  setAccessibleName(tr("Plan of the world"));
  set_tool(PlanTool::Select);
}

void Canvas::set_catalogue(Catalogue catalogue) {
  catalogue_ = std::move(catalogue);
  update();
}

void Canvas::set_texture(const QImage& texture) {
  texture_ = texture;
  update();
}

void Canvas::set_tool(PlanTool tool) {
  is_down_ = false;
  is_band_ = false;
  chain_.reset();
  new_at_.reset();
  hold_.reset();
  way_point_.reset();
  measure_.reset();
  document_.cancel();
  tool_ = tool;
  setCursor(tool == PlanTool::Select ? Qt::ArrowCursor : Qt::CrossCursor);
  update();
}

void Canvas::set_grid(double step) {
  grid_ = step;
  update();
}

void Canvas::fit() {
  is_fitted_ = true;
  view_.fit({}, {document_.plan().width, document_.plan().height});
  update();
}

void Canvas::zoom(double factor) {
  is_fitted_ = false;
  view_.zoom_at(QRectF(rect()).center(), factor);
  update();
}

void Canvas::refresh() {
  if (is_fitted_ && !is_down_) view_.fit({}, {document_.plan().width, document_.plan().height});
  // Undone under the mouse, say: what it held is gone, or another thing.
  if (hold_ && held_version_ != document_.version()) hold_.reset();
  if (way_point_) {
    const world::Path* const way = way_of(document_.plan(), way_point_->item);
    const bool is_there = way != nullptr && way_point_->point < way->points.size();
    if (!is_there || !document_.selection().contains(way_point_->item)) way_point_.reset();
  }
  update();
}

void Canvas::resizeEvent(QResizeEvent* /*event*/) {
  view_.resize(size());
  if (is_fitted_) fit();
}

void Canvas::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const Plan& plan = document_.plan();
  paint_plan_ground(painter, view_, plan, texture_, grid_);
  painter.setRenderHint(QPainter::Antialiasing);
  paint_plan_items(painter, view_, plan, catalogue_);
  paint_overlay(painter);
}

void Canvas::paint_overlay(QPainter& painter) {
  const Plan& plan = document_.plan();
  const QColor colour = palette().color(QPalette::Highlight);
  paint_selection(painter, view_, plan, catalogue_, document_.selection(), colour);
  for (const Item& item : document_.selection()) {
    paint_way_points(painter, view_, plan, item, way_point_, colour);
  }
  if (chain_ && measure_) {
    painter.setPen(QPen(colour, 2.0, Qt::DashLine));
    painter.drawLine(view_.to_pixel(measure_->first), view_.to_pixel(measure_->second));
  }
  if (is_band_ && is_down_) {
    QColor fill = colour;
    fill.setAlpha(40);
    painter.setPen(QPen(colour, 1.0, Qt::DashLine));
    painter.setBrush(fill);
    painter.drawRect(QRectF(view_.to_pixel(press_place_), view_.to_pixel(pointer_)).normalized());
  }
  paint_measure(painter);
}

void Canvas::paint_measure(QPainter& painter) {
  if (!measure_) return;
  const auto& [from, to] = *measure_;
  if (tool_ == PlanTool::Measure) {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
    painter.drawLine(view_.to_pixel(from), view_.to_pixel(to));
  }
  const QString text = tr("%1 mm").arg(m_to_mm(norm(to - from)), 0, 'f', 0);
  // Beside the pointer's end, within the view.
  constexpr int kGap = 12;
  constexpr int kPad = 3;
  QRectF box = painter.fontMetrics().boundingRect(text);
  box.adjust(-kPad, -kPad, kPad, kPad);
  const QPointF end = view_.to_pixel(to);
  box.moveTopLeft({std::clamp(end.x() + kGap, 0.0, std::max(0.0, width() - box.width())),
                   std::clamp(end.y() + kGap, 0.0, std::max(0.0, height() - box.height()))});
  painter.setPen(palette().color(QPalette::ToolTipText));
  painter.setBrush(palette().color(QPalette::ToolTipBase));
  painter.drawRect(box);
  painter.drawText(box, Qt::AlignCenter, text);
}

void Canvas::remove() {
  if (is_down_) return;
  if (way_point_) {
    const WayPoint point = *std::exchange(way_point_, std::nullopt);
    return document_.edit(tr("Remove way-point"),
                          [&](Plan& plan) { remove_way_point(plan, point.item, point.point); });
  }
  const Selection selection = document_.selection();
  document_.edit(tr("Delete"), [&](Plan& plan) {
    remove_items(plan, selection,
                 [this](const std::string& model) { return catalogue_.find(model).is_object; });
  });
  document_.select({});
}

void Canvas::split() {
  const Selection selection = document_.selection();
  document_.edit(tr("Split wall"), [&](Plan& plan) {
    // From the last one: splitting moves those behind it.
    for (auto item = selection.rbegin(); item != selection.rend(); ++item) {
      if (item->kind != Kind::Wall) continue;
      const world::Wall& wall = plan.walls[item->index];
      split_wall(plan, item->index, 0.5 * (wall.a + wall.b));
    }
  });
}

void Canvas::move(Vec2 by) {
  const Selection selection = document_.selection();
  document_.edit(tr("Move"), [&](Plan& plan) { move_items(plan, selection, by); });
}

void Canvas::turn(double by) {
  const Selection selection = document_.selection();
  document_.edit(tr("Turn"), [&](Plan& plan) {
    for (const Item& item : selection) {
      if (const auto pose = pose_of(plan, item)) turn_item(plan, item, pose->theta + by);
    }
  });
}

void Canvas::cancel() {
  const bool is_busy = is_down_ || chain_ || measure_ || new_at_;
  is_down_ = false;
  is_band_ = false;
  chain_.reset();
  measure_.reset();
  new_at_.reset();
  hold_.reset();
  way_point_.reset();
  document_.cancel();
  if (!is_busy) document_.select({});
  if (on_message) on_message({});
  update();
}

void Canvas::keyPressEvent(QKeyEvent* event) {
  const bool free = event->modifiers().testFlag(Qt::ControlModifier);
  const double step = free || grid_ <= 0 ? 0.001 : grid_;
  Vec2 by;
  if (event->key() == Qt::Key_Left) by.x = -step;
  if (event->key() == Qt::Key_Right) by.x = step;
  if (event->key() == Qt::Key_Up) by.y = step;
  if (event->key() == Qt::Key_Down) by.y = -step;
  if (by == Vec2{}) return QWidget::keyPressEvent(event);
  if (!document_.selection().empty()) return move(by);
  constexpr double kPan = 40.0;  // pixels
  is_fitted_ = false;
  view_.pan(
      {by.x == 0 ? 0 : -std::copysign(kPan, by.x), by.y == 0 ? 0 : std::copysign(kPan, by.y)});
  update();
}

Item Canvas::add(Plan& plan, Vec2 at) const {
  Item added;
  keep_numbers(
      plan, [this](const std::string& model) { return catalogue_.find(model).is_object; },
      [&] { added = add_tools_item(plan, at); });
  return added;
}

Item Canvas::add_tools_item(Plan& plan, Vec2 at) const {
  switch (tool_) {
    case PlanTool::Thing:
      return add_thing(plan, thing_, at);
    case PlanTool::Marker:
      return add_marker(plan, at);
    case PlanTool::Start:
      return add_start(plan, at);
    default:
      return add_robot(plan, robot_, at);
  }
}

QString Canvas::step_name() const {
  switch (tool_) {
    case PlanTool::Thing:
      return tr("Place object");
    case PlanTool::Marker:
      return tr("Place marker");
    case PlanTool::Start:
      return tr("Place start");
    default:
      return tr("Place robot");
  }
}

}  // namespace eyebridge::gui
