#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "eyebridge/files/scenario.hpp"
#include "eyebridge/robot/simulation.hpp"
#include "eyebridge/robot/tally.hpp"

namespace eyebridge::episode {

/// Where robot 1 stands when an episode begins.
enum class Start {
  Scenario,  ///< Where the scenario says.
  Anywhere,  ///< At a free place, in any direction; which follows from the seed.
};

/// A scenario that is run again and again in this process: from its start, with a seed, until a
/// condition holds; with a reward that a callback gives.
///
///     Episode episode(scenario);
///     episode.set_reward([](const Episode& e) { return e.simulation().twist(0).linear * 0.01; });
///     episode.reset(7);
///     while (!episode.step_until(arrived, 0.1) && episode.time() < 60)
///     steer(episode.simulation());
///
/// Same seed, same commands: same bits, however many episodes there were before. Not thread-safe;
/// several episodes may run on several threads.
class Episode {
 public:
  using Condition = std::function<bool(const Episode&)>;
  using Reward = std::function<double(const Episode&)>;

  /// Begins with the seed of `settings`. Throws std::invalid_argument for settings or robots that
  /// cannot be, and with Start::Anywhere when there is no robot or no room for it.
  explicit Episode(std::shared_ptr<const files::Scenario> scenario,
                   const robot::SimulationSettings& settings = {}, Start start = Start::Scenario);
  ~Episode();
  Episode(const Episode&) = delete;
  Episode& operator=(const Episode&) = delete;

  /// Everything as at the start: time, robots, noise, rewards.
  void reset(std::uint64_t seed);

  /// What one step of the simulation is worth, asked after each of them. Without it: 0.
  void set_reward(Reward reward);

  /// One step of the simulation.
  void step();
  /// Steps until `done` holds, asked after each step, and says whether it does; or for the whole
  /// number of steps next to `seconds`, at least one. A null condition never holds. `seconds`
  /// 0 … 1e9, else std::invalid_argument.
  bool step_until(const Condition& done, double seconds);
  /// step_until() without a condition.
  void run(double seconds) { step_until(nullptr, seconds); }

  /// Give commands to it and read its sensors; it is another object after reset().
  [[nodiscard]] robot::Simulation& simulation() { return *simulation_; }
  [[nodiscard]] const robot::Simulation& simulation() const { return *simulation_; }
  [[nodiscard]] const files::Scenario& scenario() const { return *scenario_; }
  [[nodiscard]] double time() const { return simulation_->time(); }  ///< Seconds since reset().
  /// Sum of the rewards since reset().
  [[nodiscard]] double total_reward() const { return total_reward_; }
  /// Ways driven and collisions since reset().
  [[nodiscard]] const robot::Tally& tally() const { return tally_; }

 private:
  void begin();

  const std::shared_ptr<const files::Scenario> scenario_;
  const std::shared_ptr<const world::WorldModel> model_;
  const Start start_;
  robot::SimulationSettings settings_;
  std::optional<robot::Simulation> simulation_;
  robot::Tally tally_;
  Reward reward_;
  double total_reward_ = 0.0;
};

}  // namespace eyebridge::episode
