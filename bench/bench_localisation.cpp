// Monte-Carlo localisation: one motion and one scan of 60 beams for 5,000 particles, beside the
// same update done the plain ways. Scan matching on the same floor, beside a search without bounds.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench_worlds.hpp"
#include "eyebridge/localisation/monte_carlo.hpp"
#include "eyebridge/localisation/scan_matcher.hpp"
#include "eyebridge/mapping/distance_field.hpp"
#include "eyebridge/world/ray_caster.hpp"
#include "targets.hpp"

namespace eyebridge {
namespace {

using namespace localisation;

constexpr std::size_t kParticles = 5000;
constexpr std::size_t kBeams = 60;
constexpr double kSide = 20.0;
constexpr double kSigma = 0.05;
constexpr double kMaxRange = 10.0;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// 400 walls on 20 m x 20 m, cells of 5 cm; a robot that goes 5 cm to and fro.
struct Setting {
  world::WorldModel model = bench::open_scene(400, kSide);
  mapping::Raster<std::uint8_t> walls{mapping::GridGeometry::covering({0, 0}, kSide, kSide, 0.05)};
  mapping::Raster<std::uint8_t> free{walls.geometry, 1};
  world::RayCaster caster{model};
  Pose poses[2] = {{9.9, 10, 0.3}, {9.9, 10, 0.3}};
  std::vector<Vec2> directions;  ///< Of the beams, in the robot's frame.
  std::vector<double> ranges[2];
  Scan scans[2];

  Setting() {
    for (const world::Wall& wall : model.walls) {
      for (double i = 0; i <= 100; ++i) {
        const mapping::Cell cell = walls.geometry.cell_at(wall.a + (i / 100) * (wall.b - wall.a));
        if (walls.geometry.contains(cell)) walls[cell] = 1;
      }
    }
    poses[1] = transform(poses[0], {0.05, 0, 0});
    for (std::size_t i = 0; i < kBeams; ++i) {
      directions.push_back(
          Heading::from_angle(2 * kPi * static_cast<double>(i) / kBeams).forward());
    }
    Random random(3);
    for (std::size_t k = 0; k < 2; ++k) {
      ranges[k] = ranges_at(poses[k]);
      for (std::size_t i = 0; i < kBeams; ++i) {
        ranges[k][i] += 0.01 * random.gaussian();
        scans[k].hits.push_back(ranges[k][i] * directions[i]);
      }
    }
  }

