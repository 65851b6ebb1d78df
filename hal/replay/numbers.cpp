#include "replay/numbers.hpp"

#include <charconv>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace eyebridge::hal {

std::string write_numbers(const Values& values) {
  return fmt::format("{}", fmt::join(values, " "));
}

std::optional<Values> read_numbers(std::string_view text) {
  Values values;
  while (!text.empty()) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{}) return std::nullopt;
    values.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (text.empty()) break;
    if (text.front() != ' ' || text.size() == 1) return std::nullopt;
    text.remove_prefix(1);
  }
  return values;
}

}  // namespace eyebridge::hal
