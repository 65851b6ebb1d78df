#include "editor/plan.hpp"

#include <algorithm>
#include <cctype>

namespace eyebridge::gui {
namespace {

char upper_letter(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }

}  // namespace

bool same_plan(const Plan& a, const Plan& b) {
  return a.width == b.width && a.height == b.height && a.texture == b.texture &&
         a.water == b.water && a.cell == b.cell && a.walls == b.walls && a.starts == b.starts &&
         a.things == b.things && a.markers == b.markers &&
         files::same_meaning(sim_of(a), sim_of(b));
}

bool has(const Plan& plan, const Item& item) {
  switch (item.kind) {
    case Kind::Wall:
      return item.index < plan.walls.size();
    case Kind::Marker:
      return item.index < plan.markers.size();
    case Kind::Start:
      return item.index < plan.starts.size();
    case Kind::Thing:
      return item.index < plan.things.size();
    case Kind::Robot:
      return item.index < plan.robots.size();
  }
  return false;
}

Selection all_items(const Plan& plan) {
  Selection out;
  for (const Kind kind : {Kind::Wall, Kind::Marker, Kind::Start, Kind::Thing, Kind::Robot}) {
    for (Item item{kind, 0}; has(plan, item); ++item.index) out.insert(out.end(), item);
  }
  return out;
}

std::optional<Pose> pose_of_robot(const Plan& plan, std::size_t robot) {
  const files::SimRobot& wanted = plan.robots.at(robot);
  if (!wanted.start) return wanted.pose;
  // As a run deals them out: the first free start of exactly this letter, else of its other case.
  std::vector<bool> taken(plan.starts.size(), false);
  for (std::size_t i = 0; i <= robot; ++i) {
    const files::SimRobot& line = plan.robots[i];
    if (!line.start) continue;
    std::optional<std::size_t> found;
    for (const bool any_case : {false, true}) {
      for (std::size_t k = 0; k < plan.starts.size() && !found; ++k) {
        const char letter = plan.starts[k].letter;
        const bool same =
            any_case ? upper_letter(letter) == upper_letter(*line.start) : letter == *line.start;
        if (letter != 0 && same && !taken[k]) found = k;
      }
    }
    if (!found) continue;
    taken[*found] = true;
    if (i != robot) continue;
    Pose pose = plan.starts[*found].pose;
    if (line.pose) pose.theta = line.pose->theta;
    return pose;
  }
  return {};
}

std::optional<Pose> pose_of(const Plan& plan, const Item& item) {
  if (!has(plan, item)) return {};
  switch (item.kind) {
    case Kind::Wall: {
      const world::Wall& wall = plan.walls[item.index];
      const Vec2 middle = 0.5 * (wall.a + wall.b);
      const Vec2 along = wall.b - wall.a;
      return Pose{middle.x, middle.y, arc_tan2(along.y, along.x)};
    }
    case Kind::Marker: {
      const Vec2 place = plan.markers[item.index].position;
      return Pose{place.x, place.y, 0.0};
    }
    case Kind::Start:
      return plan.starts[item.index].pose;
    case Kind::Thing:
      return plan.things[item.index].spec.pose;
    case Kind::Robot:
      return pose_of_robot(plan, item.index);
  }
  return {};
}

const world::Path* way_of(const Plan& plan, const Item& item) {
  if (!has(plan, item)) return nullptr;
  const std::optional<world::Path>* way = nullptr;
  if (item.kind == Kind::Thing) way = &plan.things[item.index].spec.path;
  if (item.kind == Kind::Robot) way = &plan.robots[item.index].traits.path;
  return way != nullptr && *way ? &**way : nullptr;
}

world::Path* make_way(Plan& plan, const Item& item) {
  if (!has(plan, item)) return nullptr;
  if (item.kind == Kind::Robot) {
    files::ObjectTraits& traits = plan.robots[item.index].traits;
    traits.any = true;
    if (!traits.path) traits.path.emplace();
    traits.still = false;
    traits.reaction.reset();  // it goes its way, or does as it likes
    return &*traits.path;
  }
  if (item.kind != Kind::Thing) return nullptr;
  Thing& thing = plan.things[item.index];
  thing.is_drawn = false;
  if (!thing.spec.path) thing.spec.path.emplace();
  thing.spec.reaction.reset();
  return &*thing.spec.path;
}

void fit_profile(world::Path& path) {
  const std::size_t legs = path.leg_count();
  if (path.leg_speeds.size() > legs) path.leg_speeds.resize(legs);
  if (path.waits.size() > legs) path.waits.resize(legs);
}

Plan empty_plan(double width, double height) {
  Plan plan;
  plan.width = width;
  plan.height = height;
  plan.walls = world::walls_around(width, height);
  for (world::Wall& wall : plan.walls) wall.thickness = world::Wall::kFileThickness;
  return plan;
}

world::WorldModel ground_of(const Plan& plan, bool letters) {
  world::WorldModel ground;
  ground.width = plan.width;
  ground.height = plan.height;
  ground.walls = plan.walls;
  ground.floor_texture = plan.texture;
  ground.water = plan.water;
  ground.starts = plan.starts;
  if (!letters) {
    for (world::StartPose& start : ground.starts) start.letter = 0;
  }
  return ground;
}

files::SimFile sim_of(const Plan& plan) {
  files::SimFile sim = plan.rest;
  sim.robots = plan.robots;
  sim.markers = plan.markers;
  for (const Thing& thing : plan.things) {
    if (!thing.is_drawn) sim.objects.push_back(thing.spec);
  }
  return sim;
}

}  // namespace eyebridge::gui
