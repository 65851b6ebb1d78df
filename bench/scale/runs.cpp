#include "scale/runs.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <malloc.h>

#include "eyebridge/robot/simulation.hpp"
#include "scale/arena.hpp"
#include "scale/calibration.hpp"
#include "scale/wander.hpp"

namespace eyebridge::bench {
namespace {

using robot::RobotIndex;

constexpr double kTick = 0.1;        // seconds between two decisions
constexpr double kLongest = 3600.0;  // seconds that a run simulates, as the peers' did
constexpr double kPsdReach = 4.0;    // metres
constexpr double kLidarReach = 8.0;  // metres
constexpr std::size_t kPsds = 8;
constexpr std::size_t kLidarRays = 360;

/// A disc of 0.2 m that has a commanded speed at once, with its lidar in its centre.
robot::RobotModel model_for(Workload workload, double rim) {
  robot::RobotModel model;
  model.diameter = 0.2;
  model.drive.linear_acceleration = 0.0;
  model.drive.angular_acceleration = 0.0;
  if (workload == Workload::Psd) {
    for (std::size_t i = 0; i < kPsds; ++i) {  // clockwise from behind, as a lidar's rays
      robot::RangeSensorModel psd;
      psd.id = static_cast<int>(i) + 1;
      const double bearing = kPi - 2 * kPi / kPsds * static_cast<double>(i);
      psd.pose_in_robot = {rim * std::cos(bearing), rim * std::sin(bearing), bearing};
      psd.max_range = psd.out_of_range = kPsdReach;
      model.range_sensors.push_back(psd);
    }
  }
  if (workload == Workload::Lidar) {
    model.lidar = robot::LidarModel{};
    model.lidar->max_range = kLidarReach;
  }
  return model;
}

std::size_t bytes_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

class Run {
 public:
  Run(const Cell& cell, const Arena& arena) : cell_(cell), sim_(arena.model, {cell.step, 1, 2.0}) {
    const robot::RobotModel model = model_for(cell.workload, cell.rim);
    const std::size_t before = bytes_in_use();
    for (const Pose& start : arena.starts) {
      controllers_.emplace_back(static_cast<std::uint32_t>(controllers_.size()));
      sim_.add_robot(model, start);
    }
    ranges_.resize(cell.workload == Workload::Lidar ? kLidarRays : kPsds * controllers_.size());
    bytes_ = bytes_in_use() - before;
  }

  void tick() {
    if (cell_.workload == Workload::Psd) sim_.read_all_ranges(ranges_);
    for (RobotIndex robot = 0; robot < controllers_.size(); ++robot) {
      Wander& controller = controllers_[robot];
      sim_.set_speed(robot, cell_.workload == Workload::None ? controller.blind()
                                                             : controller.steer(sense(robot)));
    }
    const int steps = static_cast<int>(std::lround(kTick / cell_.step));
    for (int i = 0; i < steps; ++i) {
      sim_.step();
      if (counts_) add_distances();
    }
    simulated_ += kTick;
  }

  /// From now on distances, ranges and hits are added up, or no more.
  void count(bool on) { counts_ = on; }
  [[nodiscard]] double simulated() const { return simulated_; }
  [[nodiscard]] std::uint64_t hash() const { return sim_.state_hash(); }

  void report(Figures& figures) const {
    const auto robots = static_cast<double>(cell_.robots);
    const double rays = std::max(rays_, 1.0);
    figures.mean_distance = distance_ / robots;
    figures.mean_range = range_sum_ / rays;
    figures.hit_fraction = hits_ / rays;
    figures.bytes_a_robot = static_cast<double>(bytes_) / robots;
  }

 private:
  /// What `robot` measures; valid until the next one is asked for.
  std::span<const double> sense(RobotIndex robot) {
    if (cell_.workload == Workload::Lidar) {
      sim_.read_lidar(robot, 2 * kPi, ranges_);
      add_ranges(ranges_, kLidarReach);
      return ranges_;
    }
    const auto its = std::span(ranges_).subspan(kPsds * std::size_t{robot}, kPsds);
    add_ranges(its, kPsdReach);
    return its;
  }

  void add_ranges(std::span<const double> ranges, double reach) {
    if (!counts_) return;
    for (const double range : ranges) {
      range_sum_ += range;
      hits_ += range < 0.999 * reach ? 1.0 : 0.0;
    }
    rays_ += static_cast<double>(ranges.size());
  }

  void add_distances() {
    for (RobotIndex robot = 0; robot < controllers_.size(); ++robot) {
      distance_ += std::abs(sim_.twist(robot).linear) * cell_.step;
    }
  }

  Cell cell_;
  robot::Simulation sim_;
  std::vector<Wander> controllers_;
  std::vector<double> ranges_;  ///< Of the lidar at hand, or all distance sensors of all robots.
  std::size_t bytes_ = 0;
  double simulated_ = 0.0;
  bool counts_ = false;
  double distance_ = 0.0;
  double range_sum_ = 0.0;
  double hits_ = 0.0;
  double rays_ = 0.0;
};

constexpr double kHalfTick = kTick / 2;  // more than rounding makes of a sum of ticks

/// Robot-steps per CPU second.
double timed(const Cell& cell, const Effort& effort, const Arena& arena) {
  Run run(cell, arena);
  double spent = 0.0;
  const std::size_t ticks_a_look = 1 + 2000 / cell.robots;  // reading the clock is a system call
  const double start = cpu_seconds();
  while (run.simulated() < effort.simulated - kHalfTick ||
         (spent < effort.cpu_seconds && run.simulated() < kLongest - kHalfTick)) {
    for (std::size_t i = 0; i < ticks_a_look; ++i) run.tick();
    spent = cpu_seconds() - start;
  }
  return static_cast<double>(cell.robots) * run.simulated() / cell.step / spent;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

std::vector<Figures> measure(std::span<const Cell> cells, const Effort& effort,
                             const std::filesystem::path& data) {
  struct Place {
    Arena arena;
    Figures figures;
    std::vector<double> rates;
    std::vector<double> per_computer;
  };
  std::vector<Place> places;
  for (const Cell& cell : cells) {
    Place& place = places.emplace_back();
    place.arena = read_arena(data, cell.robots, cell.in_one);
    Run proof(cell, place.arena);
    proof.count(true);
    while (proof.simulated() < effort.simulated - kHalfTick) proof.tick();
    proof.report(place.figures);
    place.figures.hash = proof.hash();
  }
  // The computer's speed changes with what others do on it: it is asked before and after.
  double before = computer_speed();
  for (int i = 0; i < effort.runs; ++i) {
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const double rate = timed(cells[c], effort, places[c].arena);
      const double after = computer_speed();
      const double computer = 0.5 * (before + after);
      places[c].rates.push_back(rate);
      places[c].per_computer.push_back(rate / computer);
      places[c].figures.costs.push_back(computer / rate);
      before = after;
    }
  }
  std::vector<Figures> all;
  for (Place& place : places) {
    place.figures.rate = median(std::move(place.rates));
    place.figures.computer = place.figures.rate / median(std::move(place.per_computer));
    all.push_back(std::move(place.figures));
  }
  return all;
}

double cost_ratio(const Figures& cell, const Figures& other) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < cell.costs.size(); ++i) {
    ratios.push_back(cell.costs[i] / other.costs[i]);
  }
  return median(std::move(ratios));
}

}  // namespace eyebridge::bench
