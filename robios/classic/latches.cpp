// Latches, parallel port and A/D converter; the M6's digital lines and converters, too.

#include <array>
#include <charconv>
#include <mutex>
#include <string_view>

#include <fmt/format.h>

#include "call.hpp"
#include "eyebot.h"

namespace {

using namespace eyebridge;
using robios::Session;
using robios::classic::call;
using robios::classic::doing;

constexpr int kLatchLines = 8;
constexpr int kFirstOutput = 9;     // digital line of bit 0 of output latch 0
constexpr int kConverterShift = 2;  // 12 bits to 10

/// What was written last.
struct Latches {
  std::mutex mutex;
  BYTE output = 0;
  BYTE par_data = 0;
  BYTE par_ctrl = 0;
};

Result<hal::DigitalLines*> lines_of(Session& session) {
  hal::DigitalLines* const lines = session.backend().digital();
  if (lines == nullptr) return fail(Errc::NoDevice, "this robot has no digital lines");
  return lines;
}

/// The lines behind a latch: there is one of each kind.
Result<hal::DigitalLines*> latch_lines(Session& session, int latchnr) {
  if (latchnr == 0) return lines_of(session);
  return fail(Errc::OutOfRange,
              fmt::format("there is no latch {}; this robot has latch 0", latchnr));
}

Result<void> need_port(Session& session) {
  if (session.backend().world() != nullptr) return {};
  return fail(Errc::NoDevice, "this robot has no parallel port");
}

BYTE read_port(const robios::Call& name, BYTE Latches::*field) {
  return call(name, BYTE{0}, [&](Session& session) -> Result<BYTE> {
    auto& latches = session.own<Latches>();
    const std::lock_guard lock(latches.mutex);
    return need_port(session).map([&] { return latches.*field; });
  });
}

void write_port(const robios::Call& name, BYTE Latches::*field, int value) {
  doing(name, 1, [&](Session& session) -> Result<void> {
    auto& latches = session.own<Latches>();
    const std::lock_guard lock(latches.mutex);
    return need_port(session).map([&] { latches.*field = static_cast<BYTE>(value); });
  });
}

Result<int> convert(Session& session, int channel) {
  hal::AnalogInputs* const inputs = session.backend().analog();
  if (inputs == nullptr) return fail(Errc::NoDevice, "this robot has no analog inputs");
  return inputs->read(channel).map([](int value) { return value >> kConverterShift; });
}

/// Runs `act(lines, line)` on line `latchnum` of the M6.
template <class Act>
int on_line(const robios::Call& name, int latchnum, int failure, Act&& act) {
  return call(name, failure, [&](Session& session) -> Result<int> {
    if (latchnum < 0 || latchnum >= hal::DigitalLines::kCount) {
      return fail(Errc::OutOfRange, fmt::format("there is no line {}; expected 0 … 15", latchnum));
    }
    return lines_of(session).and_then(
        [&](hal::DigitalLines* lines) -> Result<int> { return act(*lines, latchnum + 1); });
  });
}

}  // namespace

BYTE OSReadInLatch(int latchnr) {
  return call("OSReadInLatch", BYTE{0}, [&](Session& session) -> Result<BYTE> {
    return latch_lines(session, latchnr).and_then([](hal::DigitalLines* lines) {
      return lines->read_all().map([](std::uint16_t all) { return static_cast<BYTE>(all & 0xFF); });
    });
  });
}

BYTE OSWriteOutLatch(int latchnr, BYTE mask, BYTE value) {
  return call("OSWriteOutLatch", BYTE{0}, [&](Session& session) -> Result<BYTE> {
    auto& latches = session.own<Latches>();
    const std::lock_guard lock(latches.mutex);
    const auto lines = latch_lines(session, latchnr);
    if (!lines) return tl::unexpected(lines.error());
    const BYTE before = latches.output;
    const auto after = static_cast<BYTE>((before & mask) | value);
    for (int bit = 0; bit < kLatchLines; ++bit) {
      const bool high = (after >> bit & 1) != 0;
      if (Result<void> written = (*lines)->write(kFirstOutput + bit, high); !written) {
        return tl::unexpected(written.error());
      }
    }
    latches.output = after;
    return before;
  });
}

