#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

#include "eyebridge/base/units.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

/// `text` as a finite decimal number times ten to the `shift`; nothing when it is anything else.
std::optional<double> parse(std::string_view text, int shift = 0) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const std::string_view unsigned_part = text.starts_with('-') ? text.substr(1) : text;
  if (unsigned_part.empty() || text.size() > 400 ||
      (unsigned_part[0] != '.' && (unsigned_part[0] < '0' || unsigned_part[0] > '9'))) {
    return std::nullopt;  // from_chars would take "nan" and "inf"
  }
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  if (shift == 0 || value == 0) return value + 0.0;  // no minus zero

  // The written exponent is moved instead of dividing the value, so that every double can be
  // written in millimetres and read back.
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  int exponent = 0;
  if (e < text.size()) {
    std::string_view digits = text.substr(e + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  }
  const std::string moved = std::string(text.substr(0, e)) + 'e' + std::to_string(exponent + shift);
  std::from_chars(moved.data(), moved.data() + moved.size(), value);  // too small: as it was
  return value;
}

std::string plain(double value) {
  char buffer[400];
  const auto result =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed);
  return {buffer, result.ptr};
}

std::string range_text(double low, double high) { return plain(low) + " to " + plain(high); }

}  // namespace

std::optional<double> parse_number(std::string_view text) { return parse(text); }

std::string Statement::rest(std::size_t i) const {
  if (i >= tokens_.size()) return {};
  if (tokens_[i].quoted) return std::string(tokens_[i].text);
  std::string_view out = raw_.substr(static_cast<std::size_t>(tokens_[i].column - 1));
  while (!out.empty() && (out.back() == ' ' || out.back() == '\t' || out.back() == '\r')) {
    out.remove_suffix(1);
  }
  return std::string(out);
}

SourceLocation Statement::where(std::size_t i) const {
  if (i < tokens_.size()) return {*file_, line_, tokens_[i].column};
  const Token& last = tokens_.back();
  return {*file_, line_, last.column + static_cast<int>(last.text.size()) + (last.quoted ? 2 : 0)};
}

void Statement::fail(std::size_t i, const std::string& text) const {
  throw ConfigError(where(i), text);
}

void Statement::expect_arguments(std::size_t count, std::string_view form) const {
  expect_arguments({count}, form);
}

void Statement::expect_arguments(std::initializer_list<std::size_t> counts,
                                 std::string_view form) const {
  const std::size_t given = size() - 1;
  if (std::find(counts.begin(), counts.end(), given) != counts.end()) return;
  const std::size_t most = std::max(counts);
  const bool is_torn_name = form.ends_with(" FILE") && given > most;
  fail(
      given > most ? most + 1 : size(),
      in_quotes(text(0)) + " with " + std::to_string(given) +
          (given == 1 ? " argument" : " arguments") + ": expected '" + std::string(form) + "'" +
          (is_torn_name ? "; a name with blanks needs quotes: \"" + rest(1) + '"' : std::string()));
}

bool Statement::is_number(std::size_t i) const { return i < size() && parse(text(i)).has_value(); }

double Statement::number(std::size_t i, std::string_view what, double low, double high) const {
  const std::string name(what);
  if (i >= size()) fail(i, "line ends: expected " + name);
  const auto value = parse(text(i));
  if (!value) fail(i, in_quotes(text(i)) + " found: expected " + name + ", a number");
  if (*value < low || *value > high) {
    fail(i, name + " is " + std::string(text(i).substr(0, 40)) + ": expected " +
                range_text(low, high));
  }
  return *value;
}

int Statement::integer(std::size_t i, std::string_view what, int low, int high) const {
  const double value = number(i, what, low, high);
  if (value != std::floor(value)) {
    fail(i, in_quotes(text(i)) + " found: expected " + std::string(what) + ", a whole number");
  }
  return static_cast<int>(value);
}

double Statement::millimetres(std::size_t i, std::string_view what, double low, double high) const {
  static_cast<void>(number(i, what, low, high));
  return parse(text(i), -3).value();
}

double Statement::degrees(std::size_t i, std::string_view what) const {
  if (i < size() && text(i).ends_with("rad")) {
    const auto radians = parse(text(i).substr(0, text(i).size() - 3));
    if (radians && std::abs(*radians) <= 1000) return *radians;
  }
  return deg_to_rad(number(i, what, -36000, 36000));
}

std::string decimal(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

std::string write_millimetres(double metres) {
  if (metres == 0) return "0";
  char buffer[64];
  const auto result =
      std::to_chars(buffer, buffer + sizeof buffer, metres, std::chars_format::scientific);
  const std::string_view text(buffer, static_cast<std::size_t>(result.ptr - buffer));
  const std::size_t e = text.find('e');
  std::string sign;
  std::string digits;
  for (const char c : text.substr(0, e)) {
    if (c == '-') sign.assign(1, '-');
    if (c >= '0' && c <= '9') digits += c;
  }
  std::string_view power = text.substr(e + 1);
  if (power.starts_with('+')) power.remove_prefix(1);
  int exponent = 0;
  std::from_chars(power.data(), power.data() + power.size(), exponent);
  const int point = exponent + 3 + 1;  // digits before the decimal point
  if (point < -20 || point > 20)
    return sign + digits + "e" + std::to_string(point - static_cast<int>(digits.size()));
  if (point <= 0) {
    return sign + "0." + std::string(static_cast<std::size_t>(-point), '0') + digits;
  }
  const auto whole = static_cast<std::size_t>(point);
  if (digits.size() <= whole) return sign + digits + std::string(whole - digits.size(), '0');
  return sign + digits.substr(0, whole) + "." + digits.substr(whole);
}

std::string write_degrees(double radians) {
  const double degrees = rad_to_deg(radians);
  for (const double candidate : {std::nearbyint(degrees), degrees, std::nextafter(degrees, 1e9),
                                 std::nextafter(degrees, -1e9)}) {
    if (deg_to_rad(candidate) == radians) return decimal(candidate == 0 ? 0.0 : candidate);
  }
  return decimal(radians) + "rad";
}

std::string write_word(std::string_view word) {
  if (!word.empty() && word.front() != '"' && word.front() != '\'' &&
      word.find_first_of(" \t\r\n\f\v#;\x1A") == std::string_view::npos) {
    return std::string(word);
  }
  for (const char quote : {'"', '\''}) {
    if (word.find(quote) == std::string_view::npos && word.find('\n') == std::string_view::npos) {
      return quote + std::string(word) + quote;
    }
  }
  return {};
}

}  // namespace eyebridge::files
