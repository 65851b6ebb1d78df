#include <vector>

#include <benchmark/benchmark.h>

#include "bench_worlds.hpp"
#include "eyebridge/robot/sensor_likelihood.hpp"
#include "eyebridge/robot/simulation.hpp"

namespace eyebridge {
namespace {

using robot::RobotIndex;
using robot::RobotModel;
using robot::Simulation;

RobotModel sensing_robot() {
  RobotModel model;
  model.diameter = 0.10;
  for (const double bearing : {0.0, kPi / 2, -kPi / 2}) {
    robot::RangeSensorModel psd;
    psd.pose_in_robot.theta = bearing;
    model.range_sensors.push_back(psd);
  }
  model.lidar = robot::LidarModel{};
  return model;
}

Simulation maze_with(int robots, const RobotModel& model) {
  const auto maze = std::make_shared<const world::WorldModel>(bench::perfect_maze(400));
  Simulation sim(maze, {});
  Random random(3);
  while (static_cast<int>(sim.robot_count()) < robots) {
    const Pose pose{random.uniform() * maze->width, random.uniform() * maze->height,
                    2 * kPi * random.uniform()};
    if (sim.world().is_free(pose.position(), model.radius())) sim.add_robot(model, pose);
  }
  return sim;
}

/// Robots that turn on the spot and drive on when something stops them.
void wander(Simulation& sim) {
  for (RobotIndex robot = 0; robot < sim.robot_count(); ++robot) {
    if (sim.stalled(robot) != 0) {
      sim.drive(robot, {0.0, 2.1, 5.0});
    } else if (sim.drive_state(robot) == robot::DriveState::Idle) {
      sim.drive(robot, {10.0, 0.5, 0.5});
    }
  }
}

void step_rate(benchmark::State& state, Simulation sim) {
  std::size_t steps = 0;
  for (auto _ : state) {
    if (steps % (10 * sim.robot_count()) == 0) wander(sim);
    sim.step();
    steps += sim.robot_count();
  }
  state.counters["robot-steps/s"] =
      benchmark::Counter(static_cast<double>(steps), benchmark::Counter::kIsRate);
}

/// The whole pipeline, perfect robots.
void pipeline(benchmark::State& state) {
  step_rate(state, maze_with(static_cast<int>(state.range(0)), sensing_robot()));
}
BENCHMARK(pipeline)->Arg(1)->Arg(100);

/// The same with lagging motors and every error of the drive.
void pipeline_with_errors(benchmark::State& state) {
  RobotModel model = sensing_robot();
  model.drive.motor_time_constant = 0.05;
  model.drive_error = {0.05, 0.05, 0.01, -0.01, true};
  step_rate(state, maze_with(static_cast<int>(state.range(0)), model));
}
BENCHMARK(pipeline_with_errors)->Arg(100);

/// The pipeline around the world: robots that turn on the spot for ever, which meets nothing.
void pipeline_without_collision(benchmark::State& state) {
  Simulation sim = maze_with(100, sensing_robot());
  for (RobotIndex robot = 0; robot < sim.robot_count(); ++robot) sim.set_speed(robot, {0.0, 3.0});
  std::size_t steps = 0;
  for (auto _ : state) {
    sim.step();
    steps += sim.robot_count();
  }
  state.counters["robot-steps/s"] =
      benchmark::Counter(static_cast<double>(steps), benchmark::Counter::kIsRate);
}
BENCHMARK(pipeline_without_collision);

void psd_reading(benchmark::State& state) {
  Simulation sim = maze_with(100, sensing_robot());
  RobotIndex robot = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(sim.read_range(robot, 1));
    robot = (robot + 1) % 100;
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(psd_reading);

/// A cone of 30 degrees (31 rays) and its first echo, beside psd_reading's one ray.
void sonar_reading(benchmark::State& state) {
  RobotModel model = sensing_robot();
  for (robot::RangeSensorModel& sensor : model.range_sensors) {
    sensor.kind = robot::RangeKind::Ultrasound;
    sensor.max_range = 4.0;
  }
  Simulation sim = maze_with(100, model);
  RobotIndex robot = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(sim.read_range(robot, 1));
    robot = (robot + 1) % 100;
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(sonar_reading);

/// P(reading | distance) of a PSD with errors, known to a millimetre.
void range_likelihood(benchmark::State& state) {
  robot::RangeSensorModel psd;
  psd.error = {{0.0, 0.003, 0.01}, 0.002};
  double distance = 0.5;
  for (auto _ : state) {
    const robot::RangeReadings readings(psd, distance);
    benchmark::DoNotOptimize(readings.probability(1.0, 0.001));
    distance = distance < 1.5 ? distance + 0.001 : 0.5;
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(range_likelihood);

void lidar_scan(benchmark::State& state) {
  Simulation sim = maze_with(static_cast<int>(state.range(0)), sensing_robot());
  std::vector<double> scan(360);
  RobotIndex robot = 0;
  for (auto _ : state) {
    sim.read_lidar(robot, 2 * kPi, scan);
    benchmark::DoNotOptimize(scan.data());
    robot = (robot + 1) % static_cast<RobotIndex>(state.range(0));
  }
  state.SetItemsProcessed(state.iterations() * 360);
}
BENCHMARK(lidar_scan)->Arg(1)->Arg(100);

}  // namespace
}  // namespace eyebridge
