#include "terminal/colours.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace eyebridge::robios {
namespace {

// Of XTerm's 256colres.h: the cube's levels, and greys of 8, 18 … 238.
constexpr std::array<int, 6> kLevels = {0, 95, 135, 175, 215, 255};
constexpr int kCube = 16;
constexpr int kGreys = 232;
constexpr int kMostGrey = 23;

int nearest_level(int value) {
  int best = 0;
  for (int level = 1; level < static_cast<int>(kLevels.size()); ++level) {
    const auto distance = [&](int l) {
      return std::abs(kLevels.at(static_cast<std::size_t>(l)) - value);
    };
    if (distance(level) < distance(best)) best = level;
  }
  return best;
}

int square(int value) { return value * value; }

}  // namespace

ColourDepth colour_depth(std::string_view term, std::string_view colorterm) {
  const bool is_true =
      colorterm == "truecolor" || colorterm == "24bit" || term.ends_with("-direct");
  return is_true ? ColourDepth::True : ColourDepth::Palette256;
}

int palette_index(Rgb colour) {
  const int r = nearest_level(colour.r);
  const int g = nearest_level(colour.g);
  const int b = nearest_level(colour.b);
  const auto level = [](int l) { return kLevels.at(static_cast<std::size_t>(l)); };
  const int cube_error =
      square(level(r) - colour.r) + square(level(g) - colour.g) + square(level(b) - colour.b);
  const int mean = (colour.r + colour.g + colour.b) / 3;
  const int grey = std::clamp((mean - 8 + 5) / 10, 0, kMostGrey);
  const int shade = 8 + 10 * grey;
  const int grey_error =
      square(shade - colour.r) + square(shade - colour.g) + square(shade - colour.b);
  return grey_error < cube_error ? kGreys + grey : kCube + 36 * r + 6 * g + b;
}

}  // namespace eyebridge::robios
