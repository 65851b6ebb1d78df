#include "eyebridge/episode/batch.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "eyebridge/base/random.hpp"
#include "eyebridge/episode/observer.hpp"
#include "workers.hpp"

namespace eyebridge::episode {
namespace {

constexpr std::size_t kMostWorlds = 1'000'000;

void check(bool good, const char* what) {
  if (!good) throw std::invalid_argument(what);
}

const robot::RobotModel& model_of(const files::Scenario& scenario) {
  check(!scenario.robots.empty(), "found a scenario without robots, expected at least one");
  return scenario.models.at(scenario.robots.front().model);
}

void check(const std::vector<std::shared_ptr<const files::Scenario>>& scenarios,
           const BatchSettings& settings) {
  check(!scenarios.empty(), "found no scenario, expected at least one");
  check(settings.worlds >= 1 && settings.worlds <= kMostWorlds,
        "the number of worlds must be 1 ... 1000000");
  // Written so that NaN fails, too.
  check(settings.period > 0 && settings.period <= 1e6, "the period must be above 0, at most 1e6 s");
  check(settings.time_limit > 0, "the time limit must be above 0");
  check(settings.action != Action::Wheels ||
            model_of(*scenarios.front()).drive.facts().has_two_wheels,
        "found actions for a left and a right motor, expected a robot with a differential drive");
  for (const auto& scenario : scenarios) {
    check(model_of(*scenario) == model_of(*scenarios.front()),
          "found robots of different kinds, expected the same robot in every world");
  }
}

}  // namespace

struct EpisodeBatch::Impl {
  /// One world, and what the last step of its episode came to.
  struct World {
    std::unique_ptr<Episode> episode;
    std::uint64_t first_seed = 0;
    std::uint64_t episodes = 0;  ///< Begun since reset_all().
  };

  Impl(const std::vector<std::shared_ptr<const files::Scenario>>& scenarios, BatchSettings given)
      : settings((check(scenarios, given), std::move(given))),
        model(model_of(*scenarios.front())),
        observer(settings.observation, model),
        workers(settings.threads) {
    const std::size_t count = settings.worlds;
    rows = {std::vector<double>(count * observer.size()),
            std::vector<double>(count),
            std::vector<std::uint8_t>(count),
            std::vector<std::uint8_t>(count),
            std::vector<double>(count * 3),
            std::vector<double>(count),
            std::vector<std::uint64_t>(count),
            std::vector<double>(count),
            std::vector<std::uint64_t>(count)};
    for (std::size_t i = 0; i < count; ++i) {
      auto episode = std::make_unique<Episode>(scenarios[i % scenarios.size()], settings.simulation,
                                               settings.start);
      worlds.push_back({std::move(episode)});
    }
  }

  void begin_next(std::size_t i) {
    World& world = worlds[i];
    // The first episode has the seed that was asked for.
    const std::uint64_t seed =
        world.episodes == 0 ? world.first_seed : Random(world.first_seed, world.episodes).bits();
    ++world.episodes;
    world.episode->reset(seed);
    rows.seeds[i] = seed;
    rows.rewards[i] = 0;
    rows.terminated[i] = rows.truncated[i] = 0;
    rows.distances[i] = 0;
    rows.collisions[i] = 0;
    look(i);
  }

  void advance(std::size_t i, double first, double second) {
    Episode& episode = *worlds[i].episode;
    robot::Simulation& simulation = episode.simulation();
    if (settings.action == Action::Speed) {
      simulation.set_speed(0, {first, second});
    } else {
      simulation.set_motor_duty(0, 0, first);
      simulation.set_motor_duty(0, 1, second);
    }
    const double distance = episode.tally().distance(0);
    const std::uint64_t collisions = episode.tally().collisions(0);
    const double reward = episode.total_reward();
    const auto collided = [=](const Episode& e) { return e.tally().collisions(0) > collisions; };
    const bool over = episode.step_until(terminated ? terminated : collided, settings.period);
    rows.distances[i] = episode.tally().distance(0) - distance;
    rows.collisions[i] = episode.tally().collisions(0) - collisions;
    rows.rewards[i] = rewarded ? episode.total_reward() - reward : rows.distances[i];
    rows.terminated[i] = over ? 1 : 0;
    // To the nearest step, so that rounding of the sum adds none.
    const bool late = episode.time() > settings.time_limit - settings.simulation.step / 2;
    rows.truncated[i] = !over && late ? 1 : 0;
    look(i);
  }

