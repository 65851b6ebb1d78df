#include <ctime>
#include <stdexcept>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench_worlds.hpp"
#include "eyebridge/world/ray_caster.hpp"

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
  state.counters["Mray/s"] = rate / 1e6;
  state.counters["brute_Mray/s"] = baseline / 1e6;
  state.counters["x_brute"] = rate / baseline;
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

const bool kRegistered = [] {
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
