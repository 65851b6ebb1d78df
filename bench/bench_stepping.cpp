#include <memory>

#include <benchmark/benchmark.h>

#include "bench_worlds.hpp"
#include "eyebridge/world/world.hpp"
#include "targets.hpp"

namespace eyebridge {
namespace {

using world::BodyId;
using world::World;
using world::WorldModel;

constexpr double kStep = 0.01;

void place_robots(World& world, const WorldModel& model, int robots) {
  Random random(3);
  constexpr double kRadius = 0.05;
  while (static_cast<int>(world.body_count()) < robots) {
    const Pose pose{random.uniform() * model.width, random.uniform() * model.height,
                    2 * kPi * random.uniform()};
    if (world.is_free(pose.position(), kRadius)) world.add_robot(pose, kRadius, 0.1, {});
  }
}

/// Robots in a maze of 400 walls that drive straight on against whatever stops them, and turn only
/// every hundredth step: nearly all steps end in a contact.
void bumping(benchmark::State& state) {
  const auto model = std::make_shared<const WorldModel>(bench::perfect_maze(400));
  World world(model);
  const int robots = static_cast<int>(state.range(0));
  place_robots(world, *model, robots);
  const world::Arc ahead{{0.005, 0.0}, {}};
  const world::Arc turn{{}, Heading::from_angle(1.1)};
  std::size_t steps = 0;
  std::size_t blocked = 0;
  std::size_t round = 0;
  for (auto _ : state) {
    const world::Arc& arc = ++round % 100 == 0 ? turn : ahead;
    for (BodyId robot = 0; robot < world.body_count(); ++robot) {
      blocked += world.move(robot, arc, kStep).blocked() ? 1 : 0;
    }
    steps += world.body_count();
  }
  bench::at_least(state, "steps/s", {static_cast<double>(steps), benchmark::Counter::kIsRate}, 1e7);
  state.counters["blocked"] = static_cast<double>(blocked) / static_cast<double>(steps);
}
BENCHMARK(bumping)->Arg(1)->Arg(10)->Arg(100)->Arg(1000);

/// Robots that turn away from what they meet: mostly free motion.
void wandering(benchmark::State& state) {
  const auto model = std::make_shared<const WorldModel>(bench::perfect_maze(400));
  World world(model);
  const int robots = static_cast<int>(state.range(0));
  place_robots(world, *model, robots);
  const world::Arc ahead{{0.005, 0.0}, Heading::from_angle(0.002)};
  const world::Arc turn{{}, Heading::from_angle(2.1)};
  std::size_t steps = 0;
  std::size_t blocked = 0;
  for (auto _ : state) {
    for (BodyId robot = 0; robot < world.body_count(); ++robot) {
      if (!world.move(robot, ahead, kStep).blocked()) continue;
      ++blocked;
      world.move(robot, turn, kStep);
    }
    steps += world.body_count();
  }
  bench::at_least(state, "steps/s", {static_cast<double>(steps), benchmark::Counter::kIsRate}, 1e7);
  state.counters["blocked"] = static_cast<double>(blocked) / static_cast<double>(steps);
}
BENCHMARK(wandering)->Arg(1)->Arg(10)->Arg(100)->Arg(1000);

}  // namespace
}  // namespace eyebridge
