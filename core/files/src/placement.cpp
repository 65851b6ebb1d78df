#include "placement.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include "text.hpp"

namespace eyebridge::files {
namespace {

constexpr double kSlack = 1e-9;  // metres

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double t = std::clamp(dot(p - a, along) / norm_squared(along), 0.0, 1.0);
  return norm(p - (a + t * along));
}

std::string at(Vec2 p) {
  const auto mm = [](double metres) { return write_millimetres(std::round(metres * 1e4) / 1e4); };
  return std::string("(").append(mm(p.x)) + ", " + mm(p.y) + ") mm";
}

}  // namespace

std::string in_words(const world::Wall& wall) { return "from " + at(wall.a) + " to " + at(wall.b); }

namespace {

/// Places to try: the centres of a maze's cells, or a raster of at most about 10,000 points.
std::vector<Vec2> candidates(const world::WorldModel& world, double radius) {
  std::vector<Vec2> out;
  const Vec2 middle = world.middle();
  if (world.maze) {
    const double cell = world.maze->cell;
    for (int row = 0; row < world.maze->rows; ++row) {
      for (int column = 0; column < world.maze->columns; ++column) {
        out.push_back({(column + 0.5) * cell, (row + 0.5) * cell});
      }
    }
  } else {
    const double step = std::max(radius, std::sqrt(world.width * world.height / 10000));
    const int across = static_cast<int>(std::min(world.width / 2 / step, 10000.0));
    const int along = static_cast<int>(std::min(world.height / 2 / step, 10000.0));
    for (int j = -along; j <= along; ++j) {
      for (int i = -across; i <= across; ++i) {
        const Vec2 p{middle.x + i * step, middle.y + j * step};
        const Vec2 margin{radius, radius};
        if (world.has_floor_at(p - margin) && world.has_floor_at(p + margin)) out.push_back(p);
      }
    }
  }
  std::stable_sort(out.begin(), out.end(), [&](Vec2 a, Vec2 b) {
    return norm_squared(a - middle) < norm_squared(b - middle);
  });
  return out;
}

}  // namespace

Placer::Placer(Scenario& scenario, Reading reading)
    : scenario_(scenario),
      reading_(reading),
      world_(std::make_shared<const world::WorldModel>(scenario.world)) {
  for (const RobotPlacement& robot : scenario.robots) {
    add(robot.pose.position(), scenario.models.at(robot.model));
  }
}

