#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/robot/tally.hpp"

namespace eyebridge::hal {

/// What has come of a run so far, as a small text that is always whole (`--report`): lines
/// "key = value" of `time` (s), `distance` (m, of all robots), `collisions`, `stuck` (s: the
/// longest time for which a robot stood although it was told to move), `state_hash` (of everything
/// that moves, as it is), `trace_hash` (RunTrace), `ended` (the program did, by itself or by a
/// signal), `end_x`, `end_y` (m) and `end_theta` (rad: where robot 1 is in the world, when there is
/// one), `end_depth` (m: how far it is below the surface, of a submarine), and what note() was
/// told.
///
/// Written over once a second of the robot's time, so that a program that crashes or is killed
/// leaves one, too. One thread at a time.
class RunReport {
 public:
  /// Replaces `path`. Throws ConfigError without a place when it cannot be written.
  explicit RunReport(const std::filesystem::path& path);

  /// After every step.
  void step(const robot::Simulation& simulation, std::uint64_t trace);
  void collision(const robot::CollisionEvent& event) { tally_.add_collision(event); }
  /// A number that whoever drives the robots knows of the run, `value` finite, as a line of its own
  /// from the next time on that the report is written. `name`: a word, none of those above; the
  /// last value of a name counts, and names past kMostNotes are our own bug.
  void note(const std::string& name, double value);
  static constexpr std::size_t kMostNotes = 8;
  /// When the program ends.
  void end(const robot::Simulation& simulation, std::uint64_t trace) noexcept {
    write(simulation, trace, true);
  }
  /// Why the last write did not succeed in full; "" when it did.
  [[nodiscard]] std::string lost() const;

 private:
  void write(const robot::Simulation& simulation, std::uint64_t trace, bool ended) noexcept;

  std::filesystem::path path_;
  UniqueFd file_;
  int failure_ = 0;  ///< errno of the last write.
  robot::Tally tally_;
  double next_ = 0.0;  ///< When to write again, seconds.
  std::map<std::string, double> notes_;
};

}  // namespace eyebridge::hal
