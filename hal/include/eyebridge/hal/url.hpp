#pragma once

#include "eyebridge/base/url.hpp"

namespace eyebridge::hal {

/// How a backend is named: "serial:/dev/ttyACM0?profile=io7".
using BackendUrl = Url;

/// parse_url(), under the name that the backends use.
inline BackendUrl parse_backend_url(std::string_view text, const SourceLocation& where) {
  return parse_url(text, where);
}

}  // namespace eyebridge::hal
