#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "eyebridge/episode/episode.hpp"

namespace eyebridge::episode {

/// What a row of actions means; both numbers are cut to what the robot can do.
enum class Action {
  Speed,   ///< Linear and angular speed, m/s and rad/s.
  Wheels,  ///< Duty of the left and the right motor, -1 ... 1.
};

struct BatchSettings {
  std::size_t worlds = 1;                  ///< How many episodes run side by side; 1 ... 1e6.
  robot::SimulationSettings simulation{};  ///< Its seed is not used: see reset_all().
  double period = 0.1;                     ///< Between two actions, seconds.
  double time_limit = 60.0;                ///< An episode is truncated after so many seconds.
  std::string observation = "psd speed";   ///< Words of an Observer.
  Action action = Action::Speed;
  Start start = Start::Scenario;
  unsigned threads = 0;  ///< 0: as many as there are cores.
};

/// What became of the last step or reset, one row a world. Vectors keep their size and place.
struct BatchRows {
  std::vector<double> observations;  ///< worlds x observation size.
  std::vector<double> rewards;
  std::vector<std::uint8_t> terminated;   ///< 1 where the condition holds.
  std::vector<std::uint8_t> truncated;    ///< 1 where the time limit is reached.
  std::vector<double> poses;              ///< worlds x 3: x, y, theta in the world.
  std::vector<double> distances;          ///< Driven in the last step, metres, >= 0.
  std::vector<std::uint64_t> collisions;  ///< In the last step.
  std::vector<double> times;              ///< Seconds since the episode began.
  std::vector<std::uint64_t> seeds;       ///< Of the episode.
};

/// Episodes of one kind of robot side by side, for training: actions in, rows out. Robot 1 of each
/// world acts; others stand.
///
/// Worlds are stepped on several threads, and give the same bits whatever their number. Calls come
/// from one thread at a time.
class EpisodeBatch {
 public:
  /// World i runs scenarios[i % scenarios.size()]. Throws std::invalid_argument for settings,
  /// scenarios or observations that cannot be, and for robots of different kinds. All worlds have
  /// begun as by reset_all(1).
  EpisodeBatch(const std::vector<std::shared_ptr<const files::Scenario>>& scenarios,
               BatchSettings settings);
  ~EpisodeBatch();

  /// What a step of the simulation is worth; without it the way driven in it, metres. Called on
  /// several threads at once.
  void set_reward(const Episode::Reward& reward);
  /// When an episode has come to its end, asked after every step of the simulation; without it a
  /// collision of robot 1 is the end. Called on several threads at once.
  void set_terminated(Episode::Condition terminated);

  /// Begins anew in all worlds: world i with the seed `first` + i.
  void reset_all(std::uint64_t first);
  /// Begins the next episode in the worlds where `which` is not 0, each with the next seed of its
  /// world's own sequence. Other rows stay.
  void reset(std::span<const std::uint8_t> which);
  /// Advances by one period with `actions`, two finite numbers a world, or begins the next episode
  /// where `resets` is not 0 (reward 0, the action is not used). An episode that ends within the
  /// period stops there. Throws std::invalid_argument for spans of another size.
  void step(std::span<const double> actions, std::span<const std::uint8_t> resets);

  [[nodiscard]] const BatchRows& rows() const;
  [[nodiscard]] const BatchSettings& settings() const;
  [[nodiscard]] std::size_t observation_size() const;
  [[nodiscard]] const std::vector<double>& observation_low() const;
  [[nodiscard]] const std::vector<double>& observation_high() const;
  /// Greatest value of the two numbers of an action; the least is minus that.
  [[nodiscard]] std::pair<double, double> action_high() const;
  /// A world's episode, to look at or to change between two calls.
  [[nodiscard]] Episode& episode(std::size_t world);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace eyebridge::episode
