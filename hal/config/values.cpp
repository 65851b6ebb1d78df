#include "config/values.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace eyebridge::hal {
namespace {

/// Takes a number off the front of `text`; false when there is none that is finite.
template <class Number>
bool take_number(std::string_view& text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return false;
  if constexpr (std::is_floating_point_v<Number>) {
    if (!std::isfinite(value)) return false;
  }
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

bool is_choice(std::string_view choices, std::string_view text) {
  while (!choices.empty()) {
    const std::size_t bar = std::min(choices.find('|'), choices.size());
    if (choices.substr(0, bar) == text) return true;
    choices.remove_prefix(std::min(bar + 1, choices.size()));
  }
  return false;
}

void check_range(const Setting& setting, double value, const ConfigValue& read) {
  if (value >= setting.minimum && value <= setting.maximum) return;
  const std::string_view unit = setting.kind == Setting::Kind::Duration ? " s"
                                : setting.kind == Setting::Kind::Size   ? " pixels each way"
                                                                        : "";
  const std::string expected =
      std::isinf(setting.maximum)
          ? fmt::format("at least {}{}", setting.minimum, unit)
          : fmt::format("{} … {}{}", setting.minimum, setting.maximum, unit);
  throw ConfigError(read.where, fmt::format("found {} for '{}', expected {}", in_quotes(read.text),
                                            setting.key, expected));
}

}  // namespace

bool parse_boolean(std::string_view text, const SourceLocation& where) {
  const std::string_view word = trimmed(text);
  for (const std::string_view yes : {"true", "yes", "on", "1"}) {
    if (word == yes) return true;
  }
  for (const std::string_view no : {"false", "no", "off", "0"}) {
    if (word == no) return false;
  }
  throw ConfigError(where, fmt::format("found {}, expected true or false", in_quotes(text)));
}

long long parse_integer(std::string_view text, const SourceLocation& where) {
  std::string_view rest = trimmed(text);
  long long value = 0;
  if (take_number(rest, value) && rest.empty()) return value;
  throw ConfigError(where, fmt::format("found {}, expected a whole number", in_quotes(text)));
}

double parse_number(std::string_view text, const SourceLocation& where) {
  std::string_view rest = trimmed(text);
  double value = 0.0;
  if (take_number(rest, value) && rest.empty()) return value;
  throw ConfigError(where, fmt::format("found {}, expected a number", in_quotes(text)));
}

ConfigError error_in(const ConfigValue& value, const ConfigError& error) {
  SourceLocation where = value.where;
  if (where.line == 0) {
    where.line = error.where().line;
    where.column = error.where().column;
  }
  return {where, error.text()};
}

PixelSize parse_size(std::string_view text, const SourceLocation& where) {
  std::string_view rest = trimmed(text);
  PixelSize size;
  if (take_number(rest, size.width) && rest.starts_with('x')) {
    rest.remove_prefix(1);
    if (take_number(rest, size.height) && rest.empty()) return size;
  }
  throw ConfigError(where, fmt::format("found {}, expected WIDTHxHEIGHT in pixels, such as 560x400",
                                       in_quotes(text)));
}

void check_value(const Setting& setting, const ConfigValue& value) {
  if (value.text.empty() && setting.fallback.empty()) return;
  switch (setting.kind) {
    case Setting::Kind::Text:
    case Setting::Kind::NumberOrText:
    case Setting::Kind::Path:
      if (value.text.empty()) {
        throw ConfigError(value.where, fmt::format("found nothing for '{}', expected {}",
                                                   setting.key, setting.help));
      }
      if (value.text.find('\0') != std::string::npos) {
        throw ConfigError(value.where, fmt::format("found a zero byte in the value of '{}', "
                                                   "expected text",
                                                   setting.key));
      }
      if (!setting.choices.empty() && !is_choice(setting.choices, value.text)) {
        throw ConfigError(
            value.where, fmt::format("found {} for '{}', expected one of {}", in_quotes(value.text),
                                     setting.key, setting.choices));
      }
      break;
    case Setting::Kind::Boolean:
      parse_boolean(value.text, value.where);
      break;
    case Setting::Kind::Integer:
      check_range(setting, static_cast<double>(parse_integer(value.text, value.where)), value);
      break;
    case Setting::Kind::Number:
      check_range(setting, parse_number(value.text, value.where), value);
      break;
    case Setting::Kind::Duration:
      check_range(setting, parse_duration(value.text, value.where), value);
      break;
    case Setting::Kind::Size:
      check_range(setting, parse_size(value.text, value.where).width, value);
      check_range(setting, parse_size(value.text, value.where).height, value);
      break;
  }
}

ConfigError unknown_key(std::string_view what, std::string_view key, const SourceLocation& where) {
  return {where, fmt::format("unknown {} {}, the nearest setting is '{}'", what, in_quotes(key),
                             nearest_key(key))};
}

}  // namespace eyebridge::hal
