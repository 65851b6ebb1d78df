// What the mouse does in the editor's canvas.
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>
#include <utility>

#include "editor/canvas.hpp"
#include "editor/edits.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::gui {
namespace {

constexpr double kSlackPixels = 5.0;
constexpr double kTinyPixels = 4.0;  // a press that moves less is a click
constexpr double kTurnStep = 15.0;   // degrees, while the grid is on

double heading_from(Vec2 centre, Vec2 to, bool free) {
  const Vec2 way = to - centre;
  const double degrees = rad_to_deg(arc_tan2(way.y, way.x));
  const double step = free ? 1.0 : kTurnStep;
  return wrap_angle(deg_to_rad(std::round(degrees / step) * step));
}

bool is_free(Qt::KeyboardModifiers keys) { return keys.testFlag(Qt::ControlModifier); }

}  // namespace

double Canvas::slack() const { return kSlackPixels / view_.pixels_per_metre(); }

bool Canvas::is_tiny(QPointF pixel) const {
  return (pixel - press_pixel_).manhattanLength() < kTinyPixels;
}

Vec2 Canvas::snapped(Vec2 place, Qt::KeyboardModifiers keys) const {
  return on_grid(place, is_free(keys) ? 0.0 : grid_);
}

Vec2 Canvas::wall_end(Vec2 place, Qt::KeyboardModifiers keys) const {
  if (chain_ && keys.testFlag(Qt::ShiftModifier)) {
    return straightened(*chain_, snapped(place, keys));
  }
  if (is_free(keys)) return on_grid(place, 0.0);
  return on_vertex_or_grid(document_.plan(), place, grid_, 1.5 * slack());
}

void Canvas::say(const QString& text) {
  if (on_message) on_message(text);
}

void Canvas::say_length(Vec2 from, Vec2 to) {
  measure_ = {from, to};
  const Vec2 way = to - from;
  say(tr("%1 mm, %2°")
          .arg(m_to_mm(norm(way)), 0, 'f', 0)
          .arg(rad_to_deg(arc_tan2(way.y, way.x)), 0, 'f', 1));
}

void Canvas::mousePressEvent(QMouseEvent* event) {
  setFocus();
  if (event->button() == Qt::MiddleButton) {
    pan_from_ = event->position();
    setCursor(Qt::ClosedHandCursor);
    return;
  }
  if (event->button() == Qt::RightButton) return cancel();
  if (event->button() != Qt::LeftButton) return;
  const Vec2 place = view_.to_world(event->position());
  press_pixel_ = event->position();
  press_place_ = place;
  is_down_ = true;
  has_moved_ = false;
  const Qt::KeyboardModifiers keys = event->modifiers();
  switch (tool_) {
    case PlanTool::Select:
      return press_select(place, keys);
    case PlanTool::Wall:
      return press_wall(place, keys);
    case PlanTool::Way:
      return press_way(place, keys);
    case PlanTool::Measure:
      press_place_ = on_vertex_or_grid(document_.plan(), place, is_free(keys) ? 0 : grid_, slack());
      return say_length(press_place_, press_place_);
    default:
      return press_place(place, keys);
  }
}

void Canvas::take_hold(std::optional<Hold> hold) {
  hold_ = hold;
  held_version_ = document_.version();
}

void Canvas::press_select(Vec2 place, Qt::KeyboardModifiers keys) {
  take_hold(pick(document_.plan(), catalogue_, place, slack()));
  way_point_.reset();
  const bool adds = keys.testFlag(Qt::ShiftModifier);
  if (!hold_) {
    is_band_ = true;
    if (!adds) document_.select({});
    return update();
  }
  if (hold_->part == Hold::Part::WayPoint) way_point_ = WayPoint{hold_->item, hold_->point};
  Selection selection = document_.selection();
  if (adds) {
    if (!selection.insert(hold_->item).second) selection.erase(hold_->item);
  } else if (!selection.contains(hold_->item)) {
    selection = {hold_->item};
  }
  document_.select(std::move(selection));
  update();
}

void Canvas::press_wall(Vec2 place, Qt::KeyboardModifiers keys) {
  const Vec2 end = wall_end(place, keys);
  if (chain_) return;  // the release ends this wall
  chain_ = chain_first_ = end;
  say_length(end, end);
  update();
}

