#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench_worlds.hpp"
#include "eyebridge/mapping/scan_mapper.hpp"
#include "eyebridge/world/ray_caster.hpp"
#include "process_memory.hpp"
#include "targets.hpp"

namespace eyebridge {
namespace {

using mapping::Cell;
using mapping::GridGeometry;

constexpr std::size_t kBeams = 360;
constexpr double kReach = 10.0;
constexpr double kFloor = 20.0;
constexpr double kSigma = 0.005;  // as in the realistic preset
constexpr double kSigmaRelative = 0.01;

struct Scan {
  Vec2 origin;
  std::vector<Vec2> directions;
  std::vector<double> ranges;
};

/// Scans from 64 places of a world that is laid into the middle of the floor, with errors.
std::vector<Scan> scans_in(const world::WorldModel& model) {
  const world::RayCaster caster(model);
  const Vec2 corner{0.5 * (kFloor - model.width), 0.5 * (kFloor - model.height)};
  Random random(7);
  std::vector<Scan> scans(64);
  for (Scan& scan : scans) {
    const Vec2 place{random.uniform() * model.width, random.uniform() * model.height};
    const double first = 2 * kPi * random.uniform();
    for (std::size_t i = 0; i < kBeams; ++i) {
      const double angle = first + 2 * kPi * static_cast<double>(i) / kBeams;
      scan.directions.push_back(Heading::from_angle(angle).forward());
    }
    scan.origin = corner + place;
    scan.ranges.resize(kBeams);
    caster.cast_fan(place, scan.directions, kReach, scan.ranges);
    for (double& range : scan.ranges) {
      if (range >= kReach) continue;
      range += random.gaussian() * (kSigma + kSigmaRelative * range);
      range = std::min(std::max(range, 0.0), kReach);
    }
  }
  return scans;
}

double mean_range(const std::vector<Scan>& scans) {
  double sum = 0.0;
  for (const Scan& scan : scans) {
    for (const double range : scan.ranges) sum += range;
  }
  return sum / static_cast<double>(scans.size() * kBeams);
}

/// The plain way, as in textbooks: probabilities in doubles, Bresenham's line for each beam, and
/// for each cell on it Bayes' rule in log-odds, with the logarithm of what was read taken there.
/// The same cells for the same reasons: free up to the one before the last, which is occupied.
class PlainGrid {
 public:
  explicit PlainGrid(const GridGeometry& geometry)
      : geometry_(geometry), log_odds_(geometry.size(), 0.0) {}

  void insert(const Scan& scan) {
    const Cell from = geometry_.cell_at(scan.origin);
    for (std::size_t i = 0; i < kBeams; ++i) {
      const double range = scan.ranges[i];
      const Cell to = geometry_.cell_at(scan.origin + range * scan.directions[i]);
      const int dx = std::abs(to.column - from.column);
      const int dy = -std::abs(to.row - from.row);
      const int sx = from.column < to.column ? 1 : -1;
      const int sy = from.row < to.row ? 1 : -1;
      int error = dx + dy;
      Cell at = from;
      while (at != to) {
        update(at, crossed_);
        const int twice = 2 * error;
        if (twice >= dy) {
          error += dy;
          at.column += sx;
        }
        if (twice <= dx) {
          error += dx;
          at.row += sy;
        }
      }
      update(to, range < kReach ? met_ : crossed_);
    }
  }
  const double* data() const { return log_odds_.data(); }

 private:
  void update(Cell cell, double probability) {
    if (!geometry_.contains(cell)) return;
    double& value = log_odds_[geometry_.index_of(cell)];
    value += std::log(probability / (1.0 - probability)) - prior_;
    value = std::min(std::max(value, -5.0), 5.0);
  }

  GridGeometry geometry_;
  std::vector<double> log_odds_;
  double prior_ = 0.0;
  // Settings, as they are of a grid: volatile, else the compiler takes the logarithms.
  volatile double crossed_ = 0.35;
  volatile double met_ = 0.85;
};

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double plain_rate(const std::vector<Scan>& scans, const GridGeometry& geometry) {
  PlainGrid grid(geometry);
  const double start = cpu_seconds();
  double spent = 0.0;
  std::size_t count = 0;
  while (spent < 0.3) {
    for (int i = 0; i < 16; ++i) grid.insert(scans[count++ % scans.size()]);
    benchmark::DoNotOptimize(grid.data());
    spent = cpu_seconds() - start;
  }
  return static_cast<double>(count) / spent;
}

void map_scans(benchmark::State& state, const world::WorldModel& model, double resolution) {
  const std::vector<Scan> scans = scans_in(model);
  const GridGeometry geometry = GridGeometry::covering({0, 0}, kFloor, kFloor, resolution);
  const double plain = plain_rate(scans, geometry);
  mapping::BeamModel beam;
  beam.max_range = kReach;
  beam.sigma = kSigma;
  beam.sigma_relative = kSigmaRelative;
  mapping::ScanMapper mapper(beam);
  mapping::OccupancyGrid grid(geometry);
  std::size_t count = 0;
  const double start = cpu_seconds();
  for (auto _ : state) {
    const Scan& scan = scans[count++ % scans.size()];
    const auto done =
        mapper.insert_sweep(grid, scan.origin, scan.directions, 2 * kPi / kBeams, scan.ranges);
    benchmark::DoNotOptimize(done.has_value());
  }
  const double rate = static_cast<double>(count) / (cpu_seconds() - start);
  state.counters["mean_range"] = mean_range(scans);
  if (resolution == 0.05) {
    bench::at_least(state, "scans/s", rate, 20000);
  } else {
    state.counters["scans/s"] = rate;
  }
  state.counters["plain_scans/s"] = plain;
  bench::at_least(state, "x_plain", rate / plain, 5);
}

void maze(benchmark::State& state) {
  map_scans(state, bench::perfect_maze(400, 0.5), 1.0 / static_cast<double>(state.range(0)));
}
void open(benchmark::State& state) {
  map_scans(state, bench::open_scene(480, 16.0), 1.0 / static_cast<double>(state.range(0)));
}

/// Memory of a map of 100 x 100 m with cells of 2 cm (100 MB) after scans of a scene of 16 x 16 m.
void large_map(benchmark::State& state) {
  const std::vector<Scan> scans = scans_in(bench::open_scene(480, 16.0));
  mapping::ScanMapper mapper(mapping::BeamModel{.max_range = kReach, .sigma = kSigma});
  for (auto _ : state) {
    const std::size_t before = testing::resident_bytes();
    mapping::OccupancyGrid grid({{-40.0, -40.0}, 0.02, 5000, 5000});
    for (const Scan& scan : scans) {
      const auto done =
          mapper.insert_sweep(grid, scan.origin, scan.directions, 2 * kPi / kBeams, scan.ranges);
      benchmark::DoNotOptimize(done.has_value());
    }
    const auto taken = static_cast<double>(testing::resident_bytes() - before);
    bench::at_most(state, "MB", 1e-6 * taken, 20);
  }
}
BENCHMARK(large_map);

BENCHMARK(maze)->ArgName("cells_a_metre")->Arg(20)->Arg(100);
BENCHMARK(open)->ArgName("cells_a_metre")->Arg(20)->Arg(100);

}  // namespace
}  // namespace eyebridge