bool Placer::add(Vec2 centre, const robot::RobotModel& robot, double gap) {
  const double radius = robot.radius();
  if (!world_.is_free(centre, radius + gap - kSlack)) return false;
  try {
    world_.add_robot({centre.x, centre.y, 0}, radius, robot.height, {});
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

const RobotPlacement* Placer::robot_at(Vec2 centre, double radius) const {
  for (const RobotPlacement& robot : scenario_.robots) {
    const double touching = radius + scenario_.models[robot.model].radius();
    if (norm(centre - robot.pose.position()) < touching - kSlack) return &robot;
  }
  return nullptr;
}

std::string Placer::obstacle_at(Vec2 centre, double radius) const {
  if (const RobotPlacement* robot = robot_at(centre, radius)) {
    return "the " + scenario_.models[robot->model].name + " at " + at(robot->pose.position());
  }
  for (const world::ObjectSpec& object : scenario_.world.objects) {
    if (world::rim_distance(object, centre) < radius - kSlack) {
      return "the " + object.name + " at " + at(object.pose.position());
    }
  }
  return wall_at(centre);
}

std::string Placer::wall_at(Vec2 centre) const {
  const world::Wall* nearest = nullptr;
  double least = 0;
  for (const world::Wall& wall : scenario_.world.walls) {
    const double gap = distance_to_segment(centre, wall.a, wall.b) - wall.thickness / 2;
    if (nearest == nullptr || gap < least - kSlack) {
      nearest = &wall;
      least = gap;
    }
  }
  if (nearest == nullptr) return "something";
  return "the wall " + in_words(*nearest);
}

void Placer::warn_outside(std::size_t model, const Pose& pose, const SourceLocation& where) {
  const world::WorldModel& world = scenario_.world;
  if (!world.has_floor_at(pose.position())) {
    scenario_.warnings.push_back(
        {where, scenario_.models[model].name + " stands outside the floor"});
  }
}

void Placer::check_water(std::size_t model, const SourceLocation& where) const {
  const robot::RobotModel& robot = scenario_.models[model];
  const double water = scenario_.world.water_depth();
  if (!robot.drive.facts().dives || robot.height <= water) return;
  throw ConfigError(where, robot.name + " is " + write_millimetres(robot.height) +
                               " mm high, in water of " + write_millimetres(water) +
                               " mm: expected deeper water ('water MM')");
}

void Placer::refuse(std::size_t model, const Pose& pose, const std::string& obstacle,
                    const SourceLocation& where) const {
  throw ConfigError(where, in_the_way(model, pose, obstacle) + ": expected a free place");
}

std::string Placer::in_the_way(std::size_t model, const Pose& pose,
                               const std::string& obstacle) const {
  const robot::RobotModel& robot = scenario_.models[model];
  return robot.name + " (" + write_millimetres(robot.diameter) + " mm across) at " +
         at(pose.position()) + " stands in " + obstacle;
}

std::optional<Vec2> Placer::add_near(Vec2 wanted, const robot::RobotModel& robot) {
  const world::WorldModel& world = scenario_.world;
  const auto try_at = [&](Vec2 p) { return world.has_floor_at(p) && add(p, robot); };
  // Near it in rings, then at the places where robots are put otherwise.
  constexpr double kRing = 0.005;  // metres
  constexpr int kDirections = 36;
  const int rings = static_cast<int>(3 * robot.radius() / kRing);
  for (int ring = 1; ring <= rings; ++ring) {
    for (int i = 0; i < kDirections; ++i) {
      const Vec2 p =
          wanted + ring * kRing * Heading::from_angle(2 * kPi * i / kDirections).forward();
      if (try_at(p)) return p;
    }
  }
  std::vector<Vec2> places = candidates(world, robot.radius());
  std::ranges::stable_sort(places, {}, [&](Vec2 p) { return norm_squared(p - wanted); });
  for (const Vec2 p : places) {
    if (try_at(p)) return p;
  }
  return std::nullopt;
}

void Placer::record(std::size_t model, const Pose& pose, const SourceLocation& where) {
  warn_outside(model, pose, where);
  RobotPlacement placement;
  placement.model = model;
  placement.pose = pose;
  scenario_.robots.push_back(placement);
}

void Placer::place(std::size_t model, const Pose& pose, const SourceLocation& where) {
  check_water(model, where);
  const robot::RobotModel& robot = scenario_.models[model];
  if (add(pose.position(), robot)) return record(model, pose, where);
  const std::string obstacle = obstacle_at(pose.position(), robot.radius());
  if (reading_ == Reading::Strict) refuse(model, pose, obstacle, where);
  const auto free = add_near(pose.position(), robot);
  if (!free) refuse(model, pose, obstacle, where);
  scenario_.warnings.push_back(
      {where, in_the_way(model, pose, obstacle) + ": it is put to " + at(*free)});
  record(model, {free->x, free->y, pose.theta}, where);
}

void Placer::check_walls(std::size_t model, const Pose& pose, const SourceLocation& where) {
  if (!walls_) {
    world::WorldModel bare = scenario_.world;
    bare.objects.clear();
    walls_.emplace(std::make_shared<const world::WorldModel>(std::move(bare)));
  }
  check_water(model, where);
  const double radius = scenario_.models[model].radius();
  if (!walls_->is_free(pose.position(), radius - kSlack)) {
    refuse(model, pose, wall_at(pose.position()), where);
  }
  warn_outside(model, pose, where);
}

void Placer::place_anywhere(std::size_t model, const SourceLocation& where) {
  check_water(model, where);
  const robot::RobotModel& robot = scenario_.models[model];
  for (const Vec2 place : candidates(scenario_.world, robot.radius())) {
    if (add(place, robot)) return record(model, {place.x, place.y, 0}, where);
  }
  throw ConfigError(where, "no free place for " + robot.name + " (" +
                               write_millimetres(robot.diameter) +
                               " mm across): expected room for a robot");
}

std::size_t Placer::place_many(std::size_t model, std::size_t count) {
  const robot::RobotModel& robot = scenario_.models[model];
  std::size_t placed = 0;
  const auto try_at = [&](const Pose& pose, double gap) {
    if (placed == count || !add(pose.position(), robot, gap)) return;
    record(model, pose, {});
    ++placed;
  };
  for (const world::StartPose& start : scenario_.world.starts) try_at(start.pose, 0);
  if (placed == count) return placed;
  const std::vector<Vec2> places = candidates(scenario_.world, robot.radius());
  // Close to each other only where there is no room else: who starts to drive shall not bump.
  for (const double gap : {robot.radius(), robot.radius() / 4, 0.0}) {
    for (const Vec2 place : places) try_at({place.x, place.y, 0}, gap);
  }
  return placed;
}

void Placer::place_at_start(const robot::RobotModel& robot, const SourceLocation& where) {
  scenario_.models.push_back(robot);
  const std::size_t model = scenario_.models.size() - 1;
  if (scenario_.world.starts.empty()) return place_anywhere(model, where);
  place(model, scenario_.world.starts.front().pose, scenario_.start_places.front());
}

}  // namespace eyebridge::files
