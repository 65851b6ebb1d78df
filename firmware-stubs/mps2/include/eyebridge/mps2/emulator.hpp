#pragma once

#include <string>

#include <sys/types.h>

#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge::mps2 {

/// What is emulated, and by what.
struct EmulatorSettings {
  std::string elf;                          ///< The firmware: eyebridge-mps2.elf.
  std::string command = "qemu-system-arm";  ///< Found in PATH without a slash.
};

/// A V2M-MPS2 with a Cortex-M3 (AN385) in QEMU, as a child of this process. It ends with this
/// object, at the latest with the thread that made it, however that ends. One thread.
class Emulator {
 public:
  /// Starts it. Throws ConfigError when the firmware or the emulator is not there, naming the
  /// packages to install, or the firmware is no program for an ARM.
  explicit Emulator(const EmulatorSettings& settings);
  ~Emulator();
  Emulator(const Emulator&) = delete;
  Emulator& operator=(const Emulator&) = delete;

  /// The board's serial line and its plant link: stream sockets, non-blocking, lent.
  [[nodiscard]] int host_line() const { return host_line_.get(); }
  [[nodiscard]] int plant_line() const { return plant_line_.get(); }
  [[nodiscard]] pid_t pid() const { return pid_; }

  /// Ends it, if it has not ended on its own, and tells how it ended: "was killed by signal 9". To
  /// be called when one of its lines was closed.
  std::string end();

 private:
  pid_t pid_ = -1;
  UniqueFd host_line_, plant_line_;
};

}  // namespace eyebridge::mps2