void Canvas::press_place(Vec2 place, Qt::KeyboardModifiers keys) {
  new_at_ = snapped(place, keys);
  document_.preview([&](Plan& plan) { add(plan, *new_at_); });
}

void Canvas::press_way(Vec2 place, Qt::KeyboardModifiers keys) {
  const auto hold = pick(document_.plan(), catalogue_, place, slack());
  const auto can_move = [&](const Item& item) {
    return item.kind == Kind::Thing ||
           (item.kind == Kind::Robot &&
            catalogue_.find(document_.plan().robots[item.index].model).is_object);
  };
  const Selection& selection = document_.selection();
  const bool has_one = selection.size() == 1 && can_move(*selection.begin());
  if (hold && hold->part == Hold::Part::WayPoint) {
    take_hold(hold);  // to be dragged
    way_point_ = WayPoint{hold->item, hold->point};
    return document_.select({hold->item});
  }
  if (hold && can_move(hold->item) && hold->part != Hold::Part::Way &&
      !selection.contains(hold->item)) {
    say(tr("Click where it shall go, point by point"));
    return document_.select({hold->item});
  }
  if (!has_one) return say(tr("Click on a thing first: its way begins there"));
  const Item item = *selection.begin();
  const Vec2 at = snapped(place, keys);
  document_.edit(tr("Add way-point"),
                 [&](Plan& plan) { add_way_point(plan, item, static_cast<std::size_t>(-1), at); });
}

void Canvas::mouseMoveEvent(QMouseEvent* event) {
  const Vec2 place = view_.to_world(event->position());
  const Qt::KeyboardModifiers keys = event->modifiers();
  pointer_ = place;
  if (on_pointer) on_pointer(place);
  if (pan_from_) {
    is_fitted_ = false;
    view_.pan(event->position() - *pan_from_);
    pan_from_ = event->position();
    return update();
  }
  if (chain_) {
    say_length(*chain_, wall_end(place, keys));
    return update();
  }
  if (!is_down_) return;
  has_moved_ = has_moved_ || !is_tiny(event->position());
  if (!has_moved_) return;
  if (tool_ == PlanTool::Measure) {
    say_length(press_place_,
               on_vertex_or_grid(document_.plan(), place, is_free(keys) ? 0 : grid_, slack()));
  } else if (new_at_) {
    drag_new(place, keys);
  } else if (hold_) {
    drag_hold(place, keys);
  }
  update();
}

void Canvas::drag_new(Vec2 place, Qt::KeyboardModifiers keys) {
  document_.preview([&](Plan& plan) {
    turn_item(plan, add(plan, *new_at_), heading_from(*new_at_, place, is_free(keys)));
  });
}

void Canvas::drag_hold(Vec2 place, Qt::KeyboardModifiers keys) {
  const Plan& plan = document_.settled();
  const Hold& hold = *hold_;
  switch (hold.part) {
    case Hold::Part::Vertex: {
      // On another vertex it meets that one, and the walls are joined.
      const Vec2 to = is_free(keys) ? on_grid(place, 0.0)
                                    : on_vertex_or_grid(plan, place, grid_, 1.5 * slack(), hold.at);
      const world::Wall& wall = plan.walls[hold.item.index];
      document_.preview([&](Plan& changed) { move_vertex(changed, hold.at, to); });
      return say_length(same_point(wall.a, hold.at) ? wall.b : wall.a, to);
    }
    case Hold::Part::WayPoint: {
      const Vec2 to = snapped(place, keys);
      return document_.preview(
          [&](Plan& changed) { move_way_point(changed, hold.item, hold.point, to); });
    }
    case Hold::Part::Rim: {
      const auto pose = pose_of(plan, hold.item);
      if (!pose) return;
      const Vec2 from = press_place_ - pose->position();
      const Vec2 to = place - pose->position();
      const double turn = arc_tan2(cross(from, to), dot(from, to));
      const Vec2 ahead = Heading::from_angle(pose->theta + turn).forward();
      const double theta = heading_from({0, 0}, ahead, is_free(keys));
      say(tr("%1°").arg(rad_to_deg(theta), 0, 'f', 0));
      return document_.preview([&](Plan& changed) { turn_item(changed, hold.item, theta); });
    }
    case Hold::Part::Body:
    case Hold::Part::Way: {
      const auto pose = pose_of(plan, hold.item);
      if (!pose) return;
      // One end of a wall comes to lie on the grid, not its middle.
      const Vec2 start =
          hold.item.kind == Kind::Wall ? plan.walls[hold.item.index].a : pose->position();
      const Vec2 by = snapped(start + (place - press_place_), keys) - start;
      say_length(start, start + by);
      const Selection& selection = document_.selection();
      return document_.preview([&](Plan& changed) { move_items(changed, selection, by); });
    }
  }
}

