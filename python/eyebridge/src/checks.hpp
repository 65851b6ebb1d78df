#pragma once

#include <cmath>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

namespace eyebridge::python {

/// ValueError for an argument: what was found, and what was expected.
template <class Value>
[[noreturn]] void refuse(std::string_view name, const Value& found, std::string_view expected) {
  throw std::invalid_argument(fmt::format("found {} for '{}', expected {}", found, name, expected));
}

inline void need_finite(std::string_view name, double value) {
  if (!std::isfinite(value)) refuse(name, value, "a finite number");
}

}  // namespace eyebridge::python
