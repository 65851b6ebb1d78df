#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "program_file.hpp"
#include "program_variables.hpp"

struct link_map;

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

  /// Throws ConfigError, at `program`, for what ProgramFile refuses, for a program with libraries
  /// of its own, and for one without a main that is visible.
  static std::unique_ptr<ProgramImage> load(const std::filesystem::path& program);
  /// The same, but one for all who ask for this program: EyeSim's robots share their variables. It
  /// may have libraries of its own.
  static std::shared_ptr<ProgramImage> load_shared(const std::filesystem::path& program);
  ProgramImage(const ProgramImage&) = delete;
  ProgramImage& operator=(const ProgramImage&) = delete;

  [[nodiscard]] Main main() const { return main_; }
  /// Where the image has its copy of a library's variable; null when it has none.
  [[nodiscard]] void* variable(const std::string& name) const { return variables_.find(name); }
  /// That of any copy in which `address` lies; null when it lies in none. Also while one is being
  /// loaded.
  static const link_map* around(const void* address);

  /// One of those that use it uses it no more; true for the last one, who is to finish() it.
  bool leave() { return --users_ == 0; }
  /// Calls its exit handlers, destroys its objects. A second call goes on where a handler did not
  /// return. In the robot's flow.
  void finish(bool is_quick, int status);

 private:
  ProgramImage(const std::filesystem::path& program, const ProgramFile::Functions& ends)
      : name_(program.string()), ends_(ends) {}
  static std::unique_ptr<ProgramImage> load(const std::filesystem::path& program,
                                            const ProgramFile& file);
  bool share();
  /// Calls the constructors of the program's objects.
  void start(const ProgramFile::Functions& starts);

  void* handle_ = nullptr;  ///< Never closed: threads may still need it.
  const link_map* map_ = nullptr;
  Main main_ = nullptr;
  std::string name_;
  std::array<char*, 2> words_{name_.data(), nullptr};  ///< A constructor may keep them.
  ProgramVariables variables_;
  ProgramFile::Functions ends_;  ///< What is still to be called.
  std::atomic<std::size_t> users_ = 1;
};

}  // namespace eyebridge::robios
