#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "scale/peers.hpp"

namespace eyebridge::bench {

/// One piece of work.
struct Cell {
  Workload workload = Workload::Psd;
  std::size_t robots = 1;
  double step = 0.1;  ///< Of the simulation, seconds; sensing and control are at 10 Hz in any case.
  std::size_t in_one = 1000;  ///< So many share a place of 40 x 40 m; more get more of them.
  double rim = 0.0;           ///< Distance sensors look outward from so far off the centre, metres.
};

/// How long it is measured.
struct Effort {
  double cpu_seconds = 0.3;  ///< Of each run, at least.
  double simulated = 20.0;   ///< Seconds of each run, at least.
  int runs = 9;              ///< Their median counts.
};

struct Figures {
  double rate = 0.0;           ///< Robot-steps per CPU second, here and now.
  double computer = 0.0;       ///< computer_speed() at the time: `rate` by it is the median, too.
  double mean_distance = 0.0;  ///< Metres a robot drove.
  double mean_range = 0.0;     ///< Metres.
  double hit_fraction = 0.0;   ///< Of the rays: met something within the sensor's reach.
  double bytes_a_robot = 0.0;  ///< Memory that robots, sensors and controllers take.
  std::uint64_t hash = 0;      ///< Simulation::state_hash() after Effort::simulated.
  std::vector<double> costs;   ///< Of a robot-step in each run: CPU seconds by computer_speed().

  /// Simulated seconds per CPU second.
  [[nodiscard]] double real_time_factor(const Cell& cell) const {
    return rate * cell.step / static_cast<double>(cell.robots);
  }
};

/// Does the work, one run of each cell in turn: what else goes on here meets them all. Distances,
/// ranges and hits are those of the first Effort::simulated seconds. Throws std::runtime_error when
/// the arena's files in `data` cannot be read.
std::vector<Figures> measure(std::span<const Cell> cells, const Effort& effort,
                             const std::filesystem::path& data);

/// How many times as much a robot-step costs in one cell as in another that was measured with it:
/// the median of the rounds.
double cost_ratio(const Figures& cell, const Figures& other);

}  // namespace eyebridge::bench
