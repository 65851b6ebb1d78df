#pragma once

#include <map>
#include <string>
#include <string_view>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge {

/// How a backend or a link is named: "serial:/dev/ttyACM0?profile=io7".
struct Url {
  std::string scheme;  ///< "serial"; lower-case letters and digits.
  std::string rest;    ///< "/dev/ttyACM0"; may be empty.
  std::map<std::string, std::string, std::less<>> options;  ///< {"profile", "io7"}

  friend bool operator==(const Url&, const Url&) = default;
};

/// Parses "scheme", "scheme:rest" or "scheme:rest?key=value&key=value". Throws ConfigError at
/// `where`: no scheme, odd characters in it, an option without key or '=', or one given twice.
Url parse_url(std::string_view text, const SourceLocation& where);

}  // namespace eyebridge
