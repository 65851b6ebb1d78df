#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/hal/config.hpp"

namespace eyebridge::hal {

/// One "key = value" of an eyebridge.toml; the place is that of the value.
struct TomlEntry {
  const Setting* setting = nullptr;  ///< Never null.
  ConfigValue value;
};

/// The settings in `text`, named `file` in messages. Throws ConfigError: bad syntax, an unknown
/// key, a value of the wrong TOML type or not allowed by its setting.
std::vector<TomlEntry> read_toml(std::string_view text, const std::string& file);

/// The text of `path`, or nothing when there is no such file. Throws ConfigError when it cannot be
/// read or is bigger than kMaxTomlSize.
std::optional<std::string> read_toml_file(const std::filesystem::path& path);
inline constexpr std::size_t kMaxTomlSize = 1U << 20U;

}  // namespace eyebridge::hal
