// How many robots: the work that peers were measured with, and crowds. See docs/scale.md.

#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scale/runs.hpp"

namespace eyebridge::bench {
namespace {

constexpr double kSteps[] = {0.1, 0.01};

/// A target and what was found, for the closing lines.
struct Verdict {
  int met = 0;
  int asked = 0;

  const char* judge(bool good) {
    ++asked;
    met += good ? 1 : 0;
    return good ? "" : "  MISSED";
  }
};

struct Options {
  std::filesystem::path data = std::filesystem::path(EYEBRIDGE_SHARED_DIR) / "data/scale";
  Effort effort;
  bool peers = true;
  bool crowds = true;
  std::string_view sense;  ///< This row's cells alone; empty: all.
  double step_ms = 0.0;    ///< And with these steps alone; 0: all.
  double robots = 0.0;     ///< And of this size alone; 0: all.
  double rim_mm = 0.0;     ///< Cell::rim.
};

/// A row of cells, from one robot to 1,000, and what the last one's cost by that of ten.
void print_row(Workload workload, double step, const Options& options, Verdict& faster,
               Verdict& flat) {
  std::vector<Cell> cells;
  std::vector<std::size_t> sizes;
  for (std::size_t size = 0; size < kPeerRobots.size(); ++size) {
    if (options.robots > 0.0 && options.robots != static_cast<double>(kPeerRobots[size])) continue;
    cells.push_back({workload, kPeerRobots[size], step, 1000, options.rim_mm / 1000});
    sizes.push_back(size);
  }
  const bool all = cells.size() == kPeerRobots.size();
  // The same work for each, a hundred times as often.
  if (all) cells.push_back({workload, kPeerRobots.back(), step, 10, options.rim_mm / 1000});
  const std::vector<Figures> figures = measure(cells, options.effort, options.data);
  const double wanted = wanted_ratio(workload);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const Cell& cell = cells[i];
    const Figures& f = figures[i];
    const BestPeer best = best_peer(workload, step, sizes[i]);
    const double times = f.rate / (best.rate * f.computer);
    const bool counts = cell.robots >= 10;
    std::printf("%-6s %6zu %11.4g %9.2f %9.4g  %-6s %8.3g %7.2f %7s %7.3f %7.3f %7.4f  %016llx%s\n",
                kWorkloadNames[static_cast<std::size_t>(workload)].data(), cell.robots, f.rate,
                f.computer, f.real_time_factor(cell), best.name.data(), best.rate * f.computer,
                times, counts ? std::to_string(static_cast<int>(wanted)).c_str() : "-",
                f.mean_distance, f.mean_range, f.hit_fraction,
                static_cast<unsigned long long>(f.hash),
                counts ? faster.judge(times >= wanted) : "");
  }
  if (all) {
    static_assert(kPeerRobots[1] == 10 && kPeerRobots[3] == 1000 && kPeerRobots.size() == 4);
    const Figures& ten = figures[1];
    const double ratio = cost_ratio(figures[3], ten);
    std::printf("%-6s a robot-step among 1,000 costs %.2f times that among 10 (wanted 1.50)%s\n",
                "", ratio, flat.judge(ratio <= 1.5));
    std::printf("%-6s and %.2f times where each ten of them have a place of their own\n", "",
                cost_ratio(figures[4], ten));
  }
  std::fflush(stdout);
}

void peers(const Options& options) {
  Verdict faster;
  Verdict flat;
  for (const double step : kSteps) {
    if (options.step_ms > 0.0 && options.step_ms != step * 1000) continue;
    std::printf("\n== Beside the peers, steps of %g ms\n", step * 1000);
    std::printf("%-6s %6s %11s %9s %9s  %-6s %8s %7s %7s %7s %7s %7s  %s\n", "sense", "robots",
                "steps/s", "computer", "real-time", "best", "it, here", "times", "wanted", "dist m",
                "range m", "hits", "hash");
    for (const Workload workload : {Workload::Psd, Workload::Lidar, Workload::None}) {
      if (!options.sense.empty() &&
          options.sense != kWorkloadNames[static_cast<std::size_t>(workload)]) {
        continue;
      }
      print_row(workload, step, options, faster, flat);
    }
  }
  std::printf(
      "\n%d of %d cells are as many times faster as wanted; %d of %d costs a robot stay flat\n",
      faster.met, faster.asked, flat.met, flat.asked);
}

void crowds(const Options& options) {
  std::printf("\n== Crowds, 8 distance sensors at 10 Hz, 1,000 robots to each 40 x 40 m\n");
  std::printf("%6s %8s %11s %9s %9s %9s %9s\n", "robots", "step ms", "steps/s", "real-time",
              "bytes/rob", "range m", "hits");
  for (const std::size_t robots : {std::size_t{10000}, std::size_t{50000}, std::size_t{100000}}) {
    for (const double step : kSteps) {
      if (options.robots > 0.0 && options.robots != static_cast<double>(robots)) continue;
      const Cell cell{Workload::Psd, robots, step};
      Effort effort = options.effort;
      effort.simulated = 4.0;
      effort.runs = 1;
      const Figures f = measure({&cell, 1}, effort, options.data).front();
      const double factor = f.real_time_factor(cell);
      std::printf("%6zu %8g %11.4g %9.2f %9.0f %9.3f %9.4f%s\n", robots, step * 1000, f.rate,
                  factor, f.bytes_a_robot, f.mean_range, f.hit_fraction,
                  robots == 50000 && factor < 1.0 ? "  MISSED" : "");
      std::fflush(stdout);
    }
  }
}

/// True when `argument` is `name` and a number above 0, which goes to `value`.
bool number(std::string_view argument, std::string_view name, double& value) {
  if (!argument.starts_with(name)) return false;
  const std::string_view digits = argument.substr(name.size());
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return error == std::errc{} && end == digits.data() + digits.size() && value > 0.0;
}

int run(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    double runs = 0.0;
    if (number(argument, "--runs=", runs) && runs == std::floor(runs)) {
      options.effort.runs = static_cast<int>(runs);
    } else if (argument.starts_with("--data=")) {
      options.data = argument.substr(7);
    } else if (argument.starts_with("--sense=")) {
      options.sense = argument.substr(8);
    } else if (argument == "--peers-only") {
      options.crowds = false;
    } else if (argument == "--crowds-only") {
      options.peers = false;
    } else if (!number(argument, "--robots=", options.robots) &&
               !number(argument, "--step=", options.step_ms) &&
               !number(argument, "--rim=", options.rim_mm) &&
               !number(argument, "--benchmark_min_time=", options.effort.cpu_seconds)) {
      std::fprintf(
          stderr,
          "bench_scale: unknown argument %s\nusage: bench_scale [--benchmark_min_time=SECONDS] "
          "[--runs=N] [--peers-only|--crowds-only] [--sense=psd|lidar|none] [--robots=N] "
          "[--step=MS] "
          "[--rim=MM] [--data=FOLDER]\n",
          argv[i]);
      return 2;
    }
  }
  if (options.peers) peers(options);
  if (options.crowds) crowds(options);
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
