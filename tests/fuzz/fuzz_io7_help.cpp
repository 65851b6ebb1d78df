#include <cstddef>
#include <cstdint>

#include "bridges_entry.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  eyebridge::fuzz::io7_help({reinterpret_cast<const char*>(data), size});
  return 0;
}
