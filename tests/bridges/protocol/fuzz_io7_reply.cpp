#include <cstddef>
#include <cstdint>

#include "entry.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  eyebridge::bridges::fuzz::io7_reply({data, size});
  return 0;
}
