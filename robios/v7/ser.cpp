#include <algorithm>
#include <cstring>
#include <string>

#include <fmt/format.h>

#include "eyebot.h"
#include "guarded.hpp"
#include "program_threads.hpp"

namespace {

using namespace eyebridge;
using robios::Session;

// How long a wait leaves the end of the run unnoticed.
constexpr Time kSerialSlice = std::chrono::milliseconds(20);
constexpr int kMostAtOnce = 65536;

template <class Value, class Body>
Value with_port(const robios::Call& call, int id, Value failure, Body&& body) {
  return robios::guarded(call, failure, [&](Session& session) -> Result<Value> {
    hal::SerialPort* port = session.backend().serial_port(id);
    if (port == nullptr) {
      return fail(
          Errc::OutOfRange,
          fmt::format("no serial interface {}; --serial \"{}=/dev/ttyUSB0\" names its device", id,
                      std::clamp(id, 0, 20)));
    }
    return body(*port, session);
  });
}

int send(const robios::Call& call, int id, const char* text, std::size_t length) {
  return with_port(call, id, 1, [&](hal::SerialPort& port, Session&) -> Result<int> {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(text);
    return port.send({bytes, length}).map([] { return 0; });
  });
}

int refuse(const robios::Call& call, const Error& error) {
  return robios::guarded(call, 1, [&](Session&) -> Result<int> { return tl::unexpected(error); });
}

}  // namespace

// In brackets: the header has macros of these names.

int(SERInit)(int interface, int baud, int handshake) {
  return with_port("SERInit", interface, 1, [&](hal::SerialPort& port, Session&) -> Result<int> {
    if (handshake != 0 && handshake != 1) {
      return fail(Errc::OutOfRange,
                  fmt::format("handshake {}, expected NONE or RTSCTS", handshake));
    }
    return port.open(baud, handshake == 1).map([] { return 0; });
  });
}

int SERSendChar(int interface, char ch) { return send("SERSendChar", interface, &ch, 1); }

int SERSend(int interface, const char* buf) {
  if (buf == nullptr) return refuse("SERSend", robios::null_pointer().value());
  return send("SERSend", interface, buf, std::strlen(buf));
}

int EYEBRIDGESend(int interface, const char* buf, int size) {
  if (buf == nullptr) return refuse("SERSend", robios::null_pointer().value());
  if (size < 0) return refuse("SERSend", {Errc::OutOfRange, fmt::format("size {}", size)});
  return send("SERSend", interface, buf, static_cast<std::size_t>(size));
}

char SERReceiveChar(int interface) {
  return with_port("SERReceiveChar", interface, '\0',
                   [](hal::SerialPort& port, Session& session) -> Result<char> {
                     std::uint8_t byte = 0;
                     while (session.may_call("SERReceiveChar")) {
                       const auto count = robios::while_away([&] {
                         return port.receive({&byte, 1}, kSerialSlice);
                       });
                       if (!count) return tl::unexpected(count.error());
                       if (*count == 1) return static_cast<char>(byte);
                     }
                     return fail(Errc::Timeout, "the run has ended");
                   });
}

int SERReceive(int interface, char* buf, int size) {
  return with_port("SERReceive", interface, 0, [&](hal::SerialPort& port, Session&) -> Result<int> {
    if (buf == nullptr) return robios::null_pointer();
    if (size < 1) return fail(Errc::OutOfRange, fmt::format("size {}, expected at least 1", size));
    const auto room = static_cast<std::size_t>(std::min(size, kMostAtOnce));
    auto* bytes = reinterpret_cast<std::uint8_t*>(buf);
    return port.receive({bytes, room}, Time{0}).map([&](std::size_t count) {
      if (count < static_cast<std::size_t>(size)) buf[count] = '\0';
      return static_cast<int>(count);
    });
  });
}

bool SERCheck(int interface) {
  return with_port("SERCheck", interface, false,
                   [](hal::SerialPort& port, Session&) -> Result<bool> {
                     return port.pending().map([](std::size_t count) { return count > 0; });
                   });
}

int SERFlush(int interface) {
  return with_port("SERFlush", interface, 1, [](hal::SerialPort& port, Session&) -> Result<int> {
    return port.flush().map([] { return 0; });
  });
}

int SERClose(int interface) {
  return with_port("SERClose", interface, 1, [](hal::SerialPort& port, Session&) -> Result<int> {
    return port.close().map([] { return 0; });
  });
}
