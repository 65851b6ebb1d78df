#include <fmt/format.h>

#include "eyebot.h"
#include "guarded.hpp"

namespace {

using namespace eyebridge;

/// Runs `body` on the robot's lines.
template <class Body>
int with_lines(const robios::Call& call, int failure, Body&& body) {
  return robios::guarded(call, failure, [&](robios::Session& session) -> Result<int> {
    hal::DigitalLines* lines = session.backend().digital();
    if (lines == nullptr) return fail(Errc::NoDevice, "this robot has no digital lines");
    return body(*lines);
  });
}

Result<hal::LineMode> mode_of(char direction) {
  switch (direction) {
    case 'i':
      return hal::LineMode::Input;
    case 'o':
      return hal::LineMode::Output;
    case 'I':
      return hal::LineMode::PullUp;
    case 'J':
      return hal::LineMode::PullDown;
    default:
      return fail(Errc::OutOfRange, fmt::format("direction {}, expected 'i', 'o', 'I' or 'J'",
                                                static_cast<int>(direction)));
  }
}

}  // namespace

int DIGITALSetup(int io, char direction) {
  return with_lines("DIGITALSetup", 1, [&](hal::DigitalLines& lines) -> Result<int> {
    return mode_of(direction).and_then(
        [&](hal::LineMode mode) { return lines.setup(io, mode).map([] { return 0; }); });
  });
}

int DIGITALRead(int io) {
  return with_lines("DIGITALRead", -1, [&](hal::DigitalLines& lines) -> Result<int> {
    return lines.read(io).map([](bool high) { return high ? 1 : 0; });
  });
}

int DIGITALReadAll(void) {
  return with_lines("DIGITALReadAll", -1, [](hal::DigitalLines& lines) -> Result<int> {
    return lines.read_all().map([](unsigned levels) { return static_cast<int>(levels); });
  });
}

int DIGITALWrite(int io, int state) {
  return with_lines("DIGITALWrite", 1, [&](hal::DigitalLines& lines) -> Result<int> {
    return lines.write(io, state != 0).map([] { return 0; });
  });
}
