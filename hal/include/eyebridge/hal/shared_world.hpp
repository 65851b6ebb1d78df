#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/hash.hpp"
#include "eyebridge/base/pose.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/config.hpp"
#include "eyebridge/hal/turns.hpp"
#include "eyebridge/robot/robot_model.hpp"

namespace eyebridge {
class LogSink;
}

namespace eyebridge::hal {

class Environment;

/// What the scenario says of one robot.
struct SharedRobot {
  std::string model;                   ///< Name of its type: "S4".
  std::string program;                 ///< As the scenario names it; "" when it names none.
  std::vector<std::string> arguments;  ///< Of the program.
};

/// A robot that enters a world while it runs.
struct Newcomer {
  robot::RobotModel model;
  Pose pose;
  std::string program;  ///< As in SharedRobot.
  std::vector<std::string> arguments;
  Time time{0};          ///< Where the scenario says when it enters.
  SourceLocation where;  ///< Likewise, its line.
};

/// A world whose robots run programs of their own: `sim` for several. Any thread.
class SharedWorld {
 public:
  virtual ~SharedWorld() = default;

  /// Those that are there from the start, in the order of their numbers. Never changes.
  [[nodiscard]] virtual const std::vector<SharedRobot>& robots() const = 0;
  /// Those that the scenario lets enter later, in the order in which they do. Never changes.
  [[nodiscard]] virtual const std::vector<Newcomer>& newcomers() const = 0;
  /// The type `name`: one of the scenario, a built-in one, or a .robi file; with the errors that
  /// the configuration wants. Throws ConfigError.
  [[nodiscard]] virtual robot::RobotModel model(const std::string& name) const = 0;
  /// Lets a robot enter now. Its index: the next one; indices are not used again. In virtual time
  /// only between two rounds. OutOfRange where it would stand in something.
  virtual Result<std::size_t> enter(const Newcomer& newcomer) = 0;
  /// Takes robot `robot`, an index, out of the world, whose program has ended. OutOfRange for one
  /// that is not there. As enter().
  virtual Result<void> leave(std::size_t robot) = 0;
  /// What leave() would say.
  [[nodiscard]] virtual Result<void> can_leave(std::size_t robot) = 0;
  /// Present time: that of the steps that were made.
  [[nodiscard]] virtual Time now() = 0;
  /// Returns when real time has come to `time`; in virtual time nobody waits.
  virtual void wait_until(Time time) = 0;
  /// Of the simulation.
  [[nodiscard]] virtual Time step_length() const = 0;
  /// Real time, which stood still, begins. Once or more.
  virtual void begin_time() = 0;
  /// Makes one step. In virtual time only: the implementation of Turns calls it between rounds; in
  /// the world of a robot that began alone, any thread once that robot's program has ended.
  virtual void step() = 0;
  /// As windows see it.
  [[nodiscard]] virtual Environment& environment() = 0;
  /// A number that came of the run, `value` finite, for the run's report (`--report`), if there is
  /// one: a line "name = value" besides those that every report has. At most eight names of at most
  /// 32 letters; the last value of each counts. Before end().
  virtual void note(const std::string& name, double value) = 0;
  /// The last program has ended: the run's report says so.
  virtual void end() noexcept = 0;
  /// After end(), as Backend::lost_results().
  [[nodiscard]] virtual std::string lost_results() = 0;
  /// Of everything that moved, and of all that sensors told programs: the same for the same run.
  [[nodiscard]] virtual StateHash hash() = 0;
  /// How often real time slipped because the computer was too slow; 0 in virtual time.
  [[nodiscard]] virtual std::uint64_t overruns() const = 0;
};

/// Opens the world that `config` names, with as many robots as it says (`robots`). In virtual time
/// (`fast`) they take turns by `turns`, which outlives the world; else a thread steps it from now
/// on. Throws ConfigError as open_backend(), and for settings that only one robot can have
/// (`record`, `mix`, `drive`, another `hal` than sim).
std::shared_ptr<SharedWorld> open_shared_world(const Config& config, LogSink& log, Turns* turns);

/// How many robots run programs by `config`; 1 unless it asks for more. Throws ConfigError as
/// open_shared_world(). Cheap where no more than one is asked for.
std::size_t programs_wanted(const Config& config);

/// Throws ConfigError where `config`, of a run with one simulated robot, has a setting that only a
/// robot that is alone can have: then no other robot can join it (Backend::shared_world()).
void check_can_join(const Config& config);

/// A robot's place in a world that it shares: open_backend() gives that robot.
struct WorldSlot {
  std::shared_ptr<SharedWorld> world;
  std::size_t robot = 0;  ///< Its index.
};

}  // namespace eyebridge::hal
