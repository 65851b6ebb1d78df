#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/camera/recording/sqlite.hpp"
#include "sweep/outcome.hpp"
#include "sweep/plan.hpp"

namespace eyebridge::apps {

/// One run as the results hold it.
struct ResultRow {
  std::string key;                                 ///< Cell::key().
  std::map<std::string, std::string> coordinates;  ///< Cell::coordinates().
  std::string how;                                 ///< Outcome::how.
  std::string reason;                              ///< Outcome::reason.
  std::string state_hash;                          ///< Outcome::state_hash.
  /// Numbers of the run by name: time, distance, collisions, wall, cpu, and its results that are
  /// numbers.
  std::map<std::string, double> values;
};

/// The results of a sweep: one SQLite 3 file.
///
/// Tables: `run` (one row a run: id, key, how, reason, exit_code, signal, time, distance,
/// collisions, state_hash, wall, cpu; null where there is none), `coordinate` (run, name, value:
/// the cell), `result` (run, name, value: what the program said), `input` (path, hash: programs and
/// worlds), `meta` (key, value). Each run is a transaction of its own: the process may be killed at
/// any time. The disk is waited for at most once a second, when a run ends, and on closing: a power
/// cut loses the runs since then. While it is open, two more files (-wal, -shm) belong to it. One
/// thread.
class ResultsFile {
 public:
  /// Opens or makes `path` for writing. Throws ConfigError: it is no such file, of another version,
  /// cannot be written, or another sweep is writing it.
  /// `flag` is what names another file, for messages.
  explicit ResultsFile(const std::filesystem::path& path, std::string flag = "--results");
  ~ResultsFile();
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;

  /// Says which version of a program or world the runs use. Throws ConfigError when runs of another
  /// version are in the file: they cannot be compared.
  void note_input(const std::filesystem::path& path);

  /// Keys (Cell::key()) of the runs that are in the file; only those that ended well if
  /// `well_only`.
  [[nodiscard]] std::set<std::string> keys(bool well_only) const;
  /// In the place of an earlier row of the same cell. Throws std::runtime_error when the disk does
  /// not take it.
  void add(const Cell& cell, const Outcome& outcome);

 private:
  UniqueFd lock_;  ///< Held until the database is closed.
  camera::sqlite::Database database_;
  std::string file_;
  std::string flag_;
  std::chrono::steady_clock::time_point synced_{};  ///< When the disk was waited for last.
};

/// All runs in the file, in the order in which they ended. Throws ConfigError when it is missing or
/// no results of a sweep.
std::vector<ResultRow> read_results_file(const std::filesystem::path& path);

}  // namespace eyebridge::apps
