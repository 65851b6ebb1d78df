#include "lcd_cells.hpp"

#include <array>
#include <cctype>
#include <cstdint>

#include <fmt/format.h>

namespace eyebridge::gallery {
namespace {

constexpr int kCellWidth = 8;
constexpr int kCellHeight = 16;

struct Named {
  char letter;
  const char* name;
  int red;
  int green;
  int blue;
};

constexpr std::array kColours = {
    Named{'.', "black", 0, 0, 0},       Named{'W', "white", 255, 255, 255},
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

char cell(const camera::Frame& lcd, int left, int top, std::array<bool, kColours.size()>& used) {
  std::array<int, kColours.size()> count{};
  int pixels = 0;
  for (int y = top; y < std::min(top + kCellHeight, lcd.height); ++y) {
    const auto row = lcd.row(y);
    for (int x = left; x < std::min(left + kCellWidth, lcd.width); ++x) {
      const std::size_t at = 3 * static_cast<std::size_t>(x);
      ++count[nearest(row[at], row[at + 1], row[at + 2])];
      ++pixels;
    }
  }
  const auto* most = std::max_element(count.begin() + 1, count.end());
  if (*most == 0) return '.';
  const auto colour = static_cast<std::size_t>(most - count.begin());
  used[colour] = true;
  const char letter = kColours[colour].letter;
  return 2 * *most >= pixels ? letter : static_cast<char>(std::tolower(letter));
}

}  // namespace

Lines lcd_cells(const camera::Frame& lcd) {
  Lines lines;
  std::array<bool, kColours.size()> used{};
  for (int top = 0; top < lcd.height; top += kCellHeight) {
    std::string line;
    for (int left = 0; left < lcd.width; left += kCellWidth) line += cell(lcd, left, top, used);
    lines.push_back(line);
  }
  std::string legend;
  for (std::size_t i = 0; i < kColours.size(); ++i) {
    if (used[i]) legend += fmt::format("{} {}  ", kColours[i].letter, kColours[i].name);
  }
  lines.push_back(legend);
  return lines;
}

std::string hash_of(const camera::Frame& picture) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const std::uint8_t byte : picture.bytes) {
    hash = (hash ^ byte) * 0x100000001b3;
  }
  return fmt::format("{:016x}", hash);
}

}  // namespace eyebridge::gallery
