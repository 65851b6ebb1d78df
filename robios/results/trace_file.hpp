#pragma once

#include <filesystem>
#include <string>

#include "eyebridge/hal/trace.hpp"
#include "row_file.hpp"

namespace eyebridge::robios {

/// What trace.csv begins with.
inline constexpr const char* kTraceHeader = "t,x,y,theta,linear,angular,";

/// trace.csv: one row every 50 ms of the robot's time. One thread at a time; failures as a RowFile
/// keeps them.
class TraceFile {
 public:
  /// Throws ConfigError, without a place, when the file cannot be opened.
  explicit TraceFile(const std::filesystem::path& path) : file_(path) {}

  void add(const hal::TracePoint& point) noexcept;
  /// Whether add() of a point at `time` writes a row.
  [[nodiscard]] bool is_due(Time time) const { return !file_.failed() && time >= next_row_; }
  [[nodiscard]] RowFile& file() { return file_; }

 private:
  RowFile file_;
  std::string row_;
  Time next_row_{0};
};

/// collisions.csv: one row for each time that the robot ran into something, or something into it.
class CollisionFile {
 public:
  /// Throws as TraceFile does.
  explicit CollisionFile(const std::filesystem::path& path);

  void add(const hal::TraceContact& contact) noexcept;
  [[nodiscard]] RowFile& file() { return file_; }

 private:
  RowFile file_;
  std::string row_;
};

}  // namespace eyebridge::robios