  /// Observation, place and time of world `i`.
  void look(std::size_t i) {
    Episode& episode = *worlds[i].episode;
    const std::span<double> all(rows.observations);
    observer.read(episode.simulation(), 0, all.subspan(i * observer.size(), observer.size()));
    const Pose pose = episode.simulation().pose(0);
    rows.poses[3 * i] = pose.x;
    rows.poses[3 * i + 1] = pose.y;
    rows.poses[3 * i + 2] = pose.theta;
    rows.times[i] = episode.time();
  }

  const BatchSettings settings;
  const robot::RobotModel model;
  const Observer observer;
  std::vector<World> worlds;
  BatchRows rows;
  Episode::Condition terminated;
  bool rewarded = false;
  Workers workers;
};

EpisodeBatch::EpisodeBatch(const std::vector<std::shared_ptr<const files::Scenario>>& scenarios,
                           BatchSettings settings)
    : impl_(std::make_unique<Impl>(scenarios, std::move(settings))) {
  reset_all(1);
}
EpisodeBatch::~EpisodeBatch() = default;

void EpisodeBatch::set_reward(const Episode::Reward& reward) {
  impl_->rewarded = static_cast<bool>(reward);
  for (Impl::World& world : impl_->worlds) world.episode->set_reward(reward);
}

void EpisodeBatch::set_terminated(Episode::Condition terminated) {
  impl_->terminated = std::move(terminated);
}

void EpisodeBatch::reset_all(std::uint64_t first) {
  impl_->workers.for_each(impl_->worlds.size(), [&](std::size_t i) {
    impl_->worlds[i].first_seed = first + i;
    impl_->worlds[i].episodes = 0;
    impl_->begin_next(i);
  });
}

void EpisodeBatch::reset(std::span<const std::uint8_t> which) {
  check(which.size() == impl_->worlds.size(), "expected one mark a world");
  impl_->workers.for_each(impl_->worlds.size(), [&](std::size_t i) {
    if (which[i] != 0) impl_->begin_next(i);
  });
}

void EpisodeBatch::step(std::span<const double> actions, std::span<const std::uint8_t> resets) {
  check(actions.size() == 2 * impl_->worlds.size(), "expected two numbers of action a world");
  check(resets.size() == impl_->worlds.size(), "expected one mark a world");
  check(std::ranges::all_of(actions, [](double value) { return std::isfinite(value); }),
        "found an action that is not finite");
  impl_->workers.for_each(impl_->worlds.size(), [&](std::size_t i) {
    if (resets[i] != 0) {
      impl_->begin_next(i);
    } else {
      impl_->advance(i, actions[2 * i], actions[2 * i + 1]);
    }
  });
}

const BatchRows& EpisodeBatch::rows() const { return impl_->rows; }
const BatchSettings& EpisodeBatch::settings() const { return impl_->settings; }
std::size_t EpisodeBatch::observation_size() const { return impl_->observer.size(); }
const std::vector<double>& EpisodeBatch::observation_low() const { return impl_->observer.low(); }
const std::vector<double>& EpisodeBatch::observation_high() const { return impl_->observer.high(); }

std::pair<double, double> EpisodeBatch::action_high() const {
  if (impl_->settings.action == Action::Wheels) return {1.0, 1.0};
  const robot::DriveModel& drive = impl_->model.drive;
  return {drive.max_linear, drive.max_angular};
}

Episode& EpisodeBatch::episode(std::size_t world) { return *impl_->worlds.at(world).episode; }

}  // namespace eyebridge::episode
