#include "editor/edits.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <vector>

#include "editor/catalogue.hpp"

namespace eyebridge::gui {
namespace {

/// Sums of decimal lengths as decimals again: files and people are to read 300, not
/// 300.00000000000006.
double tidy(double metres) {
  constexpr double kSteps = 1e5;  // a metre: hundredths of a millimetre
  const double near = std::round(metres * kSteps) / kSteps;
  return std::abs(metres - near) < 1e-11 ? near : metres;
}
Vec2 tidy_sum(Vec2 a, Vec2 b) { return {tidy(a.x + b.x), tidy(a.y + b.y)}; }

template <class List>
void erase_selected(List& list, Kind kind, const Selection& items) {
  std::size_t index = 0;
  std::erase_if(list, [&](const auto&) { return items.contains({kind, index++}); });
}

void leave_letter(Plan& plan, std::size_t robot, const Pose& pose) {
  plan.robots[robot].start.reset();
  plan.robots[robot].pose = pose;
}

void set_pose(Plan& plan, const Item& item, const Pose& pose) {
  switch (item.kind) {
    case Kind::Wall:
      break;
    case Kind::Marker:
      plan.markers[item.index].position = pose.position();
      break;
    case Kind::Start:
      plan.starts[item.index].pose = pose;
      break;
    case Kind::Thing:
      plan.things[item.index].spec.pose = pose;
      plan.things[item.index].is_drawn = false;
      break;
    case Kind::Robot:
      leave_letter(plan, item.index, pose);
      break;
  }
}

void remove_robots(Plan& plan, const Selection& items, const IsObject& is_object) {
  const std::vector<int> before = run_numbers(plan.robots, is_object);
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < plan.robots.size(); ++i) {
    if (!items.contains({Kind::Robot, i})) left.push_back(i);
  }
  if (left.size() == plan.robots.size()) return;
  erase_selected(plan.robots, Kind::Robot, items);
  const std::vector<int> after = run_numbers(plan.robots, is_object);
  std::map<int, int> now;  // the number that a robot has by the one it had; 0: it is gone
  for (const int number : before) now[number] = 0;
  for (std::size_t k = 0; k < left.size(); ++k) now[before[left[k]]] = after[k];
  std::erase_if(plan.rest.errors, [&](files::ErrorRule& rule) {
    if (!rule.robot || !now.contains(*rule.robot)) return false;
    rule.robot = now[*rule.robot];
    return *rule.robot == 0;
  });
}

/// Takes a way-point out, with the speed of the leg that leads there, and the wait.
void erase_point(world::Path& way, std::size_t point) {
  const auto erase_from = [point](auto& values) {
    if (point < values.size()) values.erase(values.begin() + static_cast<std::ptrdiff_t>(point));
  };
  erase_from(way.points);
  erase_from(way.leg_speeds);
  erase_from(way.waits);
}

}  // namespace

std::vector<int> run_numbers(const std::vector<files::SimRobot>& robots,
                             const IsObject& is_object) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (!is_object(robots[i].model)) order.push_back(i);
  }
  std::ranges::stable_sort(order, {},
                           [&](std::size_t i) { return robots[i].enters.value_or(0.0); });
  std::vector<int> out(robots.size(), 0);
  for (std::size_t k = 0; k < order.size(); ++k) out[order[k]] = static_cast<int>(k) + 1;
  return out;
}

void keep_numbers(Plan& plan, const IsObject& is_object, const std::function<void()>& change) {
  const std::vector<int> before = run_numbers(plan.robots, is_object);
  change();
  const std::vector<int> after = run_numbers(plan.robots, is_object);
  for (files::ErrorRule& rule : plan.rest.errors) {
    if (!rule.robot) continue;
    const auto robot = std::ranges::find(before, *rule.robot);
    const auto index = static_cast<std::size_t>(robot - before.begin());
    if (robot != before.end() && after[index] != 0) rule.robot = after[index];
  }
}

