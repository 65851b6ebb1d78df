#include "editor/floor_plan.hpp"

#include <QCoreApplication>
#include <QPainter>
#include <QPoint>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::gui {
namespace {

class FloorPlanText {
  Q_DECLARE_TR_FUNCTIONS(FloorPlan)
};

constexpr std::size_t kMostWalls = 100000;
constexpr int kGreys = 256;

[[noreturn]] void refuse_picture(const QString& why) {
  throw ConfigError({"floor plan", 0, 0}, why.toStdString());
}

QImage greys_of(const QImage& picture) {
  QImage paper(picture.size(), QImage::Format_RGB32);
  paper.fill(Qt::white);
  QPainter(&paper).drawImage(0, 0, picture);
  return paper.convertToFormat(QImage::Format_Grayscale8);
}

/// The threshold that parts the greys into two classes whose means differ most.
int otsu_threshold(const QImage& greys) {
  std::array<double, kGreys> counts{};
  for (int y = 0; y < greys.height(); ++y) {
    const uchar* const row = greys.constScanLine(y);
    for (int x = 0; x < greys.width(); ++x) counts.at(row[x]) += 1;
  }
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
  CrackFollower(const QImage& greys, int threshold)
      : greys_(greys),
        threshold_(threshold),
        width_(greys.width() + 1),
        cracks_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(greys.height() + 1)) {
    for (int y = 0; y < greys.height(); ++y) {
      for (int x = 0; x < greys.width(); ++x) {
        if (!is_dark(x, y)) continue;
        if (!is_dark(x, y - 1)) add({x, y}, kRight);
        if (!is_dark(x + 1, y)) add({x + 1, y}, kDown);
        if (!is_dark(x, y + 1)) add({x + 1, y + 1}, kLeft);
        if (!is_dark(x - 1, y)) add({x, y + 1}, kUp);
      }
    }
  }

  /// The corners of the next closed outline; empty when there is none left.
  std::vector<QPoint> next() {
    while (start_ < cracks_.size() && cracks_[start_] == 0) ++start_;
    if (start_ == cracks_.size()) return {};
    const QPoint begin(static_cast<int>(start_) % width_, static_cast<int>(start_) / width_);
    std::vector<QPoint> corners;
    QPoint at = begin;
    int heading = -1;
    do {
      const int turn = leave(at, heading);
      if (turn != heading) corners.push_back(at);
      heading = turn;
      at += kSteps.at(static_cast<std::size_t>(turn));
    } while (at != begin || bits(at) != 0);
    return corners;
  }

 private:
  enum { kRight, kDown, kLeft, kUp };
  static constexpr std::array<QPoint, 4> kSteps = {QPoint(1, 0), QPoint(0, 1), QPoint(-1, 0),
                                                   QPoint(0, -1)};

  [[nodiscard]] bool is_dark(int x, int y) const {
    return x >= 0 && y >= 0 && x < greys_.width() && y < greys_.height() &&
           greys_.constScanLine(y)[x] < threshold_;
  }
  std::uint8_t& bits(QPoint p) {
    return cracks_[static_cast<std::size_t>(p.y()) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(p.x())];
  }
  void add(QPoint from, int direction) {
    bits(from) = static_cast<std::uint8_t>(bits(from) | (1U << direction));
  }
  /// Where two dark pixels meet at a corner they belong together: a thin slanted line is one.
  int leave(QPoint at, int heading) {
    std::uint8_t& out = bits(at);
    int direction = 0;
    for (const int turn : {3, 0, 1, 2}) {  // left, straight on, right
      direction = heading < 0 ? turn : (heading + turn) % 4;
      if ((out & (1U << direction)) != 0) break;
    }
    out = static_cast<std::uint8_t>(out & ~(1U << direction));
    return direction;
  }

  const QImage& greys_;
  int threshold_;
  int width_;
  std::vector<std::uint8_t> cracks_;  ///< Of each corner of pixels, those that leave it.
  std::size_t start_ = 0;
};

double distance_to_line(QPoint p, QPoint a, QPoint b) {
  const QPointF along = b - a;
  const QPointF away = p - a;
  const double length = std::hypot(along.x(), along.y());
  if (length == 0) return std::hypot(away.x(), away.y());
  return std::abs(along.x() * away.y() - along.y() * away.x()) / length;
}

/// Marks the corners between `first` and `last` that are needed, Douglas and Peucker's way.
void straighten(const std::vector<QPoint>& corners, std::size_t first, std::size_t last,
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

std::vector<QPoint> simplified(const std::vector<QPoint>& corners, double tolerance) {
  // A closed line is two: from its first corner to the one farthest away, and back.
  std::size_t other = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto away = [&](std::size_t k) { return (corners[k] - corners[0]).manhattanLength(); };
    if (away(i) > away(other)) other = i;
  }
  std::vector<bool> needed(corners.size(), false);
  needed[0] = needed[other] = true;
  straighten(corners, 0, other, tolerance, needed);
  straighten(corners, other, corners.size(), tolerance, needed);
  std::vector<QPoint> out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (needed[i]) out.push_back(corners[i]);
  }
  return out;
}

}  // namespace

FloorPlan read_floor_plan(const QImage& picture, const FloorPlanOptions& options) {
  if (picture.isNull()) refuse_picture(FloorPlanText::tr("no picture: expected PNG, JPEG or BMP"));
  const QImage greys = greys_of(picture);
  CrackFollower follower(greys, options.threshold.value_or(otsu_threshold(greys)));
  FloorPlan plan;
  const double scale = options.metres_per_pixel;
  plan.width = greys.width() * scale;
  plan.height = greys.height() * scale;
  // Hundredths of a millimetre: what a person reads in the file.
  const auto place = [&](QPoint corner) {
    const auto tidy = [](double metres) { return std::round(metres * 1e5) / 1e5; };
    return Vec2{tidy(corner.x() * scale), tidy((greys.height() - corner.y()) * scale)};
  };
  for (auto corners = follower.next(); !corners.empty(); corners = follower.next()) {
    const std::vector<QPoint> outline = simplified(corners, options.tolerance);
    for (std::size_t i = 0; i < outline.size(); ++i) {
      world::Wall wall;
      wall.a = place(outline[i]);
      wall.b = place(outline[(i + 1) % outline.size()]);
      const bool is_back = outline.size() == 2 && i == 1;  // of a line that was flattened
      if (!(wall.a == wall.b) && !is_back) plan.walls.push_back(wall);
    }
    if (plan.walls.size() > kMostWalls) {
      refuse_picture(
          FloorPlanText::tr("it has more than 100000 walls: expected a cleaner picture, or "
                            "a larger tolerance"));
    }
  }
  if (plan.walls.empty()) {
    refuse_picture(
        FloorPlanText::tr("nothing in it is dark: expected walls darker than the floor, or "
                          "a higher threshold"));
  }
  return plan;
}

}  // namespace eyebridge::gui
