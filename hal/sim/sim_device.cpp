#include "sim/sim_device.hpp"

#include <fmt/format.h>

namespace eyebridge::hal {

Result<void> SimDevice::require(bool good, const char* device, double value, const char* expected) {
  if (good) return {};
  return fail(Errc::OutOfRange, fmt::format("{}: got {}, expected {}", device, value, expected));
}

}  // namespace eyebridge::hal
