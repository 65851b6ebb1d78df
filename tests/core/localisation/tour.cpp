#include "tour.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "eyebridge/mapping/distance_field.hpp"
#include "eyebridge/robot/error_presets.hpp"

namespace eyebridge::localisation::testing {
namespace {

constexpr Vec2 kTour[] = {{0.5, 1.4}, {1.3, 1.6}, {2.1, 1.35}, {2.1, 0.5}, {2.8, 0.5}, {2.9, 1.25},
                          {3.4, 1.5}, {3.3, 2.5}, {3.2, 1.3},  {2.2, 1.3}, {1.9, 2.5}, {1.2, 2.5},
                          {1.3, 1.6}, {0.5, 1.5}, {0.5, 0.5},  {0.5, 0.6}};

bool near(const Pose& a, const Pose& b) {
  return distance(a, b) < 0.10 && turn_between(a, b) < deg_to_rad(15);
}

/// Towards `goal`, turning first: by where the robot really is, so that every tour is the same.
Twist towards(const Pose& pose, Vec2 goal) {
  const Vec2 away = goal - pose.position();
  const double off = wrap_angle(arc_tan2(away.y, away.x) - pose.theta);
  if (std::abs(off) > 0.5) return {0.0, off > 0 ? 1.5 : -1.5};
  return {0.3, 3 * off};
}

}  // namespace

double distance(const Pose& a, const Pose& b) { return norm(a.position() - b.position()); }
double turn_between(const Pose& a, const Pose& b) {
  return std::abs(wrap_angle(a.theta - b.theta));
}

world::WorldModel flat() {
  world::WorldModel model;
  model.width = 4.0;
  model.height = 3.0;
  const Vec2 ends[][2] = {
      {{0, 0}, {4, 0}},         {{4, 0}, {4, 3}},         {{4, 3}, {0, 3}},
      {{0, 3}, {0, 0}},         {{1.5, 0}, {1.5, 1.2}},   {{2.6, 3}, {2.6, 1.6}},
      {{0, 2}, {0.9, 2}},       {{0.9, 2}, {0.9, 2.2}},   {{3.3, 0}, {4, 0.7}},
      {{1.0, 0.3}, {1.5, 0.3}}, {{3.7, 1.9}, {4.0, 1.9}}, {{3.7, 1.9}, {3.7, 2.1}},
  };
  for (const auto& wall : ends) {
    model.walls.emplace_back();
    model.walls.back().a = wall[0];
    model.walls.back().b = wall[1];
  }
  return model;
}

mapping::Raster<std::uint8_t> walls_in(const world::WorldModel& model, double resolution) {
  constexpr double kMargin = 10.5;
  const double border = kMargin * resolution;
  mapping::Raster<std::uint8_t> out(mapping::GridGeometry::covering(
      {-border, -border}, model.width + 2 * border, model.height + 2 * border, resolution));
  for (const world::Wall& wall : model.walls) {
    const double steps = std::ceil(norm(wall.b - wall.a) / (resolution / 8));
    for (double i = 0; i <= steps; ++i) {
      out[out.geometry.cell_at(wall.a + (i / steps) * (wall.b - wall.a))] = 1;
    }
  }
  return out;
}

mapping::Raster<std::uint8_t> room_for(const world::WorldModel& model,
                                       const mapping::Raster<std::uint8_t>& occupied,
                                       double radius) {
  mapping::Raster<std::uint8_t> out(occupied.geometry);
  const mapping::Raster<float> distances = mapping::distance_field(occupied);
  for (int row = 0; row < out.geometry.rows; ++row) {
    for (int column = 0; column < out.geometry.columns; ++column) {
      const Vec2 place = out.geometry.centre_of({column, row});
      const bool inside =
          place.x > 0 && place.y > 0 && place.x < model.width && place.y < model.height;
      out[{column, row}] = inside && distances[{column, row}] >= radius ? 1 : 0;
    }
  }
  return out;
}

robot::RobotModel scanner(const char* preset) {
  robot::RobotModel model;
  model.lidar.emplace();
  model.lidar->points = 180;
  robot::set_errors(model, robot::error_preset(preset).value());
  return model;
}

std::vector<Stop> tour_of(const robot::RobotModel& model, std::uint64_t seed) {
  robot::SimulationSettings settings;
  settings.seed = seed;
  robot::Simulation sim(std::make_shared<const world::WorldModel>(flat()), settings);
  const robot::RobotIndex robot = sim.add_robot(model, {0.5, 0.5, kPi / 2});
  std::vector<double> ranges(static_cast<std::size_t>(model.lidar.value().points));
  std::vector<Stop> stops;
  const auto stop = [&] {
    sim.read_lidar(robot, model.lidar->field_of_view, ranges);
    stops.push_back({sim.pose(robot), sim.odometry(robot),
                     scan_of(ranges, model.lidar->field_of_view, *model.lidar)});
  };
  stop();
  for (const Vec2 goal : kTour) {
    for (int ticks = 0; norm(goal - sim.pose(robot).position()) > 0.03; ++ticks) {
      if (ticks > 6000) throw std::runtime_error("tour: the robot does not get on");
      sim.set_speed(robot, towards(sim.pose(robot), goal));
      sim.step();
      if (!near(sim.odometry(robot), stops.back().odometry)) stop();
    }
  }
  stop();
  return stops;
}

}  // namespace eyebridge::localisation::testing
