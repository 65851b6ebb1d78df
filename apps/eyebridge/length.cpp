#include "length.hpp"

#include <charconv>

#include <fmt/format.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::apps {

double parse_length(const std::string& text, const char* flag, double least, double most) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  const double metre = unit == "mm" ? mm_to_m(1.0) : unit == "cm" ? cm_to_m(1.0) : 1.0;
  if (error != std::errc{} || (unit != "mm" && unit != "cm" && unit != "m")) {
    throw ConfigError({flag}, fmt::format("found {}, expected a length such as 80mm, 8cm or 0.08m",
                                          in_quotes(text)));
  }
  const double metres = value * metre;
  if (!(metres >= least && metres <= most)) {
    throw ConfigError({flag}, fmt::format("found {}, expected {:g} mm to {:g} mm", text,
                                          m_to_mm(least), m_to_mm(most)));
  }
  return metres;
}

}  // namespace eyebridge::apps