void move_items(Plan& plan, const Selection& items, Vec2 by) {
  const Plan before = plan;
  std::vector<Vec2> ends;
  for (const Item& item : items) {
    if (!has(before, item)) continue;
    if (item.kind == Kind::Wall) {
      for (const Vec2 end : {before.walls[item.index].a, before.walls[item.index].b}) {
        const auto known = [&](Vec2 other) { return same_point(end, other); };
        if (std::ranges::none_of(ends, known)) ends.push_back(end);
      }
      continue;
    }
    const auto pose = pose_of(before, item);
    if (!pose) continue;
    const Vec2 to = tidy_sum(pose->position(), by);
    set_pose(plan, item, {to.x, to.y, pose->theta});
    if (items.size() == 1 || way_of(before, item) == nullptr) continue;
    for (Vec2& point : make_way(plan, item)->points) point = tidy_sum(point, by);
  }
  for (world::Wall& wall : plan.walls) {
    for (Vec2* end : {&wall.a, &wall.b}) {
      const auto here = [&](Vec2 other) { return same_point(*end, other); };
      if (std::ranges::any_of(ends, here)) *end = tidy_sum(*end, by);
    }
  }
}

void move_vertex(Plan& plan, Vec2 from, Vec2 to) {
  for (world::Wall& wall : plan.walls) {
    if (same_point(wall.a, from)) wall.a = to;
    if (same_point(wall.b, from)) wall.b = to;
  }
}

void turn_item(Plan& plan, const Item& item, double theta) {
  if (item.kind == Kind::Wall || item.kind == Kind::Marker) return;
  const auto pose = pose_of(plan, item);
  if (!pose) return;
  const double angle = wrap_angle(theta);
  if (item.kind == Kind::Robot && plan.robots[item.index].start) {  // it stays at its letter
    plan.robots[item.index].pose = Pose{0, 0, angle};
  } else {
    set_pose(plan, item, {pose->x, pose->y, angle});
  }
}

bool split_wall(Plan& plan, std::size_t wall, Vec2 at) {
  world::Wall& first = plan.walls.at(wall);
  const Vec2 along = first.b - first.a;
  const double t = std::clamp(dot(at - first.a, along) / norm_squared(along), 0.0, 1.0);
  const Vec2 middle = tidy_sum(first.a, t * along);
  if (same_point(middle, first.a) || same_point(middle, first.b)) return false;
  world::Wall second = first;
  first.b = second.a = middle;
  plan.walls.insert(plan.walls.begin() + static_cast<std::ptrdiff_t>(wall) + 1, second);
  return true;
}

void drop_points(Plan& plan) {
  std::erase_if(plan.walls, [](const world::Wall& wall) { return same_point(wall.a, wall.b); });
}

void remove_items(Plan& plan, const Selection& items, const IsObject& is_object) {
  erase_selected(plan.walls, Kind::Wall, items);
  erase_selected(plan.markers, Kind::Marker, items);
  erase_selected(plan.starts, Kind::Start, items);
  erase_selected(plan.things, Kind::Thing, items);
  remove_robots(plan, items, is_object);
}

Plan copy_of(const Plan& plan, const Selection& items) {
  Plan out;
  for (const Item& item : items) {
    if (!has(plan, item)) continue;
    if (item.kind == Kind::Wall) out.walls.push_back(plan.walls[item.index]);
    if (item.kind == Kind::Marker) out.markers.push_back(plan.markers[item.index]);
    if (item.kind == Kind::Start) out.starts.push_back(plan.starts[item.index]);
    if (item.kind == Kind::Thing) out.things.push_back(plan.things[item.index]);
    if (item.kind == Kind::Robot) {
      out.robots.push_back(plan.robots[item.index]);
      if (const auto pose = pose_of_robot(plan, item.index)) {
        leave_letter(out, out.robots.size() - 1, *pose);
      }
    }
  }
  for (Thing& thing : out.things) thing.is_drawn = false;
  return out;
}

Selection paste(Plan& plan, const Plan& clip, Vec2 by) {
  Plan moved = clip;
  // Their ways, too, even of one alone: it is another one than the one that was copied.
  move_items(moved, all_items(moved), by);
  if (all_items(moved).size() == 1) {
    for (Thing& thing : moved.things) {
      if (!thing.spec.path) continue;
      for (Vec2& point : thing.spec.path->points) point = tidy_sum(point, by);
    }
  }
  Selection added;
  const auto append = [&](auto& list, const auto& more, Kind kind) {
    for (std::size_t i = 0; i < more.size(); ++i) added.insert({kind, list.size() + i});
    list.insert(list.end(), more.begin(), more.end());
  };
  append(plan.walls, moved.walls, Kind::Wall);
  append(plan.markers, moved.markers, Kind::Marker);
  append(plan.starts, moved.starts, Kind::Start);
  append(plan.things, moved.things, Kind::Thing);
  append(plan.robots, moved.robots, Kind::Robot);
  return added;
}

