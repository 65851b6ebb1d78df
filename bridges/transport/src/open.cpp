#include "eyebridge/bridges/open.hpp"

#include <string>
#include <utility>

#include "eyebridge/base/text.hpp"

namespace eyebridge::bridges {
namespace {

constexpr Scheme<ByteStream> kStreamSchemes[] = {
    {"serial", "serial:DEVICE?baud=115200",
     [](const Url& url, const SourceLocation& where, Clock& clock) {
       return open_serial(serial_settings(url, where), clock);
     }},
    {"tcp", "tcp:HOST:PORT?connect_ms=3000",
     [](const Url& url, const SourceLocation& where, Clock& clock) {
       return open_tcp(tcp_settings(url, where), clock);
     }},
};

constexpr Scheme<CanBus> kBusSchemes[] = {
    {"can", "can:INTERFACE?fd=0&receive_buffer=1048576&ids=11&offset=0",
     [](const Url& url, const SourceLocation& where, Clock& clock) {
       const CanPlace place = can_place(url, where);
       auto bus = open_socket_can(socket_can_settings(url, where), clock);
       if (bus && place != CanPlace{}) bus = std::make_unique<MovedBus>(std::move(*bus), place);
       return bus;
     }},
};

template <class Line>
Result<std::unique_ptr<Line>> open_row(const Url& url, const SourceLocation& where, Clock& clock,
                                       std::span<const Scheme<Line>> schemes) {
  std::string known;
  for (const Scheme<Line>& scheme : schemes) {
    if (scheme.name == url.scheme) return scheme.open(url, where, clock);
    known += (known.empty() ? "" : " or ") + std::string(scheme.summary);
  }
  throw ConfigError(where, "found " + in_quotes(url.scheme + ":") + ", expected " + known);
}

}  // namespace

std::span<const Scheme<ByteStream>> stream_schemes() { return kStreamSchemes; }
std::span<const Scheme<CanBus>> bus_schemes() { return kBusSchemes; }

Result<std::unique_ptr<ByteStream>> open_stream(const Url& url, const SourceLocation& where,
                                                Clock& clock,
                                                std::span<const Scheme<ByteStream>> schemes) {
  return open_row(url, where, clock, schemes);
}

Result<std::unique_ptr<CanBus>> open_bus(const Url& url, const SourceLocation& where, Clock& clock,
                                         std::span<const Scheme<CanBus>> schemes) {
  return open_row(url, where, clock, schemes);
}

}  // namespace eyebridge::bridges
