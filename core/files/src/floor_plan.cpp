#include "eyebridge/files/floor_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace eyebridge::files {
namespace {

constexpr int kGreys = 256;

/// The threshold that parts the greys into two classes whose means differ most.
int otsu_threshold(const GreyPicture& picture) {
  std::array<double, kGreys> counts{};
  for (const std::uint8_t grey : picture.greys) counts.at(grey) += 1;
  double all = 0;
  double sum = 0;
  for (int grey = 0; grey < kGreys; ++grey) {
    all += counts.at(static_cast<std::size_t>(grey));
    sum += grey * counts.at(static_cast<std::size_t>(grey));
  }
  double dark = 0;
  double dark_sum = 0;
  double best = -1;
  int threshold = kGreys / 2;
  for (int grey = 0; grey + 1 < kGreys; ++grey) {
    const double count = counts.at(static_cast<std::size_t>(grey));
    dark += count;
    dark_sum += grey * count;
    if (dark == 0 || dark == all) continue;
    const double apart = dark_sum / dark - (sum - dark_sum) / (all - dark);
    const double between = dark * (all - dark) * apart * apart;
    if (between <= best) continue;
    best = between;
    threshold = grey + 1;
  }
  return threshold;
}

/// Follows the cracks between dark and light pixels: each has the dark one on its right.
class CrackFollower {
 public:
  CrackFollower(int columns, int rows, const std::vector<char>& dark)
      : columns_(columns),
        rows_(rows),
        dark_(dark),
        width_(columns + 1),
        cracks_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(rows + 1)) {
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < columns; ++x) {
        if (!is_dark(x, y)) continue;
        if (!is_dark(x, y - 1)) add({x, y}, kRight);
        if (!is_dark(x + 1, y)) add({x + 1, y}, kDown);
        if (!is_dark(x, y + 1)) add({x + 1, y + 1}, kLeft);
        if (!is_dark(x - 1, y)) add({x, y + 1}, kUp);
      }
    }
  }

  /// The corners of the next closed outline; empty when there is none left.
  std::vector<PixelCorner> next() {
    while (start_ < cracks_.size() && cracks_[start_] == 0) ++start_;
    if (start_ == cracks_.size()) return {};
    const PixelCorner begin{static_cast<int>(start_) % width_, static_cast<int>(start_) / width_};
    std::vector<PixelCorner> corners;
    PixelCorner at = begin;
    int heading = -1;
    do {
      const int turn = leave(at, heading);
      if (turn != heading) corners.push_back(at);
      heading = turn;
      const PixelCorner& step = kSteps.at(static_cast<std::size_t>(turn));
      at = {at.x + step.x, at.y + step.y};
    } while (!(at == begin) || bits(at) != 0);
    return corners;
  }

 private:
  enum { kRight, kDown, kLeft, kUp };
  static constexpr std::array<PixelCorner, 4> kSteps = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

  [[nodiscard]] bool is_dark(int x, int y) const {
    return x >= 0 && y >= 0 && x < columns_ && y < rows_ &&
           dark_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
                 static_cast<std::size_t>(x)] != 0;
  }
  std::uint8_t& bits(PixelCorner p) {
    return cracks_[static_cast<std::size_t>(p.y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(p.x)];
  }
  void add(PixelCorner from, int direction) {
    bits(from) = static_cast<std::uint8_t>(bits(from) | (1U << direction));
  }
  /// Where two dark pixels meet at a corner they belong together: a thin slanted line is one.
  int leave(PixelCorner at, int heading) {
    std::uint8_t& out = bits(at);
    int direction = 0;
    for (const int turn : {3, 0, 1, 2}) {  // left, straight on, right
      direction = heading < 0 ? turn : (heading + turn) % 4;
      if ((out & (1U << direction)) != 0) break;
    }
    out = static_cast<std::uint8_t>(out & ~(1U << direction));
    return direction;
  }

  int columns_;
  int rows_;
  const std::vector<char>& dark_;
  int width_;
  std::vector<std::uint8_t> cracks_;  ///< Of each corner of pixels, those that leave it.
  std::size_t start_ = 0;
};

