#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "running_firmware.hpp"

namespace eyebridge::testing {

/// A kind of line between a program and its board.
struct Line {
  std::string name;
  std::vector<std::string> options;  ///< Of the firmware.
};

inline void PrintTo(const Line& line, std::ostream* out) { *out << line.name; }

/// The robot program of driver.c on a board in another process, and where its robot really is.
class Loop {
 public:
  explicit Loop(const Line& line);

  /// Starts the board, again after it was killed.
  void start_firmware();
  /// Starts the program and waits until it has driven for a while.
  void start_program();

  /// Seconds since the firmware's start, by the last row that it wrote.
  [[nodiscard]] double time() const;
  /// When the robot has stood still since, once it has done so for half a second; nothing when it
  /// still moves after ten.
  [[nodiscard]] std::optional<double> standing_since() const;
  /// Waits until the robot moves. False when it does not within ten seconds.
  [[nodiscard]] bool moves() const;

  RunningProgram& firmware() { return *firmware_; }
  RunningProgram& program() { return *program_; }

 private:
  struct Row {
    double t = 0.0;
    double x = 0.0;
    double y = 0.0;
  };
  [[nodiscard]] std::vector<Row> path() const;

  Line line_;
  ScratchFolder folder_;
  std::string url_;
  std::optional<RunningFirmware> firmware_;
  std::optional<RunningProgram> program_;
};

}  // namespace eyebridge::testing
