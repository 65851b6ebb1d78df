#include "svg_style.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "eyebridge/base/math.hpp"
#include "svg_path.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

constexpr double kMillimetresPerInch = 25.4;
constexpr double kUnitsPerInch = 96;  // CSS

constexpr auto kNames = std::to_array<std::pair<std::string_view, Rgb>>({
    {"aqua", {0, 255, 255}},        {"black", {0, 0, 0}},       {"blue", {0, 0, 255}},
    {"brown", {165, 42, 42}},       {"cyan", {0, 255, 255}},    {"darkgray", {169, 169, 169}},
    {"darkgrey", {169, 169, 169}},  {"fuchsia", {255, 0, 255}}, {"gray", {128, 128, 128}},
    {"green", {0, 128, 0}},         {"grey", {128, 128, 128}},  {"lightgray", {211, 211, 211}},
    {"lightgrey", {211, 211, 211}}, {"lime", {0, 255, 0}},      {"magenta", {255, 0, 255}},
    {"maroon", {128, 0, 0}},        {"navy", {0, 0, 128}},      {"olive", {128, 128, 0}},
    {"orange", {255, 165, 0}},      {"purple", {128, 0, 128}},  {"red", {255, 0, 0}},
    {"silver", {192, 192, 192}},    {"teal", {0, 128, 128}},    {"white", {255, 255, 255}},
    {"yellow", {255, 255, 0}},
});

std::optional<Rgb> hex_colour(std::string_view digits) {
  unsigned value = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  const auto byte = [](unsigned v) { return static_cast<std::uint8_t>(v & 0xFFU); };
  if (digits.size() == 6) return Rgb{byte(value >> 16U), byte(value >> 8U), byte(value)};
  if (digits.size() != 3) return std::nullopt;
  return Rgb{byte((value >> 8U) * 17), byte((value >> 4U & 15U) * 17), byte((value & 15U) * 17)};
}

std::optional<Rgb> rgb_colour(std::string_view list) {
  std::string text(list);
  const bool is_share = text.find('%') != std::string::npos;
  std::erase(text, '%');
  try {
    const std::vector<double> channels = read_svg_numbers(text);
    if (channels.size() != 3) return std::nullopt;
    const auto byte = [&](double v) {
      return static_cast<std::uint8_t>(std::clamp(std::round(is_share ? v * 2.55 : v), 0.0, 255.0));
    };
    return Rgb{byte(channels[0]), byte(channels[1]), byte(channels[2])};
  } catch (const SvgPathError&) {
    return std::nullopt;
  }
}

/// One function of a `transform`, "rotate(30)".
SvgTransform transform_of(std::string_view name, const std::vector<double>& v, std::size_t offset) {
  const auto expect = [&](bool is_right, const char* what) {
    if (!is_right) throw SvgPathError(offset, std::string(name) + " expects " + what);
  };
  if (name == "matrix") {
    expect(v.size() == 6, "6 numbers");
    return {v[0], v[1], v[2], v[3], v[4], v[5]};
  }
  if (name == "translate") {
    expect(v.size() == 1 || v.size() == 2, "1 or 2 numbers");
    return {1, 0, 0, 1, v[0], v.size() == 2 ? v[1] : 0};
  }
  if (name == "scale") {
    expect(v.size() == 1 || v.size() == 2, "1 or 2 numbers");
    return {v[0], 0, 0, v.back(), 0, 0};
  }
  if (name == "rotate") {
    expect(v.size() == 1 || v.size() == 3, "1 or 3 numbers");
    const Heading h = Heading::from_angle(v[0] * kPi / 180);
    const SvgTransform turn{h.cos, h.sin, -h.sin, h.cos, 0, 0};
    if (v.size() == 1) return turn;
    return SvgTransform{1, 0, 0, 1, v[1], v[2]}.after(turn.after({1, 0, 0, 1, -v[1], -v[2]}));
  }
  if (name == "skewX" || name == "skewY") {
    expect(v.size() == 1, "1 number");
    const SinCos sc = sin_cos(v[0] * kPi / 180);
    const double slope = sc.sin / sc.cos;
    return name == "skewX" ? SvgTransform{1, 0, slope, 1, 0, 0}
                           : SvgTransform{1, slope, 0, 1, 0, 0};
  }
  throw SvgPathError(offset,
                     "unknown transform: expected matrix, translate, scale, rotate, skewX "
                     "or skewY");
}

}  // namespace

SvgTransform SvgTransform::after(const SvgTransform& m) const {
  return {a * m.a + c * m.b, b * m.a + d * m.b,     a * m.c + c * m.d,
          b * m.c + d * m.d, a * m.e + c * m.f + e, b * m.e + d * m.f + f};
}

double SvgTransform::scale() const { return std::sqrt(std::fabs(a * d - b * c)); }

SvgTransform read_svg_transform(std::string_view text) {
  SvgTransform whole;
  std::size_t at = 0;
  while (true) {
    at = text.find_first_not_of(" \t\r\n,", at);
    if (at == std::string_view::npos || text.substr(at) == "none") return whole;
    const std::size_t open = text.find('(', at);
    const std::size_t close = text.find(')', at);
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
      throw SvgPathError(at, "expected a transform, as 'translate(10 20)'");
    }
    whole =
        whole.after(transform_of(trimmed(text.substr(at, open - at)),
                                 read_svg_numbers(text.substr(open + 1, close - open - 1)), at));
    at = close + 1;
  }
}

SvgPaint read_svg_paint(std::string_view written) {
  const std::string word = lower(trimmed(written));
  if (word == "none" || word == "transparent") return {};
  std::optional<Rgb> colour;
  if (word.starts_with('#')) {
    colour = hex_colour(std::string_view(word).substr(1));
  } else if (word.starts_with("rgb(") && word.ends_with(')')) {
    colour = rgb_colour(std::string_view(word).substr(4, word.size() - 5));
  } else {
    const auto found = std::ranges::find(kNames, std::string_view(word),
                                         [](const auto& row) { return row.first; });
    if (found != kNames.end()) colour = found->second;
  }
  if (!colour) return {SvgPaint::Kind::Other, {}};
  return {SvgPaint::Kind::Colour, *colour};
}

std::optional<SvgLength> read_svg_length(std::string_view written) {
  const std::string_view text = trimmed(written);
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* end = text.data() + text.size();
  SvgLength length;
  const auto [stop, error] = std::from_chars(begin, end, length.value);
  if (error != std::errc{} || !std::isfinite(length.value)) return std::nullopt;
  length.unit = trimmed({stop, static_cast<std::size_t>(end - stop)});
  return length;
}

std::optional<double> SvgLength::millimetres() const {
  if (unit == "mm") return value;
  if (unit == "cm") return value * 10;
  if (unit == "in") return value * kMillimetresPerInch;
  if (unit == "pt") return value * kMillimetresPerInch / 72;
  if (unit == "pc") return value * kMillimetresPerInch / 6;
  return std::nullopt;
}

std::optional<double> SvgLength::units() const {
  if (unit.empty() || unit == "px") return value;
  if (const auto mm = millimetres()) return *mm * kUnitsPerInch / kMillimetresPerInch;
  return std::nullopt;
}

}  // namespace eyebridge::files
