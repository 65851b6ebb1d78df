#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "eyebridge/base/log.hpp"
#include "hand/instruction.hpp"

namespace eyebridge::hal {

/// Where a display writes its lines.
struct HandTerminal {
  std::function<void(const std::string&)> write;  ///< Any text.
  bool is_live = false;  ///< A line can be written over: a person looks at it, not a file.
};

/// The process's standard error.
HandTerminal standard_error();

/// Shows instructions: as `hand.png` in a folder, always whole, and as one line in a terminal, both
/// at most five times a second of the robot's clock. What is no live terminal gets a line for each
/// command, and when the robot is lost and found. Any thread.
class HandDisplay final : public InstructionSink {
 public:
  /// `folder` is empty for no pictures; it is made when the first one is written. `log`, for a
  /// picture that cannot be written (once), is lent.
  HandDisplay(std::filesystem::path folder, HandTerminal terminal, LogSink& log);

  void show(Time now, const Instruction& instruction) override;
  void finish() override;

 private:
  void write(const Instruction& instruction);
  void write_picture(const camera::Sign& sign);
  void write_line(const Instruction& instruction);

  const std::filesystem::path folder_;
  const HandTerminal terminal_;
  LogSink& log_;

  std::mutex mutex_;
  std::optional<Time> next_;           ///< Nothing is shown before.
  std::optional<Instruction> latest_;  ///< Perhaps not yet shown.
  std::optional<camera::Sign> sign_;
  std::string line_;
  std::optional<Instruction> said_;
  bool finished_ = false;
  bool cannot_write_ = false;
};

}  // namespace eyebridge::hal
