#include "target.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include <fmt/format.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/text.hpp"
#include "machine/holders.hpp"
#include "machine/serial_ports.hpp"
#include "opcodes.h"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExpected =
    "expected a device such as /dev/ttyACM0, or serial:DEVICE, tcp:HOST:PORT, can:INTERFACE";

bool is_path(const std::string& text) {
  return text.starts_with('/') || text.starts_with("./") || text.starts_with("../");
}

int node_number(const std::string& text, const SourceLocation& where) {
  int node = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), node);
  if (error == std::errc{} && end == text.data() + text.size() && node >= EYECAN_NODE_FIRST &&
      node <= EYECAN_NODE_LAST) {
    return node;
  }
  throw ConfigError(where,
                    fmt::format("found {} for 'node', expected the number of a robot, {} … {}",
                                in_quotes(text), EYECAN_NODE_FIRST, EYECAN_NODE_LAST));
}

}  // namespace

ProbeTarget probe_target(const std::string& device) {
  const SourceLocation where{device};
  std::string url = device;
  std::error_code ignored;
  if (is_path(device)) {
    url = "serial:" + device;
  } else if (device.find(':') == std::string::npos) {
    // A bare word: a file here, as eyebot.tty; else an interface, as can0.
    url = (fs::exists(device, ignored) ? "serial:" : "can:") + device;
  }
  ProbeTarget target{url, parse_url(url, where)};
  const std::string& scheme = target.line.scheme;
  if (scheme != "serial" && scheme != "tcp" && scheme != "can") {
    throw ConfigError(where, std::string("found another kind of device, ") + kExpected);
  }
  auto& options = target.line.options;
  if (scheme == "can") {
    if (const auto node = options.find("node"); node != options.end()) {
      target.node = node_number(node->second, where);
    }
    options.erase("node");
  } else {
    options.erase("profile");
  }
  options.erase("hdt");
  return target;
}

std::string why_not_opened(const std::string& device, const Error& error, const fs::path& root) {
  std::error_code ignored;
  const std::string full = fs::absolute(device).string();
  if (!fs::exists(below(root, full), ignored)) {
    std::string others;
    for (const SerialPort& port : look_at_serial(root).ports) others += " " + port.device;
    return device + ": no such device; expected " +
           (others.empty() ? "a board that is plugged in (none is)" : "one of" + others);
  }
  const SerialPort port = look_at_port(without_links(full, root), root);
  if (!port.access.permitted) return device + ": permission denied; " + how_to_be_permitted(port);
  if (port.holders.empty()) return error.what;
  const bool is_manager =
      std::ranges::find(port.holders, "ModemManager", &Process::name) != port.holders.end();
  return error.what + ": it is open in " + listed(port.holders) +
         (is_manager ? ", which tries new ports for some seconds; the rule of eyebridge doctor "
                       "--udev keeps it away"
                     : "");
}

std::string why_not_opened(const CanState& state, const std::string& name, const Error& error) {
  if (error.code == Errc::Unsupported && state.raw_error == 0) return error.what;
  const std::string reason = why_no_can(state, name);
  return reason.empty() ? error.what : name + ": " + reason;
}

std::vector<std::string> advice_on(const std::string& device) {
  SerialState state = look_at_serial();
  const std::string real = without_links(fs::absolute(device).string());
  for (SerialPort& port : state.ports) {
    if (port.device != real) continue;
    port.holders.clear();  // that is us
    return judge_port(port, state).advice;
  }
  return {};
}

}  // namespace eyebridge::apps
