// main() of the benchmarks: five rounds in mixed order, medians, exit code 1 where a target is
// missed.

#include "targets.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace eyebridge::bench {
namespace {

constexpr std::string_view kLeast = " >=";
constexpr std::string_view kMost = " <=";
constexpr const char* kTime = "ns";
constexpr double kSlack = 1.1;
constexpr std::size_t kRoundsToJudge = 5;

/// Whether a benchmark said that it cannot run, as Google Benchmark 1.7 and 1.9 tell it.
template <class Run>
bool has_failed(const Run& run) {
  if constexpr (requires { run.error_occurred; }) {
    return run.error_occurred;
  } else {
    return static_cast<int>(run.skipped) != 0;
  }
}

/// Shows medians, where there are several rounds, and keeps what the targets are about.
class Judge final : public benchmark::ConsoleReporter {
 public:
  Judge() : ConsoleReporter(OO_None) {}

  void ReportRuns(const std::vector<Run>& runs) override {
    std::vector<Run> shown;
    for (const Run& run : runs) {
      if (has_failed(run)) {
        failed_ = true;
        shown.push_back(run);
      } else if (run.run_type == Run::RT_Aggregate) {
        if (run.aggregate_name == "median") shown.push_back(run);
      } else {
        keep(run);
        if (run.repetitions <= 1) shown.push_back(run);
      }
    }
    if (!shown.empty()) ConsoleReporter::ReportRuns(shown);
  }

  /// Prints what was missed; the exit code.
  int verdict() {
    int missed = 0;
    int judged = 0;
    for (auto& [name, values] : figures_) {
      if (values.size() < kRoundsToJudge) continue;
      ++judged;
      std::ranges::sort(values);
      const double median = values[values.size() / 2];
      const auto [target, least] = targets_[name];
      const bool good = least ? median * kSlack >= target : median <= target * kSlack;
      if (good) continue;
      ++missed;
      std::printf("MISSED: %s is %.4g (%.4g to %.4g), wanted %s %.4g\n", name.c_str(), median,
                  values.front(), values.back(), least ? "at least" : "at most", target);
    }
    if (judged > 0) std::printf("%d of %d targets are met\n", judged - missed, judged);
    return missed > 0 || failed_ ? 1 : 0;
  }

 private:
  struct Target {
    double value = 0.0;
    bool least = false;
  };

  void keep(const Run& run) {
    for (const auto& [counter, target] : run.counters) {
      const std::string_view name = counter;
      const bool least = name.ends_with(kLeast);
      if (!least && !name.ends_with(kMost)) continue;
      const std::string base(name.substr(0, name.size() - kLeast.size()));
      const auto found = run.counters.find(base);
      const double value = found != run.counters.end()
                               ? found->second.value
                               : 1e9 * run.cpu_accumulated_time / double(run.iterations);
      const std::string full = run.run_name.str() + ": " + base;
      figures_[full].push_back(value);
      targets_[full] = {target.value, least};
    }
  }

  std::map<std::string, std::vector<double>> figures_;
  std::map<std::string, Target> targets_;
  bool failed_ = false;
};

}  // namespace

void at_least(benchmark::State& state, const char* name, benchmark::Counter value, double target) {
  state.counters[name] = value;
  state.counters[name + std::string(kLeast)] = target;
}

void at_most(benchmark::State& state, const char* name, benchmark::Counter value, double target) {
  state.counters[name] = value;
  state.counters[name + std::string(kMost)] = target;
}

void time_at_most(benchmark::State& state, double nanoseconds) {
  state.counters[kTime + std::string(kMost)] = nanoseconds;
}

}  // namespace eyebridge::bench

int main(int argc, char** argv) {
  std::vector<char*> words(argv, argv + argc);
  std::string repetitions = "--benchmark_repetitions=5";
  std::string mixed = "--benchmark_enable_random_interleaving=true";
  // The command line comes later and overrides these.
  words.insert(words.begin() + 1, {repetitions.data(), mixed.data()});
  int count = static_cast<int>(words.size());
  benchmark::Initialize(&count, words.data());
  if (benchmark::ReportUnrecognizedArguments(count, words.data())) return 2;
  eyebridge::bench::Judge judge;
  if (benchmark::RunSpecifiedBenchmarks(&judge) == 0) {
    std::fprintf(stderr, "no benchmark has this name\n");
    return 2;
  }
  benchmark::Shutdown();
  return judge.verdict();
}
