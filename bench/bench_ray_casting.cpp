#include <ctime>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench_worlds.hpp"
#include "eyebridge/world/ray_caster.hpp"
#include "eyebridge/world/world.hpp"
#include "targets.hpp"

namespace eyebridge {
namespace {

using world::RayCaster;
using world::RayMethod;
using world::WorldModel;

constexpr std::size_t kRays = 360;
constexpr double kMaxRange = 5.0;

std::vector<Vec2> places_in(const WorldModel& model) {
  Random random(7);
  std::vector<Vec2> places(64);
  for (Vec2& p : places) p = {random.uniform() * model.width, random.uniform() * model.height};
  return places;
}

std::vector<Vec2> scan_directions() {
  std::vector<Vec2> directions;
  for (std::size_t i = 0; i < kRays; ++i) {
    directions.push_back(
        Heading::from_angle(2 * kPi * static_cast<double>(i) / kRays + 0.001).forward());
  }
  return directions;
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Rays per CPU second by brute force, measured now: the baseline of the same run.
double brute_force_rate(const WorldModel& model) {
  const RayCaster caster(model, RayMethod::BruteForce);
  const std::vector<Vec2> directions = scan_directions();
  const std::vector<Vec2> places = places_in(model);
  std::vector<double> ranges(kRays);
  const double start = cpu_seconds();
  double spent = 0.0;
  std::size_t scans = 0;
  while (spent < 0.2) {
    caster.cast_fan(places[scans % places.size()], directions, kMaxRange, ranges);
    benchmark::DoNotOptimize(ranges.data());
    ++scans;
    spent = cpu_seconds() - start;
  }
  return static_cast<double>(scans * kRays) / spent;
}

void cast(benchmark::State& state, const WorldModel& model, RayMethod method) {
  const double baseline = brute_force_rate(model);
  const RayCaster caster(model, method);
  const std::vector<Vec2> directions = scan_directions();
  const std::vector<Vec2> places = places_in(model);
  std::vector<double> ranges(kRays);
  std::size_t scans = 0;
  const double start = cpu_seconds();
  for (auto _ : state) {
    caster.cast_fan(places[scans++ % places.size()], directions, kMaxRange, ranges);
    benchmark::DoNotOptimize(ranges.data());
  }
  const double rate = static_cast<double>(scans * kRays) / (cpu_seconds() - start);
  state.counters["walls"] = static_cast<double>(model.walls.size());
  const std::size_t walls = model.walls.size();
  if (method == RayMethod::Grid && model.maze && walls < 1000) {
    bench::at_least(state, "Mray/s", rate / 1e6, 50);
  } else {
    state.counters["Mray/s"] = rate / 1e6;
  }
  state.counters["brute_Mray/s"] = baseline / 1e6;
  if (method == RayMethod::Grid && walls > 1000) {
    bench::at_least(state, "x_brute", rate / baseline, 100);
  } else {
    state.counters["x_brute"] = rate / baseline;
  }
}

void register_all(const char* scene, WorldModel (*make)(int), bool maze) {
  struct Row {
    const char* name;
    RayMethod method;
  };
  constexpr Row kRows[] = {{"BruteForce", RayMethod::BruteForce},
                           {"Grid", RayMethod::Grid},
                           {"EdgeBits", RayMethod::EdgeBits}};
  for (const Row& row : kRows) {
    if (row.method == RayMethod::EdgeBits && !maze) continue;
    for (const int walls : {100, 400, 2000}) {
      const std::string name = std::string(scene) + "/" + row.name + "/" + std::to_string(walls);
      benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        try {
          cast(state, make(walls), row.method);
        } catch (const std::invalid_argument& error) {
          state.SkipWithError(error.what());
        }
      });
    }
  }
}

/// `count` boxes of 0.1 x 0.1 m in the reach of a LIDAR, or walls where their sides are.
WorldModel boxes(int count, bool as_walls) {
  WorldModel model;
  model.width = model.height = 8.0;
  Random random(8);
  for (int i = 0; i < count; ++i) {
    world::ObjectSpec box;
    box.kind = world::ObjectKind::Box;
    box.size = {0.1, 0.1};
    box.pose = {8.0 * random.uniform(), 8.0 * random.uniform(), kPi * random.uniform()};
    if (!as_walls) {
      model.objects.push_back(box);
      continue;
    }
    const Heading heading = Heading::from_angle(box.pose.theta);
    const Vec2 corners[] = {{0.05, 0.05}, {-0.05, 0.05}, {-0.05, -0.05}, {0.05, -0.05}};
    for (std::size_t k = 0; k < 4; ++k) {
      world::Wall wall;
      wall.a = box.pose.position() + heading.rotate(corners[k]);
      wall.b = box.pose.position() + heading.rotate(corners[(k + 1) % 4]);
      model.walls.push_back(wall);
    }
  }
  return model;
}

/// Nanoseconds a ray of scans with 360 rays, or of single ones.
double lidar_ns(const world::World& world, bool single, std::size_t rounds) {
  const std::vector<Vec2> directions = scan_directions();
  const std::vector<Vec2> places = places_in(world.model());
  std::vector<double> ranges(kRays);
  const double start = cpu_seconds();
  for (std::size_t i = 0; i < rounds; ++i) {
    const Vec2 origin = places[i % places.size()];
    if (single) {
      for (std::size_t k = 0; k < kRays; ++k) {
        ranges[k] = world.cast_ray(origin, directions[k], 8.0, world::kNoBody);
      }
    } else {
      world.cast_sweep(origin, directions, 2 * kPi / kRays, 8.0, world::kNoBody, ranges);
    }
    benchmark::DoNotOptimize(ranges.data());
  }
  return (cpu_seconds() - start) * 1e9 / static_cast<double>(rounds * kRays);
}

/// A scan among boxes; `walls_ns`: the same among walls, just before.
void among_boxes(benchmark::State& state, int count) {
  const auto world_of = [&](bool as_walls) {
    return world::World(std::make_shared<const WorldModel>(boxes(count, as_walls)));
  };
  constexpr std::size_t kRounds = 320;
  const double walls = lidar_ns(world_of(true), false, kRounds);
  const world::World world = world_of(false);
  const double among = lidar_ns(world, false, kRounds);
  const double single = lidar_ns(world, true, kRounds);
  for (auto _ : state) lidar_ns(world, false, 1);
  state.counters["ray_ns"] = among;
  state.counters["walls_ns"] = walls;
  bench::at_most(state, "x_walls", among / walls, 2);
  state.counters["single_ns"] = single;
}

/// 40,000 walls of 2 m at one side of a hall of 200 x 200 m, and nothing on the rest of its floor.
WorldModel walls_at_a_side() {
  WorldModel model;
  model.width = model.height = 200.0;
  constexpr Vec2 kCorners[] = {{0, 0}, {200, 0}, {200, 200}, {0, 200}};
  for (std::size_t i = 0; i < 4; ++i) {
    world::Wall wall;
    wall.a = kCorners[i];
    wall.b = kCorners[(i + 1) % 4];
    model.walls.push_back(wall);
  }
  Random random(9);
  for (int i = 0; i < 40'000; ++i) {
    world::Wall wall;
    wall.a = {20.0 * random.uniform(), 200.0 * random.uniform()};
    wall.b = wall.a + 2.0 * Heading::from_angle(2 * kPi * random.uniform()).forward();
    model.walls.push_back(wall);
  }
  return model;
}

/// Rays of 100 m from the middle of the empty part: they meet nothing, or walls from afar.
void long_rays(benchmark::State& state) {
  const RayCaster caster(walls_at_a_side(), RayMethod::Grid);
  const std::vector<Vec2> directions = scan_directions();
  std::vector<double> ranges(kRays);
  const double start = cpu_seconds();
  std::size_t rays = 0;
  for (auto _ : state) {
    caster.cast_fan({90.0, 100.0}, directions, 100.0, ranges);
    benchmark::DoNotOptimize(ranges.data());
    rays += kRays;
  }
  const double each = (cpu_seconds() - start) * 1e9 / static_cast<double>(rays);
  bench::at_most(state, "ray_ns", each, 300);
}
BENCHMARK(long_rays);

const bool kRegistered = [] {
  for (const int count : {10, 100, 1000, 10000}) {
    benchmark::RegisterBenchmark(("Boxes8m/" + std::to_string(count)).c_str(),
                                 [=](benchmark::State& state) { among_boxes(state, count); });
  }
  register_all(
      "Maze", [](int walls) { return bench::perfect_maze(walls); }, true);
  register_all(
      "Open4m", [](int walls) { return bench::open_scene(walls, 4.0); }, false);
  register_all(
      "Open20m", [](int walls) { return bench::open_scene(walls, 20.0); }, false);
  return true;
}();

}  // namespace
}  // namespace eyebridge
