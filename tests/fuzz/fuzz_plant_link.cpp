#include <cstddef>
#include <cstdint>

#include "plant_link_entry.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  eyebridge::fuzz::plant_link({reinterpret_cast<const char*>(data), size});
  return 0;
}