void Canvas::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::MiddleButton) {
    pan_from_.reset();
    unsetCursor();
    return;
  }
  if (event->button() != Qt::LeftButton || !is_down_) return;
  is_down_ = false;
  const Vec2 place = view_.to_world(event->position());
  if (tool_ == PlanTool::Wall && chain_) {
    const Vec2 end = wall_end(place, event->modifiers());
    if (!same_point(*chain_, end)) finish_wall(end);
    // A wall that was drawn in one stroke is one; a click begins the next one.
    if (!is_tiny(event->position())) chain_.reset();
    return update();
  }
  if (new_at_) {
    new_at_.reset();
    document_.commit(step_name());
    const Plan& plan = document_.plan();
    const Kind kind = tool_ == PlanTool::Thing    ? Kind::Thing
                      : tool_ == PlanTool::Marker ? Kind::Marker
                      : tool_ == PlanTool::Robot  ? Kind::Robot
                                                  : Kind::Start;
    Item last{kind, 0};
    while (has(plan, {kind, last.index + 1})) ++last.index;
    return document_.select({last});
  }
  release_select(place, event->modifiers());
}

void Canvas::release_select(Vec2 place, Qt::KeyboardModifiers keys) {
  if (std::exchange(is_band_, false)) {
    Selection selection = items_within(document_.plan(), catalogue_, press_place_, place);
    if (keys.testFlag(Qt::ShiftModifier)) {
      selection.insert(document_.selection().begin(), document_.selection().end());
    }
    document_.select(std::move(selection));
  } else if (hold_ && has_moved_) {
    const bool turns = hold_->part == Hold::Part::Rim;
    document_.commit(turns ? tr("Turn") : tr("Move"));
  }
  hold_.reset();
  if (tool_ != PlanTool::Measure) measure_.reset();
  update();
}

void Canvas::finish_wall(Vec2 end) {
  const Vec2 start = *chain_;
  Item added;
  const Plan& plan = document_.plan();
  // Like the wall drawn before it; the first one like those of files.
  world::Wall like;
  like.thickness = world::Wall::kFileThickness;
  if (!plan.walls.empty()) like = plan.walls.back();
  document_.edit(tr("Draw wall"),
                 [&](Plan& changed) { added = add_wall(changed, start, end, like); });
  document_.select({added});
  chain_ = end;
  if (same_point(end, chain_first_)) chain_.reset();  // the room is closed
  say_length(start, end);
}

void Canvas::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (tool_ == PlanTool::Wall) {  // the first click has drawn it; this one ends the row
    chain_.reset();
    measure_.reset();
    return update();
  }
  if (tool_ != PlanTool::Select) return mousePressEvent(event);
  const auto hold = pick(document_.plan(), catalogue_, view_.to_world(event->position()), slack());
  if (!hold) return;
  const Vec2 at = snapped(hold->at, event->modifiers());
  if (hold->part == Hold::Part::Way) {
    document_.edit(tr("Add way-point"),
                   [&](Plan& plan) { add_way_point(plan, hold->item, hold->point, at); });
  } else if (hold->item.kind == Kind::Wall && hold->part == Hold::Part::Body) {
    document_.edit(tr("Split wall"), [&](Plan& plan) { split_wall(plan, hold->item.index, at); });
  }
}

void Canvas::wheelEvent(QWheelEvent* event) {
  is_fitted_ = false;
  view_.zoom_at(event->position(), zoom_of(*event));
  update();
}

}  // namespace eyebridge::gui
