#include "placement.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "text.hpp"

namespace eyebridge::files {
namespace {

constexpr double kSlack = 1e-9;  // metres: discs that only touch are free

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double t = std::clamp(dot(p - a, along) / norm_squared(along), 0.0, 1.0);
  return norm(p - (a + t * along));
}

std::string at(Vec2 p) {
  const auto mm = [](double metres) { return write_millimetres(std::round(metres * 1e4) / 1e4); };
  return "(" + mm(p.x) + ", " + mm(p.y) + ") mm";
}

/// Places to try: the centres of a maze's cells, or a raster of at most about 10,000 points.
std::vector<Vec2> candidates(const world::WorldModel& world, double radius) {
  std::vector<Vec2> out;
  const Vec2 middle{world.width / 2, world.height / 2};
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
        if (p.x >= radius && p.y >= radius && p.x <= world.width - radius &&
            p.y <= world.height - radius) {
          out.push_back(p);
        }
      }
    }
  }
  std::stable_sort(out.begin(), out.end(), [&](Vec2 a, Vec2 b) {
    return norm_squared(a - middle) < norm_squared(b - middle);
  });
  return out;
}

}  // namespace

std::optional<std::string> obstacle_at(const Scenario& scenario, Vec2 centre, double radius) {
  for (const world::Wall& wall : scenario.world.walls) {
    if (distance_to_segment(centre, wall.a, wall.b) < radius + wall.thickness / 2 - kSlack) {
      return "the wall from " + at(wall.a) + " to " + at(wall.b);
    }
  }
  for (const world::ObjectSpec& object : scenario.world.objects) {
    if (norm(centre - object.pose.position()) < radius + object.radius - kSlack) {
      return "the " + object.name + " at " + at(object.pose.position());
    }
  }
  for (const RobotPlacement& robot : scenario.robots) {
    const robot::RobotModel& model = scenario.models[robot.model];
    if (norm(centre - robot.pose.position()) < radius + model.radius() - kSlack) {
      return "the " + model.name + " at " + at(robot.pose.position());
    }
  }
  return std::nullopt;
}

std::optional<Vec2> free_place(const Scenario& scenario, double radius) {
  for (const Vec2 place : candidates(scenario.world, radius)) {
    if (!obstacle_at(scenario, place, radius)) return place;
  }
  return std::nullopt;
}

}  // namespace eyebridge::files
