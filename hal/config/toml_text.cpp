#include "config/toml_text.hpp"

#include <fmt/format.h>

#include "config/mix_text.hpp"
#include "config/toml_ascii.hpp"
#include "config/toml_document.hpp"
#include "config/values.hpp"
#include "eyebridge/base/read_file.hpp"

namespace eyebridge::hal {
namespace {

/// A table of texts as the one text "key=value; key=value" that the setting takes elsewhere.
std::string flattened(const toml::table& table, std::string_view setting,
                      const TomlDocument& document) {
  std::string out;
  for (const auto& [key, node] : table) {
    const auto* text = node.as_string();
    if (text == nullptr) {
      throw ConfigError(document.place(node),
                        fmt::format("found {} for '{}.{}', expected a text in quotes",
                                    found_type(node), setting, from_ascii(key.str())));
    }
    const std::string entry = fmt::format("{}={}", key.str(), text->get());
    if (entry.find_first_of(";\n") != std::string::npos) {
      throw ConfigError(document.place(node),
                        fmt::format("found a ';' or line end in '{}.{}', expected none", setting,
                                    from_ascii(key.str())));
    }
    parse_mix(from_ascii(entry), document.place(key.source().begin));
    out += (out.empty() ? "" : "; ") + entry;
  }
  return out;
}

TomlEntry read_entry(const toml::key& key, const toml::node& node, const TomlDocument& document) {
  const Setting* setting = find_setting(key.str());
  if (setting == nullptr) {
    throw unknown_key(node.is_table() ? "table" : "key", from_ascii(key.str()),
                      document.place(key.source().begin));
  }
  const auto* entries = node.as_table();
  if (entries == nullptr || setting->key != "mix") {
    return {setting, setting_value(*setting, node, document)};
  }
  const ConfigValue value{from_ascii(flattened(*entries, setting->key, document)),
                          document.place(node)};
  check_value(*setting, value);
  return {setting, value};
}

}  // namespace

std::vector<TomlEntry> read_toml(std::string_view text, const std::string& file) {
  const TomlDocument document = read_toml_document(text, file);
  std::vector<TomlEntry> entries;
  for (const auto& [key, node] : document.table) {
    entries.push_back(read_entry(key, node, document));
  }
  return entries;
}

std::optional<std::string> read_toml_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) return std::nullopt;
  auto text = read_file(path, kMaxTomlSize);
  if (!text) throw ConfigError({path.string()}, text.error().what + ": expected a TOML file");
  return std::move(*text);
}

}  // namespace eyebridge::hal
