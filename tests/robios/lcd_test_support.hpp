#pragma once

#include <string>
#include <vector>

#include "canvas.hpp"

namespace eyebridge::robios {

constexpr Rgb kWhite{255, 255, 255};
constexpr Rgb kBlack{};
constexpr Rgb kRed{255, 0, 0};
constexpr Rgb kGreen{0, 255, 0};

/// '#' for what is not black, '.' for black, a string a row.
inline std::vector<std::string> art(const Canvas& canvas) {
  std::vector<std::string> rows;
  for (int y = 0; y < canvas.height(); ++y) {
    std::string row;
    for (int x = 0; x < canvas.width(); ++x) {
      row += canvas.at(x, y) == kBlack ? '.' : '#';
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace eyebridge::robios
