#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "eyebridge/base/result.hpp"
#include "eyebridge/base/url.hpp"
#include "machine/can_state.hpp"

namespace eyebridge::apps {

/// What `eyebridge probe` is to look at.
struct ProbeTarget {
  std::string url;  ///< As --hal takes it.
  Url line;         ///< The same without the options that are no line's (profile, hdt, node).
  int node = 0;     ///< The robot that is meant on a CAN bus; 0: all.
};

/// Reads "/dev/ttyACM0", "./eyebot.tty", "can0", or a URL serial:, tcp:, can:. Throws ConfigError.
ProbeTarget probe_target(const std::string& device);

/// Why the serial port `device` could not be opened, and what to do: one line that names it. `root`
/// is the folder that counts as "/".
std::string why_not_opened(const std::string& device, const Error& error,
                           const std::filesystem::path& root = "/");
/// The same of a CAN interface.
std::string why_not_opened(const CanState& state, const std::string& name, const Error& error);

/// What could be better about the port, a line each.
std::vector<std::string> advice_on(const std::string& device);

}  // namespace eyebridge::apps
