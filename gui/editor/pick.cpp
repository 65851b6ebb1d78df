#include "editor/pick.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "eyebridge/base/units.hpp"
#include "plan/grip.hpp"

namespace eyebridge::gui {
namespace {

constexpr double kMarkerRadius = 0.05;  // metres, as drawn

Vec2 nearest_on(Vec2 a, Vec2 b, Vec2 place) {
  const Vec2 along = b - a;
  const double length = norm_squared(along);
  if (length == 0) return a;
  return a + std::clamp(dot(place - a, along) / length, 0.0, 1.0) * along;
}

/// The shape of a thing, or of what a line of the robots' form places.
world::ObjectSpec shape_of(const Plan& plan, const Catalogue& catalogue, const Item& item) {
  if (item.kind == Kind::Thing) return plan.things[item.index].spec;
  const Catalogue::Entry entry = catalogue.find(plan.robots[item.index].model);
  world::ObjectSpec shape = entry.object;
  shape.radius = entry.radius;
  if (!entry.is_object) shape.kind = world::ObjectKind::Can;
  return shape;
}

std::optional<Hold> pick_body(const Plan& plan, const Catalogue& catalogue, const Item& item,
                              Vec2 place, double slack) {
  const auto pose = pose_of(plan, item);
  if (!pose) return {};
  const Vec2 middle = pose->position();
  const double away = norm(place - middle);
  const double radius = radius_of(plan, catalogue, item);
  if (away > radius + slack) return {};
  Hold hold{item, Hold::Part::Body, 0, middle};
  if (item.kind == Kind::Marker) return hold;
  if (item.kind == Kind::Start) {
    if (away > kRimShare * radius) hold.part = Hold::Part::Rim;
    return hold;
  }
  world::ObjectSpec shape = shape_of(plan, catalogue, item);
  shape.pose = *pose;
  if (const std::vector<Vec2> corners = world::corners_of(shape); !corners.empty()) {
    if (world::rim_distance(shape, place) > slack) return {};
    const Heading heading = Heading::from_angle(pose->theta);
    for (const Vec2 corner : corners) {
      if (norm(place - middle - heading.rotate(corner)) < 1.5 * slack) hold.part = Hold::Part::Rim;
    }
  } else if (item.kind == Kind::Robot && away > kRimShare * radius) {
    hold.part = Hold::Part::Rim;
  }
  return hold;
}

std::optional<Hold> pick_way(const Plan& plan, const Item& item, Vec2 place, double slack,
                             Hold::Part part) {
  const world::Path* const way = way_of(plan, item);
  const auto pose = pose_of(plan, item);
  if (way == nullptr || !pose) return {};
  Vec2 last = pose->position();
  for (std::size_t i = 0; i < way->points.size(); ++i) {
    const Vec2 point = way->points[i];
    if (part == Hold::Part::WayPoint && norm(place - point) < 1.5 * slack) {
      return Hold{item, part, i, point};
    }
    const Vec2 near = nearest_on(last, point, place);
    if (part == Hold::Part::Way && norm(place - near) < slack) return Hold{item, part, i, near};
    last = point;
  }
  const Vec2 near = nearest_on(last, pose->position(), place);
  if (part == Hold::Part::Way && way->loop && norm(place - near) < slack) {
    return Hold{item, part, way->points.size(), near};
  }
  return {};
}

std::optional<Hold> pick_ways(const Plan& plan, Vec2 place, double slack, Hold::Part part) {
  for (const Kind kind : {Kind::Robot, Kind::Thing}) {
    for (Item item{kind, 0}; has(plan, item); ++item.index) {
      if (auto hold = pick_way(plan, item, place, slack, part)) return hold;
    }
  }
  return {};
}

std::optional<Hold> pick_walls(const Plan& plan, Vec2 place, double slack) {
  std::optional<Hold> nearest;
  double least = 1.5 * slack;
  for (std::size_t i = 0; i < plan.walls.size(); ++i) {
    for (const Vec2 end : {plan.walls[i].a, plan.walls[i].b}) {
      const double away = norm(place - end);
      if (away >= least) continue;
      least = away;
      nearest = Hold{{Kind::Wall, i}, Hold::Part::Vertex, 0, end};
    }
  }
  if (nearest) return nearest;
  for (std::size_t i = 0; i < plan.walls.size(); ++i) {
    const world::Wall& wall = plan.walls[i];
    const Vec2 near = nearest_on(wall.a, wall.b, place);
    const double away = norm(place - near) - wall.thickness / 2;
    if (away > slack || (nearest && away >= least)) continue;
    least = away;
    nearest = Hold{{Kind::Wall, i}, Hold::Part::Body, 0, near};
  }
  return nearest;
}

}  // namespace

double radius_of(const Plan& plan, const Catalogue& catalogue, const Item& item) {
  switch (item.kind) {
    case Kind::Wall:
      return 0.0;
    case Kind::Marker:
      return kMarkerRadius;
    case Kind::Start:
      return kStartRadius;
    case Kind::Thing:
      return plan.things[item.index].spec.outer_radius();
    case Kind::Robot:
      return catalogue.find(plan.robots[item.index].model).radius;
  }
  return 0.0;
}

std::optional<Hold> pick(const Plan& plan, const Catalogue& catalogue, Vec2 place, double slack) {
  if (auto hold = pick_ways(plan, place, slack, Hold::Part::WayPoint)) return hold;
  for (const Kind kind : {Kind::Robot, Kind::Thing, Kind::Start, Kind::Marker}) {
    std::optional<Hold> topmost;  // later ones are drawn over earlier ones
    for (Item item{kind, 0}; has(plan, item); ++item.index) {
      if (auto hold = pick_body(plan, catalogue, item, place, slack)) topmost = hold;
    }
    if (topmost) return topmost;
  }
  if (auto hold = pick_walls(plan, place, slack)) return hold;
  return pick_ways(plan, place, slack, Hold::Part::Way);
}

Selection items_within(const Plan& plan, const Catalogue& catalogue, Vec2 a, Vec2 b) {
  const Vec2 low{std::min(a.x, b.x), std::min(a.y, b.y)};
  const Vec2 high{std::max(a.x, b.x), std::max(a.y, b.y)};
  const auto holds = [&](Vec2 place, double radius) {
    return place.x - radius >= low.x && place.y - radius >= low.y && place.x + radius <= high.x &&
           place.y + radius <= high.y;
  };
  Selection out;
  for (const Item& item : all_items(plan)) {
    if (item.kind == Kind::Wall) {
      const world::Wall& wall = plan.walls[item.index];
      if (holds(wall.a, 0) && holds(wall.b, 0)) out.insert(item);
    } else if (const auto pose = pose_of(plan, item)) {
      if (holds(pose->position(), radius_of(plan, catalogue, item))) out.insert(item);
    }
  }
  return out;
}

Vec2 on_grid(Vec2 place, double step) {
  const double step_mm = step > 0 ? m_to_mm(step) : 1.0;
  const auto rounded = [&](double metres) {
    return mm_to_m(std::round(m_to_mm(metres) / step_mm) * step_mm) + 0.0;  // no minus zero
  };
  return {rounded(place.x), rounded(place.y)};
}

Vec2 on_vertex_or_grid(const Plan& plan, Vec2 place, double step, double reach,
                       std::optional<Vec2> except) {
  Vec2 best = on_grid(place, step);
  double least = reach;
  for (const world::Wall& wall : plan.walls) {
    for (const Vec2 end : {wall.a, wall.b}) {
      const double away = norm(end - place);
      if (away >= least || (except && same_point(end, *except))) continue;
      least = away;
      best = end;
    }
  }
  return best;
}

Vec2 straightened(Vec2 from, Vec2 to) {
  const Vec2 way = to - from;
  const double eighths = std::round(arc_tan2(way.y, way.x) / (kPi / 4));
  const int turn = static_cast<int>(eighths + 8) % 4;
  if (turn == 0) return {to.x, from.y};
  if (turn == 2) return {from.x, to.y};
  const double length = std::max(std::abs(way.x), std::abs(way.y));
  return {from.x + std::copysign(length, way.x), from.y + std::copysign(length, way.y)};
}

}  // namespace eyebridge::gui
