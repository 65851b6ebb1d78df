#include <cmath>
#include <ctime>
#include <functional>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "eyebridge/base/random.hpp"
#include "eyebridge/planning/astar.hpp"
#include "eyebridge/planning/clearance.hpp"
#include "eyebridge/planning/dstar_lite.hpp"
#include "eyebridge/planning/rrt_star.hpp"
#include "eyebridge/planning/theta_star.hpp"
#include "eyebridge/planning/wavefront.hpp"
#include "targets.hpp"

namespace eyebridge::planning {
namespace {

using mapping::Cell;

constexpr int kSide = 1000;
const mapping::GridGeometry kGrid{{0, 0}, 0.05, kSide, kSide};

/// Each cell blocked with probability 0.3, but for the corners that the path joins.
BlockedRaster random_obstacles() {
  Random random(11);
  BlockedRaster blocked(kGrid);
  for (std::uint8_t& cell : blocked.cells) cell = random.chance(0.3) ? 1 : 0;
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) {
      blocked[{i, k}] = 0;
      blocked[{kSide - 1 - i, kSide - 1 - k}] = 0;
    }
  }
  return blocked;
}

/// Corridors and walls one cell wide, one way between any two places.
BlockedRaster maze() {
  constexpr int kRooms = kSide / 2;
  Random random(12);
  BlockedRaster blocked(kGrid, 1);
  const auto open = [&](Cell at) -> std::uint8_t& { return blocked[at]; };
  std::vector<Cell> way{{0, 0}};
  open({0, 0}) = 0;
  while (!way.empty()) {
    const Cell at = way.back();
    Cell ways[4];
    std::uint64_t count = 0;
    for (const Cell step : {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}}) {
      const Cell to{at.column + 2 * step.column, at.row + 2 * step.row};
      if (to.column < 0 || to.row < 0 || to.column >= 2 * kRooms || to.row >= 2 * kRooms) continue;
      if (open(to) != 0) ways[count++] = to;
    }
    if (count == 0) {
      way.pop_back();
      continue;
    }
    const Cell to = ways[random.bits() % count];
    open({(at.column + to.column) / 2, (at.row + to.row) / 2}) = 0;
    open(to) = 0;
    way.push_back(to);
  }
  return blocked;
}

BlockedRaster empty_floor() { return BlockedRaster(kGrid); }

const Vec2 kStart = kGrid.centre_of({0, 0});

/// The far corner, or the last room of the maze.
Vec2 goal_in(const BlockedRaster& blocked) {
  const Cell corner{kSide - 1, kSide - 1};
  return kGrid.centre_of(blocked[corner] == 0 ? corner : Cell{kSide - 2, kSide - 2});
}

