#include <cstddef>
#include <cstdint>

#include "camera_entry.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  eyebridge::fuzz::camera_url({reinterpret_cast<const char*>(data), size});
  return 0;
}