  [[nodiscard]] std::vector<double> ranges_at(const Pose& pose) const {
    const Heading heading = Heading::from_angle(pose.theta);
    std::vector<double> out;
    for (const Vec2 direction : directions) {
      out.push_back(caster.cast(pose.position(), heading.rotate(direction), kMaxRange));
    }
    return out;
  }
};

const Setting& setting() {
  static const Setting made;
  return made;
}

/// What the plain ways share: particles that scatter about the robot, libm for all that is not
/// looked up, a new set drawn one by one at every scan.
template <class BeamDensity>
double plain_rate(BeamDensity&& density) {
  const Setting& in = setting();
  std::vector<Pose> particles(kParticles);
  std::vector<double> weights(kParticles);
  Random random(4);
  for (Pose& pose : particles) {
    pose = transform(in.poses[0], {0.1 * random.gaussian(), 0.1 * random.gaussian(), 0});
  }
  const double start = cpu_seconds();
  double spent = 0.0;
  int updates = 0;
  while (spent < 1.0) {
    const std::size_t k = static_cast<std::size_t>(updates + 1) % 2;
    const OdometryStep step = OdometryStep::between(in.poses[1 - k], in.poses[k]);
    double total = 0.0;
    for (std::size_t i = 0; i < kParticles; ++i) {
      particles[i] = sample_motion(particles[i], step, OdometryNoise{}, random);
      double sum = 0.0;
      const Heading heading{std::cos(particles[i].theta), std::sin(particles[i].theta)};
      for (std::size_t b = 0; b < kBeams; ++b) {
        sum += std::log(density(particles[i].position(), heading, k, b));
      }
      total += weights[i] = std::exp(0.2 * sum);
    }
    for (double& weight : weights) weight /= total;
    std::vector<double> reached(kParticles);
    double sum = 0.0;
    for (std::size_t i = 0; i < kParticles; ++i) reached[i] = sum += weights[i];
    std::vector<Pose> drawn;
    for (std::size_t i = 0; i < kParticles; ++i) {
      const auto at = std::lower_bound(reached.begin(), reached.end() - 1, random.uniform());
      drawn.push_back(particles[static_cast<std::size_t>(at - reached.begin())]);
    }
    particles = drawn;
    ++updates;
    spent = cpu_seconds() - start;
  }
  return updates / spent;
}

double mixture(double off) {
  constexpr double kPeak = 0.9 / kSigma * 0.3989422804014327;
  return kPeak * std::exp(-0.5 * off * off / (kSigma * kSigma)) + 0.1 / kMaxRange;
}

/// The distance looked up, the density computed for every beam.
double rate_with_logarithms() {
  const mapping::Raster<float> distances = mapping::distance_field(setting().walls);
  return plain_rate([&](Vec2 place, Heading heading, std::size_t k, std::size_t beam) {
    const mapping::Cell cell =
        distances.geometry.cell_at(place + heading.rotate(setting().scans[k].hits[beam]));
    return distances.geometry.contains(cell) ? mixture(distances[cell]) : 0.1 / kMaxRange;
  });
}

/// Every beam cast from every particle.
double rate_with_rays() {
  return plain_rate([](Vec2 place, Heading heading, std::size_t k, std::size_t beam) {
    const Vec2 direction = heading.rotate(setting().directions[beam]);
    const double range = setting().caster.cast(place, direction, kMaxRange);
    return mixture(range - setting().ranges[k][beam]);
  });
}

void monte_carlo(benchmark::State& state) {
  const Setting& in = setting();
  const double with_logarithms = rate_with_logarithms();
  const double with_rays = rate_with_rays();
  MonteCarloSettings settings;
  settings.least_particles = settings.most_particles = kParticles;
  settings.resample_below = 1.0;  // at every scan, as the plain ways do
  MonteCarlo filter(
      std::make_shared<const LikelihoodField>(in.walls, BeamSettings{kSigma, 0.9, 0.1, kMaxRange}),
      in.free, settings, 5);
  filter.start_at(in.poses[0], 0.1, 0.1);
  std::size_t updates = 0;
  const double start = cpu_seconds();
  for (auto _ : state) {
    const std::size_t k = ++updates % 2;
    filter.predict(in.poses[1 - k], in.poses[k]);
    filter.correct(in.scans[k]);
    benchmark::DoNotOptimize(filter.particles().x.data());
  }
  const double rate = static_cast<double>(updates) / (cpu_seconds() - start);
  const Pose found = filter.estimate().estimate.pose;
  if (norm(found.position() - in.poses[updates % 2].position()) > 0.1) {
    state.SkipWithError("the robot got lost");
  }
  bench::at_least(state, "Hz", rate, 100);
  state.counters["logarithms_Hz"] = with_logarithms;
  state.counters["rays_Hz"] = with_rays;
  state.counters["x_logarithms"] = rate / with_logarithms;
  state.counters["x_rays"] = rate / with_rays;
}
BENCHMARK(monte_carlo)->Name("MonteCarlo/5000x60")->Unit(benchmark::kMillisecond);

/// CPU seconds of one match from 15 cm and 10 degrees off.
double match_seconds(const ScanMatcher& matcher) {
  const Setting& in = setting();
  const Pose guess = transform(in.poses[0], {0.12, -0.09, 0.17});
  const double start = cpu_seconds();
  double spent = 0.0;
  int matches = 0;
  while (spent < 0.5) {
    benchmark::DoNotOptimize(matcher.match(guess, in.scans[0]));
    ++matches;
    spent = cpu_seconds() - start;
  }
  return spent / matches;
}

void scan_matching(benchmark::State& state) {
  const Setting& in = setting();
  MatchSettings every_shift;
  every_shift.block = 1;
  const double plain = match_seconds(ScanMatcher(in.walls, every_shift));
  const ScanMatcher matcher(in.walls, {});
  for (auto _ : state) benchmark::DoNotOptimize(matcher.match(in.poses[0], in.scans[0]));
  state.counters["match_ms"] = 1e3 * match_seconds(matcher);
  state.counters["every_shift_ms"] = 1e3 * plain;
}
BENCHMARK(scan_matching)->Name("ScanMatcher/60")->Unit(benchmark::kMillisecond);

/// What a new map costs: tables of 160,000 cells.
void matcher_made(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(ScanMatcher(setting().walls, {}));
}
BENCHMARK(matcher_made)->Name("ScanMatcher/new")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace eyebridge
