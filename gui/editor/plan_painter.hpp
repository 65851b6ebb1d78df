#pragma once

#include <QImage>

#include "editor/canvas.hpp"

class QPainter;

namespace eyebridge::gui {

/// Floor, its texture unless null, grid lines `grid` metres apart unless 0 or too fine, walls and
/// markers.
void paint_plan_ground(QPainter& painter, const Viewport& view, const Plan& plan,
                       const QImage& texture, double grid);
/// Starts, things with their ways, robots with the numbers that a run gives them.
void paint_plan_items(QPainter& painter, const Viewport& view, const Plan& plan,
                      const Catalogue& catalogue);
/// Rings, thick lines and handles in `colour` about what is selected.
void paint_selection(QPainter& painter, const Viewport& view, const Plan& plan,
                     const Catalogue& catalogue, const Selection& selection, const QColor& colour);
/// The handles of the ways of what is selected; a picked one is filled.
void paint_way_points(QPainter& painter, const Viewport& view, const Plan& plan, const Item& item,
                      const std::optional<WayPoint>& picked, const QColor& colour);

}  // namespace eyebridge::gui
