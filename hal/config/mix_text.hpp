#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::hal {

/// A kind of device, and the backend that its devices are taken from.
struct MixEntry {
  std::string device;  ///< One of kDeviceKinds, or "camera".
  std::string url;     ///< As --hal takes it.

  friend bool operator==(const MixEntry&, const MixEntry&) = default;
};

/// Reads "psd=sim; drive=serial:/dev/ttyACM0": what a [mix] table of eyebridge.toml says, in one
/// line. Throws ConfigError at `where`, with the column of the entry where that has none: no such
/// device, one that is named twice, or what is no URL.
std::vector<MixEntry> parse_mix(std::string_view text, const SourceLocation& where);

}  // namespace eyebridge::hal
