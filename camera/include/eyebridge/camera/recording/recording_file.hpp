#pragma once

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/camera/recording/sqlite.hpp"

namespace eyebridge::camera {

/// Keys and values of the table `meta`.
using RecordingFacts = std::vector<std::pair<std::string_view, std::string>>;

/// A recording that is being written: one SQLite 3 file (`.ebrec`) that any SQLite tool opens.
///
/// Tables: `meta` (key, value: version and what else is known), `device` and `exchange` (what a
/// robot's devices were asked and answered; written by hal/replay), `frame` (pictures; written by
/// FrameWriter). All times are ns on one clock, the robot's.
///
/// Written ahead (WAL), and committed after each second of the robot's clock and twice a second of
/// real time, by a thread of its own: a program that is killed leaves all but its last second, also
/// when it had stopped writing long before. Any thread.
class RecordingFile {
 public:
  /// Replaces `path` if it is a recording. Throws ConfigError without a place when it is anything
  /// else, another run is writing it, or it cannot be written.
  RecordingFile(const std::filesystem::path& path, const RecordingFacts& facts);
  /// Commits, and makes one file of three.
  ~RecordingFile();
  RecordingFile(const RecordingFile&) = delete;
  RecordingFile& operator=(const RecordingFile&) = delete;

  /// A statement for this file, to be run within write() and given up before the file. Throws
  /// std::runtime_error.
  sqlite::Statement prepare(const char* sql);

  /// Runs `add_rows` within a transaction; `time` is now on the robot's clock. Throws
  /// std::runtime_error when the disk does not take it, or did not take what came before.
  void write(Time time, const std::function<void()>& add_rows);

  /// Hands all that was written to the system. Throws likewise.
  void commit();

 private:
  // mutex_ is held.
  void commit_pending();
  void keep_committing();

  UniqueFd lock_;  ///< Held until the database is closed.
  sqlite::Database database_;
  std::mutex mutex_;
  std::condition_variable ended_;
  Time begun_{0};         ///< Of the transaction, on the robot's clock.
  bool pending_ = false;  ///< A transaction is open.
  bool ending_ = false;
  std::string failure_;  ///< Why the thread could not commit; "" while it could.
  std::thread committer_;
};

/// Opens a recording for reading; it may come from a stranger (checked_file.hpp). Throws
/// std::runtime_error: it is missing, none, damaged, or of another version.
sqlite::Database open_recording(const std::filesystem::path& path);

/// A year: no run is longer, and a clock that follows a recording gets to its end.
inline constexpr Time kLongestRecording = std::chrono::hours(24 * 366);

/// A time of a recording. Throws std::runtime_error when it is not `least` ... kLongestRecording.
Time recorded_time(std::int64_t ns, Time least = Time{0});

}  // namespace eyebridge::camera
