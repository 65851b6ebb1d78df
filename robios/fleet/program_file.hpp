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
  /// What is to be called at the program's end, by addresses in the file. The file itself no longer
  /// says so: the C library would call it at the end of the process.
  struct Ends {
    std::uint64_t functions = 0;  ///< An array of addresses.
    std::size_t count = 0;
    std::uint64_t last = 0;  ///< A function; 0: none.
  };

  std::vector<char> bytes;
  Ends ends;
  /// A library that came with the program, which its copies would share; "" when there is none.
  std::string own_library;

  /// Read once. Throws ConfigError, at `program`, for what is no program for this machine, none
  /// that can be loaded more than once (not PIE, thread_local variables), or cannot be read.
  static const ProgramFile& of(const std::filesystem::path& program);
};

}  // namespace eyebridge::robios
