// One run of the work that `./test scale` and `./test peers` measure: bench_scale --help. Prints
// one line: what it cost, and how far robots drove and saw, by which runs of other programs are
// compared.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <malloc.h>
#include <time.h>

#include "eyebridge/robot/simulation.hpp"
#include "scale/arena.hpp"
#include "scale/wander.hpp"

namespace eyebridge::bench {
namespace {

using robot::RobotIndex;

constexpr double kTick = 0.1;        // seconds between two decisions
constexpr double kPsdReach = 4.0;    // metres
constexpr double kLidarReach = 8.0;  // metres
constexpr std::size_t kPsds = 8;
constexpr std::size_t kLidarRays = 360;

struct Work {
  std::string sense = "psd";
  std::size_t robots = 10;
  double step = 0.1;  ///< Of the simulation, seconds; sensing and control are at 10 Hz in any case.
  double seconds = 20.0;      ///< Simulated, and counted in what is printed.
  std::size_t in_one = 1000;  ///< Robots in each place of 40 x 40 m.
  std::size_t empty = 0;      ///< Additional places without robots.
  std::size_t boxes = 0;      ///< In each place, 0.1 x 0.1 m, fixed.
  double rim = 0.0;           ///< Distance sensors look outward from so far off the centre, metres.
  double friction = 0.3;      ///< Of robots against what they touch.
  bool one_by_one = false;  ///< Distance sensors are read alone, as programs do; else all at once.
  std::filesystem::path data = std::filesystem::path(EYEBRIDGE_SHARED_DIR) / "data/scale";
};

/// A disc of 0.2 m that has a commanded speed at once, with its lidar in its centre.
robot::RobotModel model_for(const Work& work) {
  robot::RobotModel model;
  model.diameter = 0.2;
  model.contact_friction = work.friction;
  model.drive.linear_acceleration = 0.0;
  model.drive.angular_acceleration = 0.0;
  for (std::size_t i = 0; work.sense == "psd" && i < kPsds; ++i) {  // clockwise from behind
    robot::RangeSensorModel psd;
    psd.id = static_cast<int>(i) + 1;
    const double bearing = kPi - 2 * kPi / kPsds * static_cast<double>(i);
    psd.pose_in_robot = {work.rim * std::cos(bearing), work.rim * std::sin(bearing), bearing};
    psd.max_range = psd.out_of_range = kPsdReach;
    model.range_sensors.push_back(psd);
  }
  if (work.sense == "lidar") {
    model.lidar = robot::LidarModel{};
    model.lidar->max_range = kLidarReach;
  }
  return model;
}

std::size_t bytes_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

class Run {
 public:
  explicit Run(const Work& work)
      : work_(work),
        arena_(read_arena(work.data, work.robots, work.in_one, work.empty, work.boxes)),
        sim_(arena_.model, {work.step, 1, 2.0}) {
    const robot::RobotModel model = model_for(work);
    const std::size_t before = bytes_in_use();
    for (const Pose& start : arena_.starts) {
      controllers_.emplace_back(static_cast<std::uint32_t>(controllers_.size()));
      sim_.add_robot(model, start);
      places_.push_back(start.position());
    }
    ranges_.resize(work.sense == "lidar" ? kLidarRays : kPsds * controllers_.size());
    bytes_ = bytes_in_use() - before;
  }

  void tick() {
    if (work_.sense == "psd") read_psds();
    for (RobotIndex robot = 0; robot < controllers_.size(); ++robot) {
      Wander& controller = controllers_[robot];
      sim_.set_speed(robot,
                     work_.sense == "none" ? controller.blind() : controller.steer(sense(robot)));
    }
    const int steps = static_cast<int>(std::lround(kTick / work_.step));
    for (int i = 0; i < steps; ++i) sim_.step();
    for (RobotIndex robot = 0; robot < controllers_.size(); ++robot) {
      const Vec2 place = sim_.world().position(sim_.body(robot));
      distance_ += norm(place - places_[robot]);
      places_[robot] = place;
    }
  }

  void report(double spent) const {
    const auto robots = static_cast<double>(work_.robots);
    const double rays = std::max(rays_, 1.0);
    std::printf(
        "cpu_s=%.6f distance_m=%.4f range_m=%.4f hits=%.4f bytes=%.0f walls=%zu hash=%016llx\n",
        spent, distance_ / robots, range_sum_ / rays, hits_ / rays,
        static_cast<double>(bytes_) / robots, arena_.model->walls.size(),
        static_cast<unsigned long long>(sim_.state_hash()));
  }

 private:
  void read_psds() {
    if (!work_.one_by_one) {
      sim_.read_all_ranges(ranges_);
      return;
    }
    for (RobotIndex robot = 0; robot < controllers_.size(); ++robot) {
      for (std::size_t i = 0; i < kPsds; ++i) {
        ranges_[kPsds * robot + i] = sim_.read_range(robot, i);
      }
    }
  }

  /// What `robot` measures; valid until the next one is asked for.
  std::span<const double> sense(RobotIndex robot) {
    const bool lidar = work_.sense == "lidar";
    if (lidar) sim_.read_lidar(robot, 2 * kPi, ranges_);
    const auto its = lidar ? std::span<const double>(ranges_)
                           : std::span<const double>(ranges_).subspan(kPsds * robot, kPsds);
    const double reach = lidar ? kLidarReach : kPsdReach;
    for (const double range : its) {
      range_sum_ += range;
      hits_ += range < 0.999 * reach ? 1.0 : 0.0;
    }
    rays_ += static_cast<double>(its.size());
    return its;
  }

  Work work_;
  Arena arena_;
  robot::Simulation sim_;
  std::vector<Wander> controllers_;
  std::vector<Vec2> places_;    ///< Where the robots were a tick ago.
  std::vector<double> ranges_;  ///< Of the lidar at hand, or all distance sensors of all robots.
  std::size_t bytes_ = 0;
  double distance_ = 0.0;
  double range_sum_ = 0.0;
  double hits_ = 0.0;
  double rays_ = 0.0;
};

int run(int argc, char** argv) {
  Work work;
  CLI::App app("One run of the work that ./test scale and ./test peers measure.");
  app.add_option("--sense", work.sense)->check(CLI::IsMember({"psd", "lidar", "none"}));
  app.add_option("--robots", work.robots)->check(CLI::PositiveNumber);
  app.add_option("--step", work.step, "seconds")->check(CLI::PositiveNumber);
  app.add_option("--seconds", work.seconds, "simulated")->check(CLI::PositiveNumber);
  app.add_option("--in-one", work.in_one, "robots in each place of 40 x 40 m")
      ->check(CLI::PositiveNumber);
  app.add_option("--empty", work.empty, "additional places without robots");
  app.add_option("--boxes", work.boxes, "fixed ones in each place");
  app.add_option("--rim", work.rim, "metres from the centre to where distance sensors sit");
  app.add_option("--friction", work.friction, "against what robots touch");
  app.add_flag("--one-by-one", work.one_by_one, "distance sensors are read alone");
  app.add_option("--data", work.data, "the folder of walls.csv and robots.csv");
  CLI11_PARSE(app, argc, argv);
  Run run(work);
  const auto ticks = static_cast<long>(std::lround(work.seconds / kTick));
  const double start = cpu_seconds();
  for (long i = 0; i < ticks; ++i) run.tick();
  run.report(cpu_seconds() - start);
  return 0;
}

}  // namespace
}  // namespace eyebridge::bench

int main(int argc, char** argv) {
  try {
    return eyebridge::bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_scale: %s\n", error.what());
    return 1;
  }
}
