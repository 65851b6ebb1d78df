#include "config/toml_document.hpp"

#include <filesystem>
#include <optional>
#include <system_error>

#include <fmt/format.h>

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
    case Setting::Kind::NumberOrText:
      return "a whole number, or a text in quotes";
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

/// `node` as text, when it is of a TOML type that `kind` takes.
std::optional<std::string> text_of(const toml::node& node, Setting::Kind kind) {
  const bool is_number = kind == Setting::Kind::Number || kind == Setting::Kind::Duration;
  if (const auto* text = node.as_string()) {
    if (kind == Setting::Kind::Text || kind == Setting::Kind::NumberOrText ||
        kind == Setting::Kind::Path || kind == Setting::Kind::Duration ||
        kind == Setting::Kind::Size) {
      return text->get();
    }
  }
  if (const auto* flag = node.as_boolean(); flag != nullptr && kind == Setting::Kind::Boolean) {
    return flag->get() ? "true" : "false";
  }
  if (const auto* whole = node.as_integer();
      whole != nullptr &&
      (is_number || kind == Setting::Kind::Integer || kind == Setting::Kind::NumberOrText)) {
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

}  // namespace

SourceLocation TomlDocument::place(const toml::source_position& at) const {
  return original_place(ascii, {file, static_cast<int>(at.line), static_cast<int>(at.column)});
}

TomlDocument read_toml_document(std::string_view text, const std::string& file) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  TomlDocument document{file, to_ascii(text, file), {}};
  try {
    check_table_names(document.ascii, file);
  } catch (const ConfigError& error) {
    throw ConfigError(original_place(document.ascii, error.where()), error.text());
  }
  try {
    document.table = toml::parse(std::string_view(document.ascii), file);
  } catch (const toml::parse_error& error) {
    throw ConfigError(document.place(error.source().begin), from_ascii(error.description()));
  }
  return document;
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

ConfigValue setting_value(const Setting& setting, const toml::node& node,
                          const TomlDocument& document) {
  const std::optional<std::string> ascii = text_of(node, setting.kind);
  if (!ascii) {
    throw ConfigError(document.place(node),
                      fmt::format("found {} for '{}', expected {}", found_type(node), setting.key,
                                  expected_type(setting.kind)));
  }
  ConfigValue value{from_ascii(*ascii), document.place(node)};
  check_value(setting, value);
  if (setting.kind == Setting::Kind::Path && !value.text.empty()) {
    value.text = from_folder_of(document.file, value.text);
  }
  // "./beep --loud": a program with a slash in its name is meant from here, wherever it is started.
  const std::string program = value.text.substr(0, value.text.find_first_of(" \t\n"));
  if (setting.effect == Setting::Effect::Starts && program.find('/') != std::string::npos) {
    std::error_code no_folder;
    const auto full = std::filesystem::absolute(from_folder_of(document.file, program), no_folder);
    value.text.replace(0, program.size(), full.lexically_normal().string());
  }
  return value;
}

}  // namespace eyebridge::hal