Item add_wall(Plan& plan, Vec2 a, Vec2 b, const world::Wall& like) {
  world::Wall wall = like;
  wall.a = a;
  wall.b = b;
  plan.walls.push_back(wall);
  return {Kind::Wall, plan.walls.size() - 1};
}

Item add_thing(Plan& plan, const std::string& name, Vec2 at) {
  plan.things.push_back({builtin_thing(name), false});
  plan.things.back().spec.pose = {at.x, at.y, 0.0};
  return {Kind::Thing, plan.things.size() - 1};
}

Item add_marker(Plan& plan, Vec2 at) {
  plan.markers.push_back({at, {255, 0, 0}});
  return {Kind::Marker, plan.markers.size() - 1};
}

Item add_robot(Plan& plan, const std::string& model, Vec2 at) {
  files::SimRobot robot;
  robot.model = model;
  robot.pose = Pose{at.x, at.y, 0.0};
  plan.robots.push_back(robot);
  return {Kind::Robot, plan.robots.size() - 1};
}

Item add_start(Plan& plan, Vec2 at) {
  // In a maze a start is a letter; elsewhere it has none.
  plan.starts.push_back({plan.cell ? 'R' : '\0', {at.x, at.y, 0.0}});
  return {Kind::Start, plan.starts.size() - 1};
}

bool add_way_point(Plan& plan, const Item& item, std::size_t before, Vec2 at) {
  const auto pose = pose_of(plan, item);
  const world::Path* const old = way_of(plan, item);
  const std::size_t count = old == nullptr ? 0 : old->points.size();
  const std::size_t place = std::min(before, count);
  if (place < count && same_point(old->points[place], at)) return false;
  if (place > 0 && same_point(old->points[place - 1], at)) return false;
  if (place == 0 && pose && same_point(pose->position(), at)) return false;
  world::Path* const way = make_way(plan, item);
  if (way == nullptr) return false;
  const auto index = static_cast<std::ptrdiff_t>(place);
  way->points.insert(way->points.begin() + index, at);
  // Both halves of the leg are as fast as it was, and nobody waits at the new point.
  std::vector<double>& speeds = way->leg_speeds;
  if (place < speeds.size()) speeds.insert(speeds.begin() + index, double{speeds[place]});
  if (place < way->waits.size()) way->waits.insert(way->waits.begin() + index, 0.0);
  return true;
}

void remove_way_point(Plan& plan, const Item& item, std::size_t point) {
  const world::Path* const old = way_of(plan, item);
  if (old == nullptr || point >= old->points.size()) return;
  world::Path& way = *make_way(plan, item);
  std::vector<Vec2>& points = way.points;
  erase_point(way, point);
  // Its neighbours may be one place.
  if (point > 0 && point < points.size() && same_point(points[point - 1], points[point])) {
    erase_point(way, point);
  }
  fit_profile(way);
  if (!points.empty()) return;
  if (item.kind == Kind::Thing) {
    plan.things[item.index].spec.path.reset();
    plan.things[item.index].spec.yields_within = 0.0;
  }
  if (item.kind == Kind::Robot) {
    plan.robots[item.index].traits.path.reset();
    plan.robots[item.index].traits.yields_within.reset();
  }
}

void move_way_point(Plan& plan, const Item& item, std::size_t point, Vec2 to) {
  const world::Path* const old = way_of(plan, item);
  if (old == nullptr || point >= old->points.size()) return;
  const bool meets_before = point > 0 && same_point(old->points[point - 1], to);
  const bool meets_next = point + 1 < old->points.size() && same_point(old->points[point + 1], to);
  if (!meets_before && !meets_next) make_way(plan, item)->points[point] = to;
}

}  // namespace eyebridge::gui
