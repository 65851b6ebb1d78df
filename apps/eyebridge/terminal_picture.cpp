#include "terminal_picture.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "eyebridge/camera/convert.hpp"

namespace eyebridge::apps {

std::string terminal_picture(const camera::Frame& frame, int columns, int rows) {
  // A character is about twice as high as wide: half of one is a square.
  const double scale = std::min({1.0, static_cast<double>(columns) / frame.width,
                                 2.0 * static_cast<double>(rows) / frame.height});
  const int width = std::max(1, static_cast<int>(frame.width * scale));
  const int height = std::max(2, static_cast<int>(frame.height * scale) / 2 * 2);
  const camera::Frame small = camera::fit(frame, width, height);
  std::string out;
  for (int y = 0; y < height; y += 2) {
    const auto upper = small.row(y);
    const auto lower = small.row(y + 1);
    for (std::size_t x = 0; x < upper.size(); x += 3) {
      out += fmt::format("\x1b[38;2;{};{};{};48;2;{};{};{}m▀", upper[x], upper[x + 1], upper[x + 2],
                         lower[x], lower[x + 1], lower[x + 2]);
    }
    out += "\x1b[0m\n";
  }
  return out;
}

}  // namespace eyebridge::apps
