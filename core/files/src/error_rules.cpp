#include "eyebridge/files/error_rules.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "error_parameters.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

[[noreturn]] void reject(const SourceLocation& where, const std::string& text) {
  throw ConfigError(where, text);
}

/// `word` from its byte `at` on.
ErrorWord tail(const ErrorWord& word, std::size_t at) {
  ErrorWord out{word.text.substr(at), word.where};
  if (out.where.column > 0) out.where.column += static_cast<int>(at);
  return out;
}

/// A number from 1 on, after the ':' of "psd:2" or "robot:2".
int read_number(const ErrorWord& word, std::string_view what) {
  int number = 0;
  const char* const end = word.text.data() + word.text.size();
  const auto [stop, error] = std::from_chars(word.text.data(), end, number);
  if (error == std::errc{} && stop == end && number >= 1) return number;
  reject(word.where, in_quotes(word.text) + " found: expected the number of a " +
                         std::string(what) + ", 1 or more");
}

const ErrorKind& find_kind(const ErrorWord& word, bool may_be_preset) {
  std::vector<std::string_view> names;
  for (const ErrorKind& kind : error_kinds()) {
    if (kind.name == lower(word.text)) return kind;
    names.push_back(kind.name);
  }
  if (may_be_preset) {
    names.insert(names.end(), robot::kErrorPresets.begin(), robot::kErrorPresets.end());
  }
  const std::string_view near = nearest(word.text, names);
  reject(word.where, "unknown error model " + in_quotes(word.text) + ": expected " +
                         (near.empty() ? one_of(names) : in_quotes(near) + "?"));
}

std::string in_unit(const ErrorParameter& parameter) {
  return parameter.unit.empty() ? "a number" : "a number in " + std::string(parameter.unit);
}

double read_value(const ErrorWord& word, const ErrorKind& kind, const ErrorParameter& parameter) {
  double value = 0;
  const char* const end = word.text.data() + word.text.size();
  const bool has_plus = word.text.size() > 1 && word.text[0] == '+' && word.text[1] != '-';
  const auto [stop, error] = std::from_chars(word.text.data() + (has_plus ? 1 : 0), end, value);
  const std::string_view unit(stop, static_cast<std::size_t>(end - stop));
  const std::string name = std::string(kind.name) + "'s " + std::string(parameter.name);
  if (error != std::errc{} || !std::isfinite(value) || (!unit.empty() && unit != parameter.unit)) {
    reject(word.where,
           in_quotes(word.text) + " found: expected " + name + ", " + in_unit(parameter));
  }
  if (value < parameter.low || value > parameter.high) {
    reject(word.where, name + " is " + std::string(word.text) + ": expected " +
                           decimal(parameter.low) + " to " + decimal(parameter.high) +
                           (parameter.unit.empty() ? "" : " " + std::string(parameter.unit)));
  }
  return value / parameter.divisor;
}

/// "sigma=4" or "quantised".
std::pair<const ErrorParameter*, double> read_named(const ErrorWord& word, const ErrorKind& kind) {
  const std::size_t equals = std::min(word.text.find('='), word.text.size());
  const std::string name = lower(word.text.substr(0, equals));
  std::vector<std::string_view> names;
  for (const ErrorParameter& parameter : kind.parameters) {
    names.push_back(parameter.name);
    if (parameter.name != name) continue;
    const bool is_flag = parameter.unit == "flag";
    if (is_flag && equals == word.text.size()) return {&parameter, 1.0};
    if (!is_flag && equals != word.text.size()) {
      return {&parameter, read_value(tail(word, equals + 1), kind, parameter)};
    }
    reject(word.where, in_quotes(word.text) + " found: expected " +
                           (is_flag ? std::string(parameter.name) + " alone"
                                    : std::string(parameter.name) + "=" + in_unit(parameter)));
  }
  const std::string_view near = nearest(name, names);
  reject(word.where, in_quotes(word.text) + " found: expected " +
                         (near.empty() ? one_of(names) : in_quotes(near) + "?"));
}

bool looks_like_number(std::string_view text) {
  return !text.empty() && std::string_view("+-.0123456789").find(text[0]) != std::string_view::npos;
}

}  // namespace

ErrorRule read_error_rule(std::span<const ErrorWord> words, const SourceLocation& end) {
  ErrorRule rule;
  rule.where = words.front().where;
  constexpr std::string_view kRobot = "robot:";
  if (lower(words.front().text).starts_with(kRobot)) {
    rule.robot = read_number(tail(words.front(), kRobot.size()), "robot");
    words = words.subspan(1);
    if (words.empty()) reject(end, "the rule ends: expected a preset or an error model");
  }
  rule.preset = robot::error_preset(lower(words.front().text));
  if (rule.preset) {
    if (words.size() == 1) return rule;
    reject(words[1].where, in_quotes(words[1].text) + " found after a preset: expected nothing");
  }
  ErrorWord kind = words.front();
  const std::size_t colon = std::min(kind.text.find(':'), kind.text.size());
  kind.text = kind.text.substr(0, colon);
  rule.kind = &find_kind(kind, colon == words.front().text.size());
  if (colon < words.front().text.size()) {
    if (!rule.kind->numbered) {
      reject(words.front().where, in_quotes(words.front().text) + " found: expected " +
                                      std::string(rule.kind->name) + " alone, a robot has one");
    }
    rule.device = read_number(tail(words.front(), colon + 1), rule.kind->name);
  }
  words = words.subspan(1);
  if (words.empty()) {
    std::vector<std::string_view> names;
    for (const ErrorParameter& parameter : rule.kind->parameters) names.push_back(parameter.name);
    reject(end, "the rule ends: expected " + one_of(names));
  }
  std::size_t in_order = 0;
  for (const ErrorWord& word : words) {
    const bool first_ones = rule.values.size() == in_order;
    if (first_ones && in_order < rule.kind->in_order && looks_like_number(word.text)) {
      const ErrorParameter& parameter = rule.kind->parameters[in_order++];
      rule.values.emplace_back(&parameter, read_value(word, *rule.kind, parameter));
    } else {
      rule.values.push_back(read_named(word, *rule.kind));
    }
  }
  return rule;
}

std::vector<ErrorRule> read_error_rules(std::string_view text, const SourceLocation& where) {
  SourceLocation place = where;
  const bool counts = place.line == 0;
  if (counts) place.line = 1;
  const auto at = [&](std::size_t byte) {
    if (counts) place.column = static_cast<int>(byte) + 1;
    return place;
  };
  std::vector<ErrorRule> rules;
  std::vector<ErrorWord> words;
  constexpr std::string_view kBlanks = " \t\r\n";
  for (std::size_t i = 0; i <= text.size();) {
    if (i == text.size() || text[i] == ';') {
      if (!words.empty()) rules.push_back(read_error_rule(words, at(i)));
      words.clear();
      ++i;
    } else if (kBlanks.find(text[i]) != std::string_view::npos) {
      ++i;
    } else {
      const std::size_t end = std::min(text.find_first_of(" \t\r\n;", i), text.size());
      words.push_back({text.substr(i, end - i), at(i)});
      i = end;
    }
  }
  return rules;
}

}  // namespace eyebridge::files
