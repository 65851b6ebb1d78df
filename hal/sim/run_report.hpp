#pragma once

#include <filesystem>

#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/robot/tally.hpp"

namespace eyebridge::hal {

/// What has come of a run so far, as a small text that is always whole (`--report`): lines
/// "key = value" of `time` (s), `distance` (m, of all robots), `collisions`, `state_hash` (of
/// everything that moves) and `ended` (the program did, by itself or by a signal).
///
/// Written over once a second of the robot's time, so that a program that crashes or is killed
/// leaves one, too. One thread at a time.
class RunReport {
 public:
  /// Replaces `path`. Throws ConfigError without a place when it cannot be written.
  explicit RunReport(const std::filesystem::path& path);

  /// After every step.
  void step(const robot::Simulation& simulation);
  void collision(const robot::CollisionEvent& event) { tally_.add_collision(event); }
  /// When the program ends.
  void end(const robot::Simulation& simulation) noexcept { write(simulation, true); }

 private:
  void write(const robot::Simulation& simulation, bool ended) noexcept;

  UniqueFd file_;
  robot::Tally tally_;
  double next_ = 0.0;  ///< When to write again, seconds.
};

}  // namespace eyebridge::hal
