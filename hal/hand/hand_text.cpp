#include "hand/hand_text.hpp"

#include <array>
#include <charconv>

#include <fmt/format.h>

#include "eyebridge/base/text.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/base/url.hpp"

namespace eyebridge::hal {
namespace {

struct Unit {
  std::string_view name;
  double metres;
};
constexpr std::array<Unit, 4> kUnits{
    {{"", 1.0}, {"m", 1.0}, {"cm", cm_to_m(1)}, {"mm", mm_to_m(1)}}};

constexpr double kLongest = 100.0;  // metres
constexpr double kWidest = 170.0;   // degrees

/// A number at the front of `text`, and what follows it.
std::optional<double> take_number(std::string_view& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

double parse_length(const std::string& key, std::string_view text, const SourceLocation& where) {
  std::string_view rest = text;
  const auto number = take_number(rest);
  for (const Unit& unit : kUnits) {
    if (!number || rest != unit.name) continue;
    const double metres = *number * unit.metres;
    if (metres > 0.0 && metres <= kLongest) return metres;
  }
  throw ConfigError(where, fmt::format("found {}={}, expected a length up to {} m, such as 80mm",
                                       key, in_quotes(text), kLongest));
}

double parse_field_of_view(std::string_view text, const SourceLocation& where) {
  std::string_view rest = text;
  const auto degrees = take_number(rest);
  if (degrees && rest.empty() && *degrees > 0.0 && *degrees <= kWidest) return deg_to_rad(*degrees);
  throw ConfigError(where,
                    fmt::format("found fov={}, expected the camera's angle of view from left "
                                "to right, up to {} degrees",
                                in_quotes(text), kWidest));
}

}  // namespace

HandSetting parse_hand(std::string_view text, const SourceLocation& where) {
  const Url url = parse_url(text, where);
  HandSetting setting;
  setting.is_free = url.rest == "free";
  if (url.scheme != "hand" || (!url.rest.empty() && !setting.is_free)) {
    throw ConfigError(where, fmt::format("found {}, expected hand or hand:free", in_quotes(text)));
  }
  for (const auto& [key, value] : url.options) {
    if (setting.is_free) {
      throw ConfigError(where, fmt::format("found the option {}, expected none: hand:free looks "
                                           "for no markers",
                                           in_quotes(key)));
    }
    if (key == "size") {
      setting.layout.size = parse_length(key, value, where);
    } else if (key == "spacing") {
      setting.layout.spacing = parse_length(key, value, where);
    } else if (key == "height") {
      setting.layout.height = parse_length(key, value, where);
    } else if (key == "family") {
      const auto family = camera::family_named(value);
      if (!family) {
        throw ConfigError(where, fmt::format("found family={}, expected {}", in_quotes(value),
                                             camera::kFamilyWords));
      }
      setting.layout.family = *family;
    } else if (key == "fov") {
      setting.field_of_view = parse_field_of_view(value, where);
    } else {
      throw ConfigError(where, fmt::format("unknown option {}, expected one of size, spacing, "
                                           "height, family, fov",
                                           in_quotes(key)));
    }
  }
  return setting;
}

}  // namespace eyebridge::hal
