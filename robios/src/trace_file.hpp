#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "eyebridge/hal/trace.hpp"

namespace eyebridge::robios {

/// trace.csv: one row every 50 ms of the robot's time. One thread at a time.
///
/// A disk that is full must not stop a robot that drives: the first failure is kept, and nothing is
/// written any more.
class TraceFile {
 public:
  /// Throws std::system_error when the file cannot be opened.
  explicit TraceFile(const std::filesystem::path& path);

  void add(const hal::TracePoint& point) noexcept;
  /// Hands all rows to the system.
  void flush() noexcept;
  /// errno of the first failure, or 0.
  [[nodiscard]] int failure() const { return failure_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void note_failure() noexcept;

  std::unique_ptr<std::FILE, Close> file_;
  std::string row_;
  Time next_row_{0};
  int failure_ = 0;
};

}  // namespace eyebridge::robios
