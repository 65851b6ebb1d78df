#include "radio/radio_setting.hpp"

#include <charconv>

#include <arpa/inet.h>

#include "eyebridge/base/text.hpp"
#include "eyebridge/base/url.hpp"
#include "eyebridge/hal/radio.hpp"

namespace eyebridge::hal {
namespace {

constexpr double kLongestDelay = 3600;  // seconds
constexpr double kLongestRange = 1e6;   // metres

[[noreturn]] void reject(const SourceLocation& where, std::string_view found,
                         const char* expected) {
  throw ConfigError(where, "found " + in_quotes(found) + ", expected " + expected);
}

template <class Number>
bool is_number(std::string_view text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

bool is_address(const std::string& text, in_addr& address) {
  return ::inet_pton(AF_INET, text.c_str(), &address) == 1;
}

void read_target(std::string_view rest, const SourceLocation& where, RadioSetting& out) {
  constexpr const char* kExpected = "udp:GROUP:PORT with a multicast group, as 239.192.7.1:7007";
  const std::size_t colon = rest.rfind(':');
  if (colon == std::string_view::npos) reject(where, rest, kExpected);
  out.group = rest.substr(0, colon);
  in_addr address{};
  if (!is_address(out.group, address) || !IN_MULTICAST(ntohl(address.s_addr)) ||
      !is_number(rest.substr(colon + 1), out.port) || out.port == 0) {
    reject(where, rest, kExpected);
  }
}

double read_share(const std::string& value, std::string_view key, const SourceLocation& where) {
  double percent = 0;
  const std::string_view digits =
      std::string_view(value).substr(0, value.find_last_not_of('%') + 1);
  if (digits.size() + 1 != value.size() || !is_number(digits, percent) ||
      !(percent >= 0 && percent <= 100)) {
    throw ConfigError(where, "found " + in_quotes(value) +
                                 ", expected a share of the messages, 0% to 100%, for '" +
                                 std::string(key) + "'");
  }
  return percent / 100;
}

Time read_time(const std::string& value, std::string_view key, const SourceLocation& where) {
  const double seconds = parse_duration(value, where);
  if (seconds > kLongestDelay) {
    throw ConfigError(where, "found " + in_quotes(value) + ", expected at most an hour for '" +
                                 std::string(key) + "'");
  }
  return from_seconds(seconds);
}

/// "5m" or "5".
double read_range(std::string_view value, const SourceLocation& where) {
  double metres = 0;
  const std::string_view digits = value.ends_with('m') ? value.substr(0, value.size() - 1) : value;
  if (is_number(digits, metres) && metres >= 0 && metres <= kLongestRange) return metres;
  reject(where, value, "metres, 0 (no limit) to 1e6, for 'range'");
}

void read_option(std::string_view key, const std::string& value, const SourceLocation& where,
                 RadioSetting& out) {
  if (key == "id") {
    int id = 0;
    if (!is_number(value, id) || id < Radio::kFirstId || id > Radio::kLastId) {
      reject(where, value, "the number of a robot, 1 … 255, for 'id'");
    }
    out.id = id;
  } else if (key == "loss") {
    out.loss = read_share(value, key, where);
  } else if (key == "corrupt") {
    out.corrupt = read_share(value, key, where);
  } else if (key == "delay") {
    out.delay = read_time(value, key, where);
  } else if (key == "jitter") {
    out.jitter = read_time(value, key, where);
  } else if (key == "range" && out.medium == RadioSetting::Medium::World) {
    out.range = read_range(value, where);
  } else if (key == "interface" && out.medium == RadioSetting::Medium::Udp) {
    in_addr address{};
    if (!is_address(value, address)) reject(where, value, "an IPv4 address for 'interface'");
    out.interface = value;
  } else {
    reject(where, key,
           "one of the options id, loss, delay, jitter, corrupt, of world: range, and of udp: "
           "interface");
  }
}

}  // namespace

RadioSetting parse_radio(std::string_view text, const SourceLocation& where) {
  const Url url = parse_url(text, where);
  RadioSetting setting;
  if (url.scheme == "udp") {
    setting.medium = RadioSetting::Medium::Udp;
    read_target(url.rest, where, setting);
  } else if (!url.rest.empty() || (url.scheme != "world" && url.scheme != "none")) {
    reject(where, text, "world, none or udp:GROUP:PORT");
  }
  if (url.scheme == "none") {
    setting.medium = RadioSetting::Medium::None;
    if (!url.options.empty()) reject(where, text, "none without options");
  }
  for (const auto& [key, value] : url.options) read_option(key, value, where, setting);
  return setting;
}

}  // namespace eyebridge::hal
