#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace eyebridge::bench {

/// What the robots of a cell sense.
enum class Workload { Psd, Lidar, None };
inline constexpr std::array<std::string_view, 3> kWorkloadNames{"psd", "lidar", "none"};
inline constexpr std::array<std::size_t, 4> kPeerRobots{1, 10, 100, 1000};

/// Robot-steps per CPU second of one peer, for 1, 10, 100 and 1,000 robots.
struct PeerFigures {
  std::string_view peer;
  Workload workload;
  double step;  ///< Seconds.
  std::array<double, 4> rates;
};

/// Measured with the same arena, starts and controller, each peer on one thread of one computer
/// (peers.md of this project's reference data, section 2): not on the one this runs on, see
/// calibration.hpp. Other peers (Flatland, MVSim, IR-SIM) were slower in all cells.
inline constexpr std::array<PeerFigures, 18> kPeers{{
    {"Stage", Workload::Psd, 0.1, {72000, 82251, 62674, 46458}},
    {"Enki", Workload::Psd, 0.1, {11768, 77039, 1.08e5, 30976}},
    {"ARGoS", Workload::Psd, 0.1, {2.77e5, 3.65e5, 1.89e5, 1.14e5}},
    {"Stage", Workload::Psd, 0.01, {1.83e5, 4.24e5, 3.24e5, 2.46e5}},
    {"Enki", Workload::Psd, 0.01, {22288, 1.79e5, 3.89e5, 89485}},
    {"ARGoS", Workload::Psd, 0.01, {3.90e5, 4.81e5, 4.44e5, 5.41e5}},
    {"Stage", Workload::Lidar, 0.1, {6298, 5195, 4500, 2809}},
    {"Enki", Workload::Lidar, 0.1, {10017, 33013, 35112, 15881}},
    {"ARGoS", Workload::Lidar, 0.1, {11213, 10480, 7956, 4008}},
    {"Stage", Workload::Lidar, 0.01, {51383, 48603, 43407, 24364}},
    {"Enki", Workload::Lidar, 0.01, {21840, 1.38e5, 2.07e5, 61709}},
    {"ARGoS", Workload::Lidar, 0.01, {99049, 87404, 72710, 38476}},
    {"Stage", Workload::None, 0.1, {2.05e5, 5.68e5, 2.27e5, 1.66e5}},
    {"Enki", Workload::None, 0.1, {12190, 99754, 2.95e5, 79072}},
    {"ARGoS", Workload::None, 0.1, {5.22e5, 1.32e6, 1.12e6, 5.94e5}},
    {"Stage", Workload::None, 0.01, {2.04e5, 6.18e5, 4.23e5, 3.53e5}},
    {"Enki", Workload::None, 0.01, {22676, 1.88e5, 5.49e5, 1.48e5}},
    {"ARGoS", Workload::None, 0.01, {6.61e5, 1.18e6, 1.16e6, 8.72e5}},
}};

/// The fastest one of a cell; `size` is an index of kPeerRobots.
struct BestPeer {
  std::string_view name;
  double rate = 0.0;  ///< Robot-steps per CPU second.
};
constexpr BestPeer best_peer(Workload workload, double step, std::size_t size) {
  BestPeer best;
  for (const PeerFigures& peer : kPeers) {
    if (peer.workload != workload || peer.step != step || peer.rates[size] <= best.rate) continue;
    best = {peer.peer, peer.rates[size]};
  }
  return best;
}

/// How many times as fast as the best peer we want to be.
constexpr double wanted_ratio(Workload workload) {
  return workload == Workload::Lidar ? 5.0 : 10.0;
}

}  // namespace eyebridge::bench
