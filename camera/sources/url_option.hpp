#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace eyebridge::camera {

/// A URL without an option that every source's may have, and what that option said.
struct TakenOption {
  std::string url;
  std::optional<std::string> value;
};

/// Takes `key` out of the options of `url`. Throws ConfigError at "--camera" when it is empty or
/// given twice, naming `form`, "calibration=FILE".
TakenOption take_option(const std::string& url, std::string_view key, std::string_view form);

}  // namespace eyebridge::camera
