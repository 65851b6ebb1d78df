#include "vision/edge_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "eyebridge/camera/fiducials.hpp"

namespace eyebridge::camera {
namespace {

constexpr double kStep = 0.5;       ///< Between samples across an edge, pixels.
constexpr double kWeakest = 4.0;    ///< Grey levels that a step has at least.
constexpr double kFlattest = 0.02;  ///< Sine of the smallest angle between edges.

/// A line: where it starts to be, and the way it goes (a unit vector).
struct Line {
  Vec2 at;
  Vec2 along;
};

/// Bilinear; `point` lies in the picture.
double brightness(const cv::Mat& grey, Vec2 point) {
  const int x = std::min(static_cast<int>(point.x), grey.cols - 2);
  const int y = std::min(static_cast<int>(point.y), grey.rows - 2);
  const double u = point.x - x;
  const double v = point.y - y;
  const std::uint8_t* upper = grey.ptr<std::uint8_t>(y) + x;
  const std::uint8_t* lower = grey.ptr<std::uint8_t>(y + 1) + x;
  return (1 - v) * ((1 - u) * upper[0] + u * upper[1]) + v * ((1 - u) * lower[0] + u * lower[1]);
}

bool is_in(const cv::Mat& grey, Vec2 point) {
  return point.x >= 0.0 && point.y >= 0.0 && point.x <= grey.cols - 1.0 &&
         point.y <= grey.rows - 1.0;
}

/// Places on an edge with their weights, and the line through them: total least squares.
class LineThrough {
 public:
  void add(Vec2 point, double weight) {
    weight_ += weight;
    sum_ = sum_ + weight * point;
    xx_ += weight * point.x * point.x;
    xy_ += weight * point.x * point.y;
    yy_ += weight * point.y * point.y;
    ++count_;
  }

  [[nodiscard]] std::optional<Line> line() const {
    if (count_ < 4) return std::nullopt;
    const Vec2 mean = (1.0 / weight_) * sum_;
    const double xx = xx_ / weight_ - mean.x * mean.x;
    const double xy = xy_ / weight_ - mean.x * mean.y;
    const double yy = yy_ / weight_ - mean.y * mean.y;
    const double angle = 0.5 * arc_tan2(2.0 * xy, xx - yy);  // of the longer axis
    return Line{mean, Heading::from_angle(angle).forward()};
  }

 private:
  double weight_ = 0.0;
  Vec2 sum_;
  double xx_ = 0.0, xy_ = 0.0, yy_ = 0.0;
  int count_ = 0;
};

/// The edge from `a` to `b`; what lies to the left as one goes, the picture's y down, is white.
std::optional<Line> edge_between(const cv::Mat& grey, Vec2 a, Vec2 b, int cells) {
  const double length = norm(b - a);
  if (length < 8.0) return std::nullopt;
  const Vec2 along = (1.0 / length) * (b - a);
  const Vec2 outwards{along.y, -along.x};
  // The next step is a cell away on either side.
  const double reach = std::clamp(0.6 * length / cells, 1.5, 4.0);
  const int samples = std::clamp(static_cast<int>(length / 2.0), 8, 40);
  LineThrough found;
  for (int i = 0; i < samples; ++i) {
    const Vec2 middle = a + ((0.08 + 0.84 * (i + 0.5) / samples) * length) * along;
    const double half = reach + 0.5;
    if (!is_in(grey, middle - half * outwards) || !is_in(grey, middle + half * outwards)) continue;
    double weight = 0.0;
    double moment = 0.0;
    double steepest = 0.0;
    for (double s = -reach; s <= reach + 1e-9; s += kStep) {
      const double rise = brightness(grey, middle + (s + 0.5) * outwards) -
                          brightness(grey, middle + (s - 0.5) * outwards);
      if (rise <= 0.0) continue;
      steepest = std::max(steepest, rise);
      weight += rise * rise;
      moment += rise * rise * s;
    }
    if (steepest >= kWeakest) found.add(middle + (moment / weight) * outwards, weight);
  }
  return found.line();
}

std::optional<Vec2> crossing(const Line& a, const Line& b) {
  const double sine = cross(a.along, b.along);
  if (std::abs(sine) < kFlattest) return std::nullopt;
  return a.at + (cross(b.at - a.at, b.along) / sine) * a.along;
}

}  // namespace

Corners refined(const cv::Mat& grey, const Corners& corners, int cells) {
  Corners now = corners;
  // Once more from the better place: the steepest places are sought about the line.
  for (int round = 0; round < 2; ++round) {
    std::array<std::optional<Line>, 4> edges;
    for (std::size_t i = 0; i < 4; ++i)
      edges[i] = edge_between(grey, now[i], now[(i + 1) % 4], cells);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& before = edges[(i + 3) % 4];
      if (!before || !edges[i]) continue;
      const std::optional<Vec2> corner = crossing(*before, *edges[i]);
      if (corner && norm(*corner - corners[i]) < 4.0) now[i] = *corner;
    }
  }
  return now;
}

}  // namespace eyebridge::camera
