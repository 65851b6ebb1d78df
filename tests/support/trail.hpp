#pragma once

#include <string>

#include <fmt/format.h>

namespace eyebridge {

/// A line of a trail: a step, then numbers with all their digits, so that two lines are the same if
/// and only if all bits are, on every processor.
template <class... Numbers>
std::string trail_line(int step, const Numbers&... numbers) {
  std::string line = fmt::format("{}:", step);
  ((line += fmt::format(" {}", numbers)), ...);
  return line + '\n';
}

}  // namespace eyebridge
