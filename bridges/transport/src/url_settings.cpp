#include <algorithm>
#include <charconv>
#include <initializer_list>

#include "can_path.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/bridges/open.hpp"

namespace eyebridge::bridges {
namespace {

constexpr std::uint32_t kLastOurs = 0x70F;  // heartbeat of the host: the highest of the protocol

[[noreturn]] void refuse(const SourceLocation& where, std::string_view found,
                         const std::string& expected) {
  throw ConfigError(where, "found " + in_quotes(found) + ", expected " + expected);
}

void allow_options(const Url& url, const SourceLocation& where,
                   std::initializer_list<std::string_view> known) {
  for (const auto& [key, value] : url.options) {
    if (std::ranges::find(known, key) != known.end()) continue;
    std::string list;
    for (const std::string_view name : known)
      list += (list.empty() ? "" : ", ") + std::string(name);
    throw ConfigError(where, "found the option " + in_quotes(key) + ", expected one of " + list);
  }
}

long number(std::string_view text, std::string_view what, long least, long most,
            const SourceLocation& where) {
  long value = 0;
  const char* const end = text.data() + text.size();
  const bool is_hex = text.starts_with("0x");
  const auto [stopped, error] =
      std::from_chars(text.data() + (is_hex ? 2 : 0), end, value, is_hex ? 16 : 10);
  if (text.empty() || error != std::errc{} || stopped != end || value < least || value > most) {
    throw ConfigError(where, "found " + in_quotes(text) + " for " + std::string(what) +
                                 ", expected " + std::to_string(least) + " … " +
                                 std::to_string(most));
  }
  return value;
}

long option(const Url& url, const SourceLocation& where, std::string_view key, long otherwise,
            long least, long most) {
  const auto found = url.options.find(key);
  if (found == url.options.end()) return otherwise;
  return number(found->second, in_quotes(key), least, most, where);
}

bool is_graphic(std::string_view text) {
  // Bytes of other alphabets are graphic, whether char has a sign (x86-64) or not (arm64).
  return std::ranges::none_of(text, [](unsigned char c) { return c <= ' ' || c == 0x7F; });
}

}  // namespace

SerialSettings serial_settings(const Url& url, const SourceLocation& where) {
  allow_options(url, where, {"baud"});
  // Blanks may be part of a file's name, a zero would end it early.
  if (url.rest.empty() || url.rest.find('\0') != std::string::npos) {
    refuse(where, url.scheme + ":" + url.rest,
           "the device of a serial port, as in serial:/dev/ttyACM0");
  }
  SerialSettings settings;
  settings.device = url.rest;
  settings.baud = static_cast<unsigned>(option(url, where, "baud", settings.baud, 50, 12'000'000));
  return settings;
}

TcpSettings tcp_settings(const Url& url, const SourceLocation& where) {
  allow_options(url, where, {"connect_ms"});
  const std::string_view rest = url.rest;
  const std::size_t colon = rest.rfind(':');
  std::string_view host = rest.substr(0, std::min(colon, rest.size()));
  const bool in_brackets = host.size() > 2 && host.starts_with('[') && host.ends_with(']');
  if (in_brackets) host = host.substr(1, host.size() - 2);
  if (colon == std::string_view::npos || host.empty() || !is_graphic(host) ||
      host.find_first_of("[]") != std::string_view::npos ||
      (!in_brackets && host.find(':') != std::string_view::npos)) {
    refuse(where, url.scheme + ":" + url.rest,
           "a host and a port, as in tcp:robot:4711 or tcp:[::1]:4711");
  }
  TcpSettings settings;
  settings.host = host;
  settings.port =
      static_cast<std::uint16_t>(number(rest.substr(colon + 1), "the port", 1, 65535, where));
  settings.connect_timeout = std::chrono::milliseconds(
      option(url, where, "connect_ms", settings.connect_timeout.count(), 1, 600'000));
  return settings;
}

SocketCanSettings socket_can_settings(const Url& url, const SourceLocation& where) {
  allow_options(url, where, {"fd", "receive_buffer", "ids", "offset"});
  constexpr std::size_t kLongestName = 15;  // of any network interface of Linux
  const bool is_path = is_can_path(url.rest) && url.rest.size() <= kLongestCanPath &&
                       url.rest.find('\0') == std::string::npos;
  if (!is_path && (url.rest.empty() || url.rest.size() > kLongestName || !is_graphic(url.rest))) {
    refuse(where, url.scheme + ":" + url.rest,
           "the name of a CAN interface, 1 to " + std::to_string(kLongestName) +
               " characters, as in can:can0, or the path of a bus's socket, at most " +
               std::to_string(kLongestCanPath) + ", as in can:./eyebot.bus");
  }
  SocketCanSettings settings;
  settings.interface = url.rest;
  settings.fd = option(url, where, "fd", 0, 0, 1) == 1;
  settings.receive_buffer = static_cast<int>(
      option(url, where, "receive_buffer", settings.receive_buffer, 4096, 1 << 28));
  return settings;
}

CanPlace can_place(const Url& url, const SourceLocation& where) {
  CanPlace place;
  const long bits = option(url, where, "ids", 11, 11, 29);
  if (bits != 11 && bits != 29) {
    refuse(where, std::to_string(bits), "11 or 29 for 'ids': how many bits identifiers have");
  }
  place.extended = bits == 29;
  const long room = place.last_id() - (place.extended ? CanFrame::kMaxStandardId : kLastOurs);
  place.offset = static_cast<std::uint32_t>(option(url, where, "offset", 0, 0, room));
  return place;
}

}  // namespace eyebridge::bridges