double distance_to_line(PixelCorner p, PixelCorner a, PixelCorner b) {
  const double along_x = b.x - a.x;
  const double along_y = b.y - a.y;
  const double away_x = p.x - a.x;
  const double away_y = p.y - a.y;
  const double length = std::sqrt(along_x * along_x + along_y * along_y);
  if (length == 0) return std::sqrt(away_x * away_x + away_y * away_y);
  return std::fabs(along_x * away_y - along_y * away_x) / length;
}

/// Marks the corners between `first` and `last` that are needed, Douglas and Peucker's way.
void straighten(const std::vector<PixelCorner>& corners, std::size_t first, std::size_t last,
                double tolerance, std::vector<bool>& needed) {
  std::vector<std::pair<std::size_t, std::size_t>> parts{{first, last}};
  while (!parts.empty()) {
    const auto [from, to] = parts.back();
    parts.pop_back();
    std::size_t farthest = from;
    double most = tolerance;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double away = distance_to_line(corners[i], corners[from], corners[to % corners.size()]);
      if (away <= most) continue;
      most = away;
      farthest = i;
    }
    if (farthest == from) continue;
    needed[farthest] = true;
    parts.emplace_back(from, farthest);
    parts.emplace_back(farthest, to);
  }
}

std::vector<PixelCorner> simplified(const std::vector<PixelCorner>& corners, double tolerance) {
  // A closed line is two: from its first corner to the one farthest away, and back.
  std::size_t other = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto away = [&](std::size_t k) {
      return std::abs(corners[k].x - corners[0].x) + std::abs(corners[k].y - corners[0].y);
    };
    if (away(i) > away(other)) other = i;
  }
  std::vector<bool> needed(corners.size(), false);
  needed[0] = needed[other] = true;
  straighten(corners, 0, other, tolerance, needed);
  straighten(corners, other, corners.size(), tolerance, needed);
  std::vector<PixelCorner> out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (needed[i]) out.push_back(corners[i]);
  }
  return out;
}

}  // namespace

std::vector<std::vector<PixelCorner>> outlines_of(int columns, int rows,
                                                  const std::vector<char>& dark, double tolerance,
                                                  const std::string& file) {
  CrackFollower follower(columns, rows, dark);
  std::vector<std::vector<PixelCorner>> out;
  std::size_t walls = 0;
  for (auto corners = follower.next(); !corners.empty(); corners = follower.next()) {
    out.push_back(simplified(corners, tolerance));
    walls += out.back().size();
    if (walls > kMostPictureWalls) {
      throw ConfigError({file, 0, 0},
                        "it has more than 100000 walls: expected a cleaner picture, or a larger "
                        "tolerance");
    }
  }
  return out;
}

std::vector<std::vector<PixelCorner>> outlines_of(const GreyPicture& picture, int darkest,
                                                  double tolerance, const std::string& file) {
  std::vector<char> dark;
  dark.reserve(picture.greys.size());
  for (const std::uint8_t grey : picture.greys) dark.push_back(grey <= darkest ? 1 : 0);
  return outlines_of(picture.columns, picture.rows, dark, tolerance, file);
}

FloorPlan read_floor_plan(const GreyPicture& picture, const FloorPlanOptions& options,
                          const std::string& file) {
  const int threshold = options.threshold.value_or(otsu_threshold(picture));
  FloorPlan plan;
  const double scale = options.metres_per_pixel;
  plan.width = picture.columns * scale;
  plan.height = picture.rows * scale;
  // Hundredths of a millimetre: what a person reads in the file.
  const auto place = [&](PixelCorner corner) {
    const auto tidy = [](double metres) { return std::round(metres * 1e5) / 1e5; };
    return Vec2{tidy(corner.x * scale), tidy((picture.rows - corner.y) * scale)};
  };
  for (const auto& outline : outlines_of(picture, threshold - 1, options.tolerance, file)) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      world::Wall wall;
      wall.a = place(outline[i]);
      wall.b = place(outline[(i + 1) % outline.size()]);
      const bool is_back = outline.size() == 2 && i == 1;  // of a line that was flattened
      if (!(wall.a == wall.b) && !is_back) plan.walls.push_back(wall);
    }
  }
  if (plan.walls.empty()) {
    throw ConfigError({file, 0, 0},
                      "nothing in it is dark: expected walls darker than the floor, or a higher "
                      "threshold");
  }
  return plan;
}

}  // namespace eyebridge::files
