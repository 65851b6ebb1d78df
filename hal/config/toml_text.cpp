#include "config/toml_text.hpp"

#include <fstream>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "config/mix_text.hpp"
#include "config/toml_ascii.hpp"
#include "config/values.hpp"
#include "eyebridge/base/toml_names.hpp"

namespace eyebridge::hal {
namespace {

std::string_view expected_type(Setting::Kind kind) {
  switch (kind) {
    case Setting::Kind::Text:
    case Setting::Kind::Path:
      return "a text in quotes";
    case Setting::Kind::Boolean:
      return "true or false";
    case Setting::Kind::Integer:
      return "a whole number";
    case Setting::Kind::Number:
      return "a number";
    case Setting::Kind::Size:
      return "a text such as \"560x400\"";
    case Setting::Kind::Duration:
      return "a duration such as \"250ms\", or a number of seconds";
  }
  return "";
}

std::string_view found_type(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "a text";
    case toml::node_type::integer:
      return "a whole number";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

/// `node` as text, when it is of a TOML type that `kind` takes.
std::optional<std::string> text_of(const toml::node& node, Setting::Kind kind) {
  const bool is_number = kind == Setting::Kind::Number || kind == Setting::Kind::Duration;
  if (const auto* text = node.as_string()) {
    if (kind == Setting::Kind::Text || kind == Setting::Kind::Path ||
        kind == Setting::Kind::Duration || kind == Setting::Kind::Size) {
      return text->get();
    }
  }
  if (const auto* flag = node.as_boolean(); flag != nullptr && kind == Setting::Kind::Boolean) {
    return flag->get() ? "true" : "false";
  }
  if (const auto* whole = node.as_integer();
      whole != nullptr && (is_number || kind == Setting::Kind::Integer)) {
    return fmt::format("{}", whole->get());
  }
  if (const auto* number = node.as_floating_point(); number != nullptr && is_number) {
    return fmt::format("{}", number->get());
  }
  return std::nullopt;
}

std::string from_folder_of(const std::string& file, const std::string& path) {
  const std::filesystem::path written(path);
  return written.is_absolute() ? path
                               : (std::filesystem::path(file).parent_path() / written).string();
}

/// A text that toml++ was given in ASCII, and its name.
struct Source {
  const std::string& ascii;
  const std::string& file;

  [[nodiscard]] SourceLocation place(const toml::source_position& at) const {
    return original_place(ascii, {file, static_cast<int>(at.line), static_cast<int>(at.column)});
  }
};

/// A table of texts as the one text "key=value; key=value" that the setting takes elsewhere.
std::string flattened(const toml::table& table, std::string_view setting, const Source& source) {
  std::string out;
  for (const auto& [key, node] : table) {
    const auto* text = node.as_string();
    if (text == nullptr) {
      throw ConfigError(source.place(node.source().begin),
                        fmt::format("found {} for '{}.{}', expected a text in quotes",
                                    found_type(node), setting, from_ascii(key.str())));
    }
    const std::string entry = fmt::format("{}={}", key.str(), text->get());
    if (entry.find_first_of(";\n") != std::string::npos) {
      throw ConfigError(source.place(node.source().begin),
                        fmt::format("found a ';' or line end in '{}.{}', expected none", setting,
                                    from_ascii(key.str())));
    }
    parse_mix(from_ascii(entry), source.place(key.source().begin));
    out += (out.empty() ? "" : "; ") + entry;
  }
  return out;
}

TomlEntry read_entry(const toml::key& key, const toml::node& node, const Source& source) {
  const SourceLocation where = source.place(node.source().begin);
  const Setting* setting = find_setting(key.str());
  if (setting == nullptr) {
    throw unknown_key(node.is_table() ? "table" : "key", from_ascii(key.str()),
                      source.place(key.source().begin));
  }
  std::optional<std::string> ascii = text_of(node, setting->kind);
  if (const auto* entries = node.as_table(); entries != nullptr && setting->key == "mix") {
    ascii = flattened(*entries, setting->key, source);
  }
  if (!ascii) {
    throw ConfigError(where, fmt::format("found {} for '{}', expected {}", found_type(node),
                                         setting->key, expected_type(setting->kind)));
  }
  std::string text = from_ascii(*ascii);
  check_value(*setting, {text, where});
  if (setting->kind == Setting::Kind::Path && !text.empty()) {
    text = from_folder_of(source.file, text);
  }
  return {setting, {text, where}};
}

}  // namespace

std::vector<TomlEntry> read_toml(std::string_view text, const std::string& file) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const std::string ascii = to_ascii(text, file);
  const Source source{ascii, file};
  try {
    check_table_names(ascii, file);
  } catch (const ConfigError& error) {
    throw ConfigError(original_place(ascii, error.where()), error.text());
  }
  toml::table table;
  try {
    table = toml::parse(std::string_view(ascii), file);
  } catch (const toml::parse_error& error) {
    throw ConfigError(source.place(error.source().begin), from_ascii(error.description()));
  }
  std::vector<TomlEntry> entries;
  for (const auto& [key, node] : table) entries.push_back(read_entry(key, node, source));
  return entries;
}

std::optional<std::string> read_toml_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) return std::nullopt;
  const SourceLocation where{path.string()};
  if (!std::filesystem::is_regular_file(status)) {
    throw ConfigError(where, error ? fmt::format("cannot be reached: {}", error.message())
                                   : std::string("found no ordinary file, expected a TOML file"));
  }
  std::ifstream in(path, std::ios::binary);
  std::string text(kMaxTomlSize + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!in.is_open() || in.bad()) throw ConfigError(where, "cannot be read");
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > kMaxTomlSize) {
    throw ConfigError(where, fmt::format("is too big, expected at most {} bytes", kMaxTomlSize));
  }
  return text;
}

}  // namespace eyebridge::hal
