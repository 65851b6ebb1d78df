#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::robios {

/// A copy of a robot program in this process, with variables of its own.
///
/// glibc does not dlopen() a file that is marked as a program (DF_1_PIE), and gives the same copy
/// for the same file: so each image is loaded from a file in memory of its own, without the mark.
/// Code and constants are shared by the kernel only while they come from one file; each image has
/// its own pages here, which is what a copy costs. Constructors of global objects run in load().
class ProgramImage {
 public:
  using Main = int (*)(int argc, char** argv, char** environment);

  /// Throws ConfigError, at `program`, for what is no program for this machine, none that can be
  /// loaded more than once (not PIE, no main that is visible, thread_local variables), or cannot
  /// be read.
  static std::unique_ptr<ProgramImage> load(const std::filesystem::path& program);
  /// True when load() would find nothing wrong with the file.
  static bool can_load(const std::filesystem::path& program);
  /// The same, but one for all who ask for this program: EyeSim's robots share their variables.
  static std::shared_ptr<ProgramImage> load_shared(const std::filesystem::path& program);
  ProgramImage(const ProgramImage&) = delete;
  ProgramImage& operator=(const ProgramImage&) = delete;

  [[nodiscard]] Main main() const { return main_; }
  /// Where the image has its copy of a library's variable; null when it has none.
  [[nodiscard]] void* variable(const std::string& name) const;

 private:
  ProgramImage() = default;

  void* handle_ = nullptr;  ///< Never closed: exit handlers and threads may still need it.
  Main main_ = nullptr;
};

}  // namespace eyebridge::robios
