#include "eyebridge/base/length.hpp"

#include <charconv>
#include <cstdio>
#include <string>

#include "eyebridge/base/text.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge {
namespace {

std::string in_millimetres(double metres) {
  char text[40];
  std::snprintf(text, sizeof text, "%g mm", m_to_mm(metres));
  return text;
}

}  // namespace

double parse_length(std::string_view text, const SourceLocation& where, double least, double most) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string_view unit = text.substr(static_cast<std::size_t>(end - text.data()));
  const double metre = unit == "mm" ? mm_to_m(1.0) : unit == "cm" ? cm_to_m(1.0) : 1.0;
  if (error != std::errc{} || (unit != "mm" && unit != "cm" && unit != "m")) {
    throw ConfigError(
        where, "found " + in_quotes(text) + ", expected a length such as 80mm, 8cm or 0.08m");
  }
  const double metres = value * metre;
  if (!(metres >= least && metres <= most)) {
    throw ConfigError(where, "found " + in_quotes(text) + ", expected " + in_millimetres(least) +
                                 " to " + in_millimetres(most));
  }
  return metres;
}

}  // namespace eyebridge
