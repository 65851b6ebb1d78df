#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calls/device_list.hpp"
#include "calls/interceptor.hpp"
#include "eyebridge/base/clock.hpp"
#include "eyebridge/camera/recording/recording_file.hpp"

namespace eyebridge::hal {

/// One call of a device and what came of it, as a recording holds it.
struct Exchange {
  Time time{0};        ///< On the robot's clock, when the call began.
  std::string device;  ///< As in Call.
  int id = 1;
  std::string name;
  Values request;
  Result<Values> reply;
};

/// What was recorded, for people to read; each may be empty.
struct RecordingOrigin {
  std::string program;  ///< Its command line.
  std::string hal;      ///< How the robot was reached: a backend's URL.
  std::string world;    ///< The world that was named.

  friend bool operator==(const RecordingOrigin&, const RecordingOrigin&) = default;
};

/// Writes the tables `device` (kind, id, facts) and `exchange` (seq, t in ns, device, id, call,
/// request, reply, error, what) of a recording; numbers of a request or reply are decimals with
/// blanks between, in SI units. Any thread.
class EbrecWriter {
 public:
  /// Replaces `path`. Throws ConfigError without a place when it cannot be written.
  EbrecWriter(const std::filesystem::path& path, const std::vector<ListedDevice>& devices,
              const RecordingOrigin& origin = {});

  /// Throws std::runtime_error when the disk does not take it.
  void add(Time time, const Call& call, const Result<Values>& reply);
  /// Hands all that was added to the system. Throws likewise.
  void commit() { file_.commit(); }
  /// Where the frames of the same run go.
  [[nodiscard]] camera::RecordingFile& file() { return file_; }

 private:
  camera::RecordingFile file_;
  camera::sqlite::Statement insert_;
};

/// All of a recording.
struct Recording {
  RecordingOrigin origin;
  std::vector<ListedDevice> devices;
  std::vector<Exchange> exchanges;  ///< In the order in which they were made.
};

/// Throws ConfigError naming the file: it is missing, no recording, of another version, or damaged.
Recording read_recording(const std::filesystem::path& path);

}  // namespace eyebridge::hal
