#include <cstddef>
#include <cstdint>

#include "firmware_entry.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  eyebridge::fuzz::firmware({reinterpret_cast<const char*>(data), size});
  return 0;
}
