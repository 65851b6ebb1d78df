#include <cstdint>
#include <cstdlib>

#include "pnm.hpp"

/// Any bytes: an error or an image that holds what its size says and survives a round trip.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using eyebridge::robios::pnm_channels;
  using eyebridge::robios::read_pnm;
  using eyebridge::robios::write_pnm;
  const auto image = read_pnm({data, size}, "fuzz");
  if (!image) {
    return 0;
  }
  if (image->bytes.size() != image->size.pixels() * pnm_channels(image->kind) ||
      image->bytes.size() > 8 * size || read_pnm(write_pnm(*image), "again") != image) {
    std::abort();
  }
  return 0;
}
