#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "eyebridge/base/url.hpp"
#include "eyebridge/bridges/byte_stream.hpp"
#include "eyebridge/bridges/can_bus.hpp"
#include "eyebridge/bridges/moved_bus.hpp"
#include "eyebridge/bridges/serial.hpp"
#include "eyebridge/bridges/socket_can.hpp"
#include "eyebridge/bridges/tcp.hpp"

namespace eyebridge::bridges {

/// One kind of line that a URL can name.
template <class Line>
struct Scheme {
  std::string_view name;     ///< "serial"
  std::string_view summary;  ///< One line for lists and messages: "serial:DEVICE?baud=115200".
  /// Opens what `url` names. Throws ConfigError at `where` when the URL is wrong; returns the
  /// error when the URL is right but the line cannot be opened now.
  Result<std::unique_ptr<Line>> (*open)(const Url& url, const SourceLocation& where, Clock& clock);
};

// What a URL of each scheme says. They throw ConfigError at `where`: what was found, what was
// expected. Whatever the scheme of `url` is, only the rest and the options are looked at.
SerialSettings serial_settings(const Url& url, const SourceLocation& where);
TcpSettings tcp_settings(const Url& url, const SourceLocation& where);
SocketCanSettings socket_can_settings(const Url& url, const SourceLocation& where);
CanPlace can_place(const Url& url, const SourceLocation& where);

/// serial:DEVICE?baud=115200 and tcp:HOST:PORT?connect_ms=3000.
std::span<const Scheme<ByteStream>> stream_schemes();
/// can:INTERFACE?fd=0&receive_buffer=1048576&ids=11&offset=0.
std::span<const Scheme<CanBus>> bus_schemes();

/// Opens what `url` names, one row of `schemes`. Options that no row of the table knows are
/// mistakes: who has options of his own (profile, node) takes them out of `url` before.
Result<std::unique_ptr<ByteStream>> open_stream(
    const Url& url, const SourceLocation& where, Clock& clock,
    std::span<const Scheme<ByteStream>> schemes = stream_schemes());
Result<std::unique_ptr<CanBus>> open_bus(const Url& url, const SourceLocation& where, Clock& clock,
                                         std::span<const Scheme<CanBus>> schemes = bus_schemes());

}  // namespace eyebridge::bridges
