#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "eyebridge/episode/episode.hpp"

namespace eyebridge::python {

/// What numpy looks at: one row a robot, rewritten after every call that moves one.
struct StateTable {
  std::vector<double> poses;   ///< x, y, theta.
  std::vector<double> twists;  ///< linear, angular; as driven in the last step.
};

/// A simulation that several threads of a Python program may use, and that can begin again.
///
/// Calls wait for each other. They are made without Python's lock.
class SharedSimulation {
 public:
  /// Throws std::invalid_argument for settings or robots that cannot be.
  SharedSimulation(std::shared_ptr<const files::Scenario> scenario,
                   const robot::SimulationSettings& settings);

  /// `use(simulation)`, alone. Throws std::runtime_error once closed.
  template <class Use>
  auto with(Use&& use) const {
    const std::lock_guard lock(mutex_);
    return std::forward<Use>(use)(opened().simulation());
  }
  /// The same for what moves a robot: the table follows.
  template <class Use>
  auto moving(Use&& use) {
    const std::lock_guard lock(mutex_);
    struct Follow {
      SharedSimulation& shared;
      ~Follow() { shared.write_table(); }
    } follow{*this};
    return std::forward<Use>(use)(opened().simulation());
  }

  /// So many steps. Throws std::runtime_error once closed.
  void advance(long long steps);
  /// What `robot` has driven since the start, metres, and how often it hit something.
  [[nodiscard]] double distance(robot::RobotIndex robot) const;
  [[nodiscard]] std::uint64_t collisions(robot::RobotIndex robot) const;

  /// Everything as at the start, with another seed if one is given.
  void reset(std::optional<std::uint64_t> seed);
  /// Frees the world; every later call fails. Tables that are looked at stay as they are.
  void close();

  [[nodiscard]] const files::Scenario& scenario() const { return *scenario_; }
  [[nodiscard]] std::shared_ptr<StateTable> table() const { return table_; }
  [[nodiscard]] std::size_t robot_count() const { return scenario_->robots.size(); }
  /// Counts resets.
  [[nodiscard]] std::uint64_t generation() const;

 private:
  [[nodiscard]] episode::Episode& opened() const;
  void write_table();

  const std::shared_ptr<const files::Scenario> scenario_;
  std::uint64_t seed_;
  mutable std::mutex mutex_;
  std::unique_ptr<episode::Episode> episode_;  ///< Null once closed.
  std::shared_ptr<StateTable> table_;
  std::uint64_t generation_ = 0;
};

}  // namespace eyebridge::python