BYTE OSReadOutLatch(int latchnr) {
  return call("OSReadOutLatch", BYTE{0}, [&](Session& session) -> Result<BYTE> {
    auto& latches = session.own<Latches>();
    const std::lock_guard lock(latches.mutex);
    return latch_lines(session, latchnr).map([&](hal::DigitalLines*) { return latches.output; });
  });
}

BYTE OSReadParData(void) { return read_port("OSReadParData", &Latches::par_data); }
void OSWriteParData(BYTE value) { write_port("OSWriteParData", &Latches::par_data, value); }
BYTE OSReadParSR(void) {
  return call("OSReadParSR", BYTE{0}, [](Session& session) -> Result<BYTE> {
    return need_port(session).map([] { return BYTE{0}; });  // nothing is plugged in
  });
}
void OSWriteParCTRL(BYTE value) { write_port("OSWriteParCTRL", &Latches::par_ctrl, value & 0x0F); }
BYTE OSReadParCTRL(void) { return read_port("OSReadParCTRL", &Latches::par_ctrl); }

int OSGetAD(int channel) {
  return call("OSGetAD", -1, [&](Session& session) { return convert(session, channel); });
}

int OSOffAD(int mode) {
  return doing("OSOffAD", 1, [&](Session&) -> Result<void> {
    if (mode == 0 || mode == 1) return {};
    return fail(Errc::OutOfRange, fmt::format("mode {}, expected 0 or 1", mode));
  });
}

int OSLatchInit(void) {
  return doing("OSLatchInit", 1,
               [](Session& session) { return lines_of(session).map([](auto*) {}); });
}

int OSLatchCleanup(void) {
  return doing("OSLatchCleanup", 1, [](Session&) -> Result<void> { return {}; });
}

int OSLatchSetup(int latchnum, int direction) {
  return on_line(
      "OSLatchSetup", latchnum, 1, [&](hal::DigitalLines& lines, int line) -> Result<int> {
        if (direction != 0 && direction != 1) {
          return fail(Errc::OutOfRange, fmt::format("direction {}, expected 0 (input) or "
                                                    "1 (output)",
                                                    direction));
        }
        const auto mode = direction == 0 ? hal::LineMode::Input : hal::LineMode::Output;
        return lines.setup(line, mode).map([] { return 0; });
      });
}

int OSLatchBankSetup(int banknum, int direction) {
  int failures = banknum == IOBANK0 || banknum == IOBANK1 ? 0 : OSLatchSetup(-1, direction);
  for (int i = 0; i < kLatchLines && failures == 0; ++i) {
    failures = OSLatchSetup(banknum * kLatchLines + i, direction);
  }
  return failures;
}

int OSLatchRead(int latchnum) {
  return on_line("OSLatchRead", latchnum, -1, [](hal::DigitalLines& lines, int line) {
    return lines.read(line).map([](bool high) { return high ? 1 : 0; });
  });
}

int OSLatchWrite(int latchnum, int state) {
  return on_line("OSLatchWrite", latchnum, 1, [&](hal::DigitalLines& lines, int line) {
    return lines.write(line, state != 0).map([] { return 0; });
  });
}

int OSInitADC(const char* name) {
  return call("OSInitADC", 0, [&](Session& session) -> Result<int> {
    if (name == nullptr) return robios::null_pointer();
    const std::string_view text = name;
    int channel = -1;
    const auto* const end = text.data() + text.size();
    if (!text.starts_with("ADC") || std::from_chars(text.data() + 3, end, channel).ptr != end ||
        channel < 0) {
      return fail(Errc::OutOfRange, fmt::format("there is no converter \"{:.60}\"", text));
    }
    return convert(session, channel).map([&](int) { return channel + 1; });
  });
}

int OSGetADC(int handle) {
  return call("OSGetADC", -1, [&](Session& session) { return convert(session, handle - 1); });
}

int OSADCRelease(int handle) {
  return doing("OSADCRelease", 1, [&](Session&) -> Result<void> {
    if (handle >= 1) return {};
    return fail(Errc::OutOfRange, fmt::format("handle {} is no converter", handle));
  });
}
