#include "board/board_device.hpp"

#include <fmt/format.h>

namespace eyebridge::hal {

Result<void> BoardDevice::require(bool good, const char* device, double value,
                                  const char* expected) {
  if (good) return {};
  return fail(Errc::OutOfRange, fmt::format("{}: got {}, expected {}", device, value, expected));
}

Result<void> BoardLink::scan(BoardScan&) {
  return fail(Errc::Unsupported, "this board has no LIDAR");
}

}  // namespace eyebridge::hal
