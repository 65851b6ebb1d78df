// Evolves a wall follower with a genetic algorithm.
//
// A population of wall laws drives round a corridor, each in three worlds of its own whose sensors
// and wheels err in another way. The better half of a few becomes parent; children mix their genes
// and change them a little; the best two live on. All worlds are stepped on all cores.
//
// Usage: evolve_wall_follower [GENERATIONS [SEED]]; 12 and 1 by default. It prints what
// evolved_follower needs to drive the same way as a robot program.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numeric>
#include <vector>

#include "course.hpp"
#include "eyebridge/base/random.hpp"
#include "eyebridge/episode/batch.hpp"
#include "eyebridge/files/load.hpp"
#include "wall_law.hpp"

namespace {

using namespace eyebridge;

constexpr std::size_t kPopulation = 24;
constexpr std::size_t kTrials = 3;  // worlds a law
constexpr std::size_t kElite = 2;
constexpr double kTimeLimit = 90.0;  // seconds

struct Individual {
  WallLaw law;
  double fitness = 0;  ///< Share of the course, 0 … 1; finished: 1 … 2, the faster the better.
  std::size_t finished = 0;
};
using Population = std::vector<Individual>;

std::shared_ptr<const files::Scenario> corridor() {
  auto scenario = std::make_shared<files::Scenario>(files::load_scenario("corridor.wld"));
  robot::RobotModel& robot = scenario->models.front();
  for (robot::RangeSensorModel& sensor : robot.range_sensors) sensor.error = {{0, 0.003, 0.01}};
  robot.drive_error.linear_sigma = robot.drive_error.angular_sigma = 0.05;
  return scenario;
}

/// One law in one world.
struct Trial {
  Course course;
  double last_side = 0;
  double score = 0;
  bool over = false;
};

class Trials {
 public:
  Trials() : batch_({corridor()}, settings()), trials_(kPopulation * kTrials) {}

  /// Drives all laws until each trial has ended, and gives them their fitness.
  void judge(Population& population, std::uint64_t seed) {
    batch_.reset_all(seed);
    std::ranges::fill(trials_, Trial{});
    const std::vector<std::uint8_t> no_resets(trials_.size());
    std::vector<double> actions(2 * trials_.size());
    const auto going_on = [](const Trial& trial) { return !trial.over; };
    for (bool first = true; std::ranges::any_of(trials_, going_on); first = false) {
      for (std::size_t i = 0; i < trials_.size(); ++i) {
        const WallLaw::Command command = steer(population[i / kTrials].law, i, first);
        actions[2 * i] = command.linear;
        actions[2 * i + 1] = command.angular;
      }
      batch_.step(actions, no_resets);
      for (std::size_t i = 0; i < trials_.size(); ++i) look(i);
    }
    for (std::size_t i = 0; i < population.size(); ++i) sum_up(population[i], i);
  }

 private:
  static episode::BatchSettings settings() {
    episode::BatchSettings settings;
    settings.worlds = kPopulation * kTrials;
    settings.observation = "psd";
    settings.period = WallLaw::kPeriod;
    settings.time_limit = kTimeLimit;
    return settings;
  }

  WallLaw::Command steer(const WallLaw& law, std::size_t i, bool first) {
    Trial& trial = trials_[i];
    if (trial.over) return {};
    const double* psd = &batch_.rows().observations[i * batch_.observation_size()];
    const double side = psd[2];  // front, left, right, back
    const WallLaw::Command command = law.steer(psd[0], side, first ? side : trial.last_side);
    trial.last_side = side;
    return command;
  }

  /// A trial ends at the end of the course, at a wall or with its time.
  void look(std::size_t i) {
    Trial& trial = trials_[i];
    if (trial.over) return;
    const episode::BatchRows& rows = batch_.rows();
    trial.course.see({rows.poses[3 * i], rows.poses[3 * i + 1]});
    trial.score = trial.course.finished() ? 2 - rows.times[i] / kTimeLimit
                                          : trial.course.progress() / Course::length();
    trial.over = trial.course.finished() || rows.terminated[i] != 0 || rows.truncated[i] != 0;
  }

  void sum_up(Individual& individual, std::size_t index) const {
    individual.fitness = 0;
    individual.finished = 0;
    for (std::size_t i = index * kTrials; i < (index + 1) * kTrials; ++i) {
      individual.fitness += trials_[i].score / kTrials;
      individual.finished += trials_[i].course.finished() ? 1 : 0;
    }
  }

  episode::EpisodeBatch batch_;
  std::vector<Trial> trials_;
};

std::size_t pick(Random& random) {
  return static_cast<std::size_t>(random.uniform() * kPopulation);
}

/// The best of three that chance picks.
const WallLaw& parent(const Population& population, Random& random) {
  const Individual* best = &population[pick(random)];
  for (int i = 0; i < 2; ++i) {
    const Individual& other = population[pick(random)];
    if (other.fitness > best->fitness) best = &other;
  }
  return best->law;
}

WallLaw child_of(const WallLaw& mother, const WallLaw& father, Random& random) {
  WallLaw child;
  for (int gene = 0; gene < WallLaw::kGenes; ++gene) {
    const double low = WallLaw::kLow[gene];
    const double high = WallLaw::kHigh[gene];
    double value = random.chance(0.5) ? mother.genes[gene] : father.genes[gene];
    if (random.chance(0.3)) value += random.gaussian() * 0.15 * (high - low);
    child.genes[gene] = std::clamp(value, low, high);
  }
  return child;
}

Population first_generation(Random& random) {
  Population population(kPopulation);
  for (Individual& individual : population) {
    for (int gene = 0; gene < WallLaw::kGenes; ++gene) {
      const double low = WallLaw::kLow[gene];
      individual.law.genes[gene] = low + random.uniform() * (WallLaw::kHigh[gene] - low);
    }
  }
  return population;
}

/// Of a population in order of fitness.
Population next_generation(const Population& population, Random& random) {
  Population next(population.begin(), population.begin() + kElite);
  while (next.size() < kPopulation) {
    const WallLaw& mother = parent(population, random);
    const WallLaw& father = parent(population, random);
    next.push_back({child_of(mother, father, random)});
  }
  return next;
}

void print_generation(int generation, const Population& population) {
  double sum = 0;
  std::size_t finished = 0;
  for (const Individual& individual : population) {
    sum += individual.fitness;
    finished += individual.finished;
  }
  std::printf("generation %d: best %.3f, mean %.3f, finished %zu of %zu\n", generation,
              population.front().fitness, sum / kPopulation, finished, kPopulation * kTrials);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int generations = argc > 1 ? std::atoi(argv[1]) : 12;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  if (generations < 1) {
    std::fprintf(stderr, "found %s, expected evolve_wall_follower [GENERATIONS [SEED]]\n", argv[1]);
    return 2;
  }
  Random random(seed);
  Trials trials;
  Population population = first_generation(random);
  for (int generation = 1; generation <= generations; ++generation) {
    if (generation > 1) population = next_generation(population, random);
    trials.judge(population, random.bits());
    std::ranges::stable_sort(population, std::ranges::greater(), &Individual::fitness);
    print_generation(generation, population);
  }
  const Individual& best = population.front();
  std::printf("finished its course %zu times of %zu\n", best.finished, kTrials);
  std::printf("evolved_follower");
  for (const double gene : best.law.genes) std::printf(" %.4f", gene);
  std::printf("\n");
  return best.finished == kTrials ? 0 : 1;
}
