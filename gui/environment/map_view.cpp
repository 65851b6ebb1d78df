#include "environment/map_view.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "plan/paint_world.hpp"

namespace eyebridge::gui {
namespace {

/// Cells go up, lines of a picture down.
QImage picture_of_cells(const mapping::Raster<std::uint8_t>& grey) {
  const mapping::GridGeometry& grid = grey.geometry;
  const QImage shared(grey.cells.data(), grid.columns, grid.rows, grid.columns,
                      QImage::Format_Grayscale8);
  return shared.mirrored(false, true);
}

Vec2 extent_of(const mapping::GridGeometry& grid) {
  return {grid.columns * grid.resolution, grid.rows * grid.resolution};
}

}  // namespace

MapView::MapView(const robios::MapBoard& board, QWidget* parent) : QWidget(parent), board_(board) {
  setMinimumSize(80, 80);
  refresh();
}

void MapView::refresh() {
  auto next = board_.look();
  if (next == look_ || next == nullptr) return;
  look_ = std::move(next);
  picture_ = picture_of_cells(look_->grey);
  if (!is_placed_) fit();
  update();
}

void MapView::fit() {
  is_placed_ = false;
  if (look_ == nullptr) return;
  const mapping::GridGeometry& grid = look_->grey.geometry;
  viewport_.fit({}, extent_of(grid));
  viewport_.centre_on(grid.origin + 0.5 * extent_of(grid));
  update();
}

void MapView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Window));
  if (look_ == nullptr) {
    painter.drawText(rect(), Qt::AlignCenter, tr("Nothing yet"));
    return;
  }
  const mapping::GridGeometry& grid = look_->grey.geometry;
  const Vec2 upper = grid.origin + extent_of(grid);
  painter.drawImage(QRectF(viewport_.to_pixel({grid.origin.x, upper.y}),
                           viewport_.to_pixel({upper.x, grid.origin.y})),
                    picture_);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const robios::MapRobot& robot : look_->robots) {
    world::BodyView body;
    body.pose = robot.pose;
    body.radius = robot.radius;
    body.colour = {70, 130, 220};
    paint_robot(painter, viewport_, body, QString::number(robot.number), false, false);
  }
}

void MapView::resizeEvent(QResizeEvent* event) {
  viewport_.resize(event->size());
  if (!is_placed_) fit();
}

void MapView::mousePressEvent(QMouseEvent* event) { last_ = event->position(); }

void MapView::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() == Qt::NoButton) return;
  viewport_.pan(event->position() - last_);
  last_ = event->position();
  is_placed_ = true;
  update();
}

void MapView::mouseDoubleClickEvent(QMouseEvent* /*event*/) { fit(); }

void MapView::wheelEvent(QWheelEvent* event) {
  viewport_.zoom_at(event->position(), zoom_of(*event));
  is_placed_ = true;
  update();
}

}  // namespace eyebridge::gui
