#include "lcd_cells.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "eyebridge/base/hash.hpp"

namespace eyebridge::gallery {
namespace {

/// Wider ones are colour screens; that of classic RoBIOS has 128 x 64 pixels.
constexpr int kSmallWidth = 160;

struct Cell {
  int width;
  int height;
};
constexpr Cell kCell{8, 16};
constexpr Cell kSmallCell{2, 4};

struct Named {
  char letter;
  const char* name;
  int red;
  int green;
  int blue;
};

constexpr std::array kColours = {
    Named{'K', "black", 0, 0, 0},       Named{'W', "white", 255, 255, 255},
    Named{'R', "red", 255, 0, 0},       Named{'G', "green", 0, 255, 0},
    Named{'B', "blue", 0, 0, 255},      Named{'Y', "yellow", 255, 255, 0},
    Named{'C', "cyan", 0, 238, 238},    Named{'M', "magenta", 255, 0, 255},
    Named{'O', "orange", 255, 165, 0},  Named{'H', "grey", 128, 128, 128},
    Named{'L', "light", 192, 192, 192}, Named{'N', "navy", 0, 0, 128},
    Named{'T', "teal", 0, 128, 128},    Named{'P', "purple", 128, 0, 128},
    Named{'A', "maroon", 128, 0, 0},    Named{'V', "olive", 154, 205, 50},
    Named{'D', "dark", 64, 64, 64}};

std::size_t nearest(int red, int green, int blue) {
  std::size_t best = 0;
  int least = 1 << 30;
  for (std::size_t i = 0; i < kColours.size(); ++i) {
    const int r = red - kColours[i].red;
    const int g = green - kColours[i].green;
    const int b = blue - kColours[i].blue;
    const int distance = r * r + g * g + b * b;
    if (distance < least) {
      least = distance;
      best = i;
    }
  }
  return best;
}

using Counts = std::array<int, kColours.size()>;

Counts count(const camera::Frame& lcd, int left, int top, Cell size) {
  Counts counts{};
  for (int y = top; y < std::min(top + size.height, lcd.height); ++y) {
    const auto row = lcd.row(y);
    for (int x = left; x < std::min(left + size.width, lcd.width); ++x) {
      const std::size_t at = 3 * static_cast<std::size_t>(x);
      ++counts[nearest(row[at], row[at + 1], row[at + 2])];
    }
  }
  return counts;
}

std::size_t most(const Counts& counts) {
  return static_cast<std::size_t>(std::ranges::max_element(counts) - counts.begin());
}

}  // namespace

Lines lcd_cells(const camera::Frame& lcd) {
  const Cell size = lcd.width <= kSmallWidth ? kSmallCell : kCell;
  const std::size_t background = most(count(lcd, 0, 0, {lcd.width, lcd.height}));
  Lines lines;
  std::array<bool, kColours.size()> used{};
  for (int top = 0; top < lcd.height; top += size.height) {
    std::string line;
    for (int left = 0; left < lcd.width; left += size.width) {
      Counts counts = count(lcd, left, top, size);
      const int behind = std::exchange(counts[background], 0);
      const std::size_t colour = most(counts);
      if (counts[colour] == 0) {
        line += '.';
        continue;
      }
      used[colour] = true;
      const int pixels = std::accumulate(counts.begin(), counts.end(), behind);
      const char letter = kColours[colour].letter;
      line += 2 * counts[colour] >= pixels ? letter : static_cast<char>(std::tolower(letter));
    }
    lines.push_back(line);
  }
  std::string legend = fmt::format(". {}", kColours[background].name);
  for (std::size_t i = 0; i < kColours.size(); ++i) {
    if (used[i]) legend += fmt::format("  {} {}", kColours[i].letter, kColours[i].name);
  }
  lines.push_back(legend);
  return lines;
}

std::string hash_of(const camera::Frame& picture) {
  StateHash hash;
  for (const std::uint8_t byte : picture.bytes) hash.add_byte(byte);
  return fmt::format("{:016x}", hash.value());
}

}  // namespace eyebridge::gallery
