#pragma once

#include <cstddef>
#include <fstream>
#include <stdexcept>

#include <unistd.h>

namespace eyebridge::testing {

/// Bytes of this process that are in RAM: the second number of /proc/self/statm, in pages. Pages
/// that were only read, and never written, do not count.
inline std::size_t resident_bytes() {
  std::size_t all = 0;
  std::size_t resident = 0;
  if (!(std::ifstream("/proc/self/statm") >> all >> resident)) {
    throw std::runtime_error("/proc/self/statm: expected two numbers");
  }
  return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

}  // namespace eyebridge::testing