/// As one writes it without thinking of speed: a heap of pairs, each cell's cost a double.
double plain_dijkstra(const BlockedRaster& blocked, Cell start, Cell goal) {
  std::vector<double> costs(kGrid.size(), 1e300);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  costs[kGrid.index_of(start)] = 0.0;
  queue.push({0.0, kGrid.index_of(start)});
  const auto free = [&](Cell cell) { return kGrid.contains(cell) && blocked[cell] == 0; };
  while (!queue.empty()) {
    const auto [cost, index] = queue.top();
    queue.pop();
    if (cost > costs[index]) continue;
    const Cell at{static_cast<int>(index % kSide), static_cast<int>(index / kSide)};
    if (at == goal) return cost;
    for (int up = -1; up <= 1; ++up) {
      for (int right = -1; right <= 1; ++right) {
        const Cell to{at.column + right, at.row + up};
        if (!free(to) || !free({to.column, at.row}) || !free({at.column, to.row})) continue;
        const double reached = cost + (right != 0 && up != 0 ? std::sqrt(2.0) : 1.0);
        if (reached >= costs[kGrid.index_of(to)]) continue;
        costs[kGrid.index_of(to)] = reached;
        queue.push({reached, kGrid.index_of(to)});
      }
    }
  }
  return 0.0;
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

template <class Work>
double milliseconds_of(int times, const Work& work) {
  const double begin = cpu_seconds();
  for (int i = 0; i < times; ++i) work();
  return 1e3 * (cpu_seconds() - begin) / times;
}

/// Writes what a planner found and how it compares with plain Dijkstra, measured just now.
/// Of a planner that searches from the goal, from there too: in a maze the two ways round flood
/// different parts.
void compare(benchmark::State& state, const BlockedRaster& blocked, const Planned& path,
             double spent_ms, bool from_goal) {
  if (!path) return state.SkipWithError(to_text(path.error()));
  const Cell goal = kGrid.cell_at(goal_in(blocked));
  double shortest = 0.0;
  const double baseline_ms = milliseconds_of(3, [&] {
    shortest =
        from_goal ? plain_dijkstra(blocked, goal, {0, 0}) : plain_dijkstra(blocked, {0, 0}, goal);
  });
  state.counters["expanded"] = static_cast<double>(path->expanded);
  state.counters["length_m"] = path->length;
  state.counters["x_shortest"] = path->length / (shortest * kGrid.resolution);
  state.counters["dijkstra_ms"] = baseline_ms;
  const double ratio = baseline_ms / spent_ms;
  if (path->length < shortest * kGrid.resolution * (1 - 1e-9)) {
    state.counters["x_dijkstra"] = ratio;  // any angle: another problem than Dijkstra's
  } else {
    bench::at_least(state, "x_dijkstra", ratio, 1);
  }
}

using Planner = Planned (*)(const BlockedRaster&, Vec2, Vec2);

void plan(benchmark::State& state, const BlockedRaster& blocked, Planner planner, bool from_goal) {
  const Vec2 goal = goal_in(blocked);
  Planned path = tl::unexpected(NoPath::Unreachable);
  const double begin = cpu_seconds();
  for (auto _ : state) {
    path = planner(blocked, kStart, goal);
    benchmark::DoNotOptimize(path);
  }
  const double spent = cpu_seconds() - begin;
  compare(state, blocked, path, 1e3 * spent / static_cast<double>(state.iterations()), from_goal);
}

/// RRT* with what a step is on a floor of 50 m.
Planned sampled(const BlockedRaster& blocked, Vec2 start, Vec2 goal) {
  Random random(13);
  RrtStarSettings settings;
  settings.step = 2.0;
  settings.samples = 10000;
  return rrt_star(blocked, start, goal, random, settings);
}

/// Flooded from the goal, and down from the start.
Planned flooded(const BlockedRaster& blocked, Vec2 start, Vec2 goal) {
  return path_down(blocked, wavefront(blocked, {&goal, 1}), start);
}

Planned from_scratch(const BlockedRaster& blocked, Vec2 start, Vec2 goal) {
  return DStarLite(blocked, goal).plan(start);
}

/// A new plan of D* Lite after a wall in the way appeared or went, a tenth of the way from the
/// start.
void replan(benchmark::State& state, const BlockedRaster& blocked) {
  const Vec2 goal = goal_in(blocked);
  DStarLite planner(blocked, goal);
  Planned path = planner.plan(kStart);
  if (!path) return state.SkipWithError(to_text(path.error()));
  bool wall = false;
  const double begin = cpu_seconds();
  for (auto _ : state) {
    wall = !wall;
    for (int i = 80; i < 120; ++i) {
      const Cell cell{i, 200 - i};
      planner.set_blocked(cell, wall || blocked[cell] != 0);
    }
    path = planner.plan(kStart);
    benchmark::DoNotOptimize(path);
  }
  const double spent = cpu_seconds() - begin;
  if (!path) return state.SkipWithError(to_text(path.error()));
  compare(state, planner.blocked(), path, 1e3 * spent / static_cast<double>(state.iterations()),
          true);
}

void clear(benchmark::State& state, const BlockedRaster& blocked) {
  for (auto _ : state) benchmark::DoNotOptimize(clearance_of(blocked));
}

const bool kRegistered = [] {
  struct Scene {
    const char* name;
    BlockedRaster (*make)();
  };
  struct Row {
    const char* name;
    Planner planner;
    bool from_goal = false;
  };
  constexpr Row kRows[] = {{"Astar", astar},
                           {"ThetaStar", theta_star},
                           {"DStarLite", from_scratch, true},
                           {"Wavefront", flooded, true}};
  for (const Scene& scene :
       {Scene{"Random30", random_obstacles}, Scene{"Maze", maze}, Scene{"Empty", empty_floor}}) {
    const auto add = [&](const char* what, auto run) {
      benchmark::RegisterBenchmark((std::string(scene.name) + "/" + what).c_str(),
                                   [=](benchmark::State& state) { run(state, scene.make()); })
          ->Unit(benchmark::kMillisecond);
    };
    for (const Row& row : kRows) {
      add(row.name, [=](benchmark::State& state, const BlockedRaster& blocked) {
        plan(state, blocked, row.planner, row.from_goal);
      });
    }
    // A wall across a maze would close it, and samples hardly ever meet its corridors.
    if (scene.make != maze) add("DStarLiteReplan", replan);
    if (scene.make == empty_floor) {
      add("RrtStar", [](benchmark::State& state, const BlockedRaster& blocked) {
        plan(state, blocked, sampled, false);
      });
    }
    add("Clearance", clear);
  }
  return true;
}();

}  // namespace
}  // namespace eyebridge::planning
