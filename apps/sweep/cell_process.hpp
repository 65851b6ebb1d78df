#pragma once

#include <chrono>
#include <filesystem>

#include "eyebridge/base/unique_fd.hpp"
#include "sweep/run_cells.hpp"

namespace eyebridge::apps {

/// One run as a process: started, watched, reaped. One thread.
class CellProcess {
 public:
  using Moment = std::chrono::steady_clock::time_point;

  /// Makes `settings.folder`/`number` and starts the run in it. Throws std::system_error or
  /// std::filesystem::filesystem_error.
  CellProcess(const Cell& cell, std::size_t number, const RunSettings& settings);
  /// Ends the run if it has not been reaped.
  ~CellProcess();
  CellProcess(const CellProcess&) = delete;
  CellProcess& operator=(const CellProcess&) = delete;

  /// Becomes readable when the process has ended.
  [[nodiscard]] int descriptor() const { return pidfd_.get(); }
  /// When check_time() wants to be called.
  [[nodiscard]] Moment due() const { return due_; }
  /// Asks a run that took too long to end, then ends it.
  void check_time(Moment now);
  /// What came of it; only once descriptor() is readable. Removes its files unless they may tell
  /// why it went wrong.
  Outcome reap();

 private:
  void judge(Outcome& outcome, int status) const;

  const std::filesystem::path folder_;
  const double wall_limit_;
  double time_limit_ = 0.0;  ///< On the robot's clock, seconds; 0: none.
  const bool keep_files_;
  const Moment began_;
  Moment due_;
  bool asked_ = false;  ///< To end, because it took too long.
  bool reaped_ = false;
  int pid_ = 0;
  UniqueFd pidfd_;
};

}  // namespace eyebridge::apps
