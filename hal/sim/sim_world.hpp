#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/files/scenario.hpp"
#include "eyebridge/hal/trace.hpp"
#include "eyebridge/robot/simulation.hpp"
#include "sim/run_report.hpp"
#include "sim/run_trace.hpp"
#include "sim/world_lock.hpp"

namespace eyebridge::hal {

/// Robot `index` of `simulation`; OutOfRange, in words, where it is not there.
Result<robot::RobotIndex> robot_there(const robot::Simulation& simulation, std::size_t index);

/// A scenario that runs: the simulation, the lock around it, and who is told of its steps.
/// Any thread.
class SimWorld {
 public:
  /// Adds all robots of `scenario`. `log` outlives the world. Throws std::invalid_argument when one
  /// would stand in something.
  SimWorld(files::Scenario scenario, const robot::SimulationSettings& settings, LogSink& log);
  SimWorld(const SimWorld&) = delete;
  SimWorld& operator=(const SimWorld&) = delete;

  /// Runs `body(simulation)` while nobody else can touch it.
  template <class Body>
  auto locked(Body&& body) {
    const std::lock_guard lock(mutex_);
    return std::forward<Body>(body)(simulation_);
  }

  /// The same, where it is a sensor's answer to a program: what `body` gives is in trace_value().
  template <class Body>
  auto sensed(Body&& body) {
    const std::lock_guard lock(mutex_);
    const auto reading = std::forward<Body>(body)(simulation_);
    run_trace_.add(reading);
    return reading;
  }
  /// The same for many readings, which `body` writes unless it fails.
  template <class Body>
  Result<void> sensed_all(std::span<const double> readings, Body&& body) {
    const std::lock_guard lock(mutex_);
    Result<void> done = std::forward<Body>(body)(simulation_);
    if (!done) return done;
    for (const double reading : readings) run_trace_.add(reading);
    return done;
  }
  /// Of the run until now: RunTrace::value().
  [[nodiscard]] std::uint64_t trace_value() {
    const std::lock_guard lock(mutex_);
    return run_trace_.value();
  }

  /// One step, and its trace point.
  void step();
  /// Tells `sink` of `robot` after every step from now on; null ends it.
  void trace_to(TraceSink* sink, robot::RobotIndex robot);

  /// Keeps a report of the run from now on.
  void report_to(RunReport report);
  /// Adds a number to the report, if there is one: RunReport::note().
  void note(const std::string& name, double value);
  /// The program has ended: the report says so.
  void end_report() noexcept;
  /// Why that could not be written in full; "" when it was, and where there is none.
  [[nodiscard]] std::string lost_report();

  /// Adds a robot to the world as it is now. OutOfRange where it would stand in something.
  Result<robot::RobotIndex> add_robot(const robot::RobotModel& model, const Pose& pose);
  /// Takes robot `index` out of the world, and tells nobody of it any more. OutOfRange for one that
  /// is not there.
  Result<void> remove_robot(std::size_t index);
  /// Writes to the log of the run. Any thread, also one that has the lock.
  void warn(const std::string& text) { log_.write(Severity::Warning, text); }
  /// Moves a submarine up or down, clamped to the water: a warning tells of it the first time.
  /// Other robots stay on the floor.
  void set_altitude(robot::RobotIndex robot, double altitude);
  /// OutOfRange, in words, where robot `index` is not there.
  [[nodiscard]] Result<void> check_there(std::size_t index);
  /// The steps made so far, as time.
  [[nodiscard]] Time now();
  /// A copy: the simulation's own moves when a robot is added.
  [[nodiscard]] robot::RobotModel model(robot::RobotIndex robot);
  [[nodiscard]] const std::string& directory() const { return directory_; }
  [[nodiscard]] bool starts_paused() const { return starts_paused_; }

 private:
  void trace();  ///< mutex_ is held.
  /// What a robot would stand in, in words. mutex_ is held.
  [[nodiscard]] std::string obstacle_at(Vec2 centre, double radius) const;
  /// Called from a step: mutex_ is held.
  void tell(const robot::CollisionEvent& event);

  LogSink& log_;
  const std::string directory_;
  const bool starts_paused_;
  const Time step_length_;
  WorldLock mutex_;
  robot::Simulation simulation_;
  std::uint64_t steps_ = 0;
  RunTrace run_trace_;
  /// A robot somebody wants to be told of.
  struct Traced {
    TraceSink* sink = nullptr;
    std::vector<std::size_t> sensors;  ///< In order of id.
    std::vector<double> ranges;
  };
  std::map<robot::RobotIndex, Traced> traced_;
  std::optional<RunReport> report_;
  bool has_told_of_water_ = false;
};

}  // namespace eyebridge::hal
