#include <array>

#include <fmt/format.h>

#include "call.hpp"
#include "eyebot.h"

namespace {

using namespace eyebridge;
using robios::Session;
using robios::classic::call;
using robios::classic::doing;

// As the manual has them.
constexpr int kSendTimeout = 3;
constexpr int kIllegalBaud = 8;
constexpr int kIllegalInterface = 10;
constexpr int kLineError = -254;    // 0xffffff02
constexpr int kNoInterface = -246;  // 0xffffff0a

constexpr std::array kBauds = {4800, 9600, 19200, 38400, 57600, 115200};  // by SER4800 …

constexpr Time kByteTime = std::chrono::seconds(1);
// Bytes come in real time: in virtual time a wait need not take as long.
constexpr Time kShortPatience = std::chrono::milliseconds(10);

hal::SerialPort* port_of(Session& session, int interface) {
  if (interface < SERIAL1 || interface > SERIAL3) return nullptr;
  return session.backend().serial_port(interface - SERIAL1);
}

tl::unexpected<Error> no_port(int interface) {
  return fail(Errc::OutOfRange,
              fmt::format("no serial interface {}; --serial \"0=/dev/ttyUSB0\" names the device of "
                          "SERIAL1, 1= and 2= those of SERIAL2 and SERIAL3",
                          interface));
}

/// For what returns 0 or one of the manual's numbers: `act(port)` gives Result<void>, whose failure
/// is `failure`.
template <class Act>
int on_port(const robios::Call& name, int interface, int failure, int none, Act&& act) {
  hal::SerialPort* const port = port_of(Session::instance(), interface);
  return call(name, port == nullptr ? none : failure, [&](Session&) -> Result<int> {
    if (port == nullptr) return no_port(interface);
    return act(*port);
  });
}

int send_byte(const robios::Call& name, std::uint8_t byte, int interface) {
  return on_port(name, interface, kSendTimeout, kIllegalInterface, [&](hal::SerialPort& port) {
    return port.send({&byte, 1}).map([] { return 0; });
  });
}

}  // namespace

int OSInitRS232(int baud, int handshake, int interface) {
  const bool by_code = baud >= SER4800 && baud <= SER115200;
  const int rate = by_code ? kBauds.at(static_cast<std::size_t>(baud)) : 0;
  const int failure = by_code ? kIllegalInterface : kIllegalBaud;
  return on_port("OSInitRS232", interface, failure, kIllegalInterface,
                 [&](hal::SerialPort& port) -> Result<int> {
                   if (!by_code) {
                     return fail(Errc::OutOfRange,
                                 fmt::format("baud code {}, expected SER4800 … SER115200", baud));
                   }
                   return port.open(rate, handshake == RTSCTS).map([] { return 0; });
                 });
}

int OSSendCharRS232(char chr, int interface) {
  return send_byte("OSSendCharRS232", static_cast<std::uint8_t>(chr), interface);
}

int OSSendRS232(char* chr, int interface) {
  if (chr == nullptr) {
    return doing("OSSendRS232", kSendTimeout,
                 [](Session&) -> Result<void> { return robios::null_pointer(); });
  }
  return send_byte("OSSendRS232", static_cast<std::uint8_t>(*chr), interface);
}

int OSRecvRS232(char* buf, int interface) {
  constexpr int kTimedOut = 1;
  constexpr int kStatusError = 2;
  return on_port("OSRecvRS232", interface, kStatusError, kIllegalInterface,
                 [&](hal::SerialPort& port) -> Result<int> {
                   if (buf == nullptr) return robios::null_pointer();
                   Clock& clock = Session::instance().clock();
                   std::uint8_t byte = 0;
                   const Time patience = clock.is_virtual() ? kShortPatience : kByteTime;
                   const Result<std::size_t> got = port.receive({&byte, 1}, patience);
                   if (!got) return tl::unexpected(got.error());
                   if (*got == 1) {
                     *buf = static_cast<char>(byte);
                     return 0;
                   }
                   if (clock.is_virtual()) robios::classic::wait_until(clock.now() + kByteTime);
                   return kTimedOut;
                 });
}

int OSFlushInRS232(int interface) {
  return on_port("OSFlushInRS232", interface, 2, kIllegalInterface,
                 [](hal::SerialPort& port) { return port.flush().map([] { return 0; }); });
}

int OSFlushOutRS232(int interface) {
  return on_port("OSFlushOutRS232", interface, 2, kIllegalInterface, [](hal::SerialPort& port) {
    return port.pending().map([](std::size_t) { return 0; });
  });
}

int OSCheckInRS232(int interface) {
  return on_port("OSCheckInRS232", interface, kLineError, kNoInterface, [](hal::SerialPort& port) {
    return port.pending().map([](std::size_t count) { return static_cast<int>(count); });
  });
}

int OSCheckOutRS232(int interface) {
  return on_port("OSCheckOutRS232", interface, kLineError, kNoInterface, [](hal::SerialPort& port) {
    return port.pending().map([](std::size_t) { return 0; });
  });
}
