#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::robios {

/// The file of a robot program, changed so that it can be loaded as a library, many times.
struct ProgramFile {
  /// Functions by their addresses in the file, 0: none. The file itself no longer names them.
  struct Functions {
    std::uint64_t array = 0;  ///< Of addresses.
    std::size_t count = 0;
    std::uint64_t other = 0;  ///< One that is not in the array.
  };

  std::vector<char> bytes;
  /// Constructors: to be called when the image has its variables. The dynamic linker would call
  /// them before. `other` comes first.
  Functions starts;
  /// What is to be called at the program's end; the C library would call it at the end of the
  /// process. `other` comes last.
  Functions ends;
  /// A library that came with the program, which its copies would share; "" when there is none.
  std::string own_library;

  /// Read once. Throws ConfigError, at `program`, for what is no program for this machine, none
  /// that can be loaded more than once (not PIE, thread_local variables), or cannot be read.
  static const ProgramFile& of(const std::filesystem::path& program);
};

}  // namespace eyebridge::robios
