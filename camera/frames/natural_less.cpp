#include <algorithm>
#include <cstddef>
#include <string_view>

#include "frames/frame_series.hpp"

namespace eyebridge::camera {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Takes the digits off the front of `text`, and gives them without leading zeros.
std::string_view take_number(std::string_view& text) {
  const auto end =
      static_cast<std::size_t>(std::ranges::find_if_not(text, is_digit) - text.begin());
  std::string_view number = text.substr(0, end);
  text.remove_prefix(end);
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

}  // namespace

bool natural_less(const std::string& a, const std::string& b) {
  std::string_view one = a;
  std::string_view other = b;
  while (!one.empty() && !other.empty()) {
    if (is_digit(one.front()) && is_digit(other.front())) {
      const std::string_view x = take_number(one);
      const std::string_view y = take_number(other);
      // Longer is larger; of the same length text order is that of the numbers.
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
      continue;
    }
    const char x = lower(one.front());
    const char y = lower(other.front());
    if (x != y) return static_cast<unsigned char>(x) < static_cast<unsigned char>(y);
    one.remove_prefix(1);
    other.remove_prefix(1);
  }
  if (one.empty() != other.empty()) return one.empty();
  return a < b;
}

}  // namespace eyebridge::camera
