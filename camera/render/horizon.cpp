#include "render/horizon.hpp"

#include <algorithm>
#include <limits>

namespace eyebridge::camera {
namespace {

/// Directions closer than this are one: far less than what a pixel spans, far more than rounding.
constexpr double kSameDirection = 1e-9;
/// Of 1 / depth, relative: two walls in one plane.
constexpr double kSamePlane = 1e-9;
constexpr std::uint32_t kOpen = std::numeric_limits<std::uint32_t>::max();

}  // namespace

void Horizon::clear(double reach, double nearest) {
  reach_ = reach;
  nearest_ = nearest;
  pieces_.assign(1, Piece{-reach, {0.0, 0.0, 0.0, kOpen}});
  as_near_.clear();
}

std::size_t Horizon::piece_at(double u) const {
  const auto next = std::upper_bound(pieces_.begin() + 1, pieces_.end(), u,
                                     [](double at, const Piece& p) { return at < p.from; });
  return static_cast<std::size_t>(next - pieces_.begin()) - 1;
}

void Horizon::put(double from, const Line& line) {
  if (!changed_.empty() && changed_.back().line.wall == line.wall) return;
  changed_.push_back({from, line});
}

void Horizon::add(Vec2 a, Vec2 b, std::uint32_t wall) {
  if (a.x < nearest_ && b.x < nearest_) return;
  if (a.x < nearest_) a = a + (nearest_ - a.x) / (b.x - a.x) * (b - a);
  if (b.x < nearest_) b = b + (nearest_ - b.x) / (a.x - b.x) * (a - b);
  if (a.y * b.x > b.y * a.x) std::swap(a, b);
  double from = a.y / a.x;
  double to = b.y / b.x;
  if (to - from < kSameDirection || from >= reach_ || to <= -reach_) return;
  const Line line{from, 1.0 / a.x, (1.0 / b.x - 1.0 / a.x) / (to - from), wall};
  from = std::max(from, -reach_);
  to = std::min(to, reach_);

  const std::size_t first = piece_at(from);
  std::size_t last = first;  // one past the pieces that the wall spans
  changed_.clear();
  if (from - pieces_[first].from > kSameDirection) put(pieces_[first].from, pieces_[first].line);
  for (; last < pieces_.size() && pieces_[last].from < to; ++last) {
    const Line old = pieces_[last].line;
    const double begin = std::max(from, pieces_[last].from);
    const double after = end_of(last);
    const double end = std::min(to, after);
    // How much nearer the new wall is at the two ends.
    const double at_begin = line.at(begin) - old.at(begin);
    const double at_end = line.at(end) - old.at(end);
    const double same = kSamePlane * old.at(begin);
    if (std::max(at_begin, at_end) <= same) {
      if (std::min(at_begin, at_end) >= -same) as_near_.push_back(wall);
      put(begin, old);
    } else if (std::min(at_begin, at_end) >= -same) {
      put(begin, line);
    } else {
      const double crossing = begin + at_begin / (at_begin - at_end) * (end - begin);
      put(begin, at_begin > 0.0 ? line : old);
      put(crossing, at_begin > 0.0 ? old : line);
    }
    if (end < after - kSameDirection) put(end, old);
  }
  const auto begin = pieces_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto kept = std::min(changed_.size(), last - first);
  std::copy_n(changed_.begin(), kept, begin);
  const auto middle = static_cast<std::ptrdiff_t>(kept);
  if (kept < last - first) {
    pieces_.erase(begin + middle, pieces_.begin() + static_cast<std::ptrdiff_t>(last));
  } else {
    pieces_.insert(begin + middle, changed_.begin() + middle, changed_.end());
  }
}

bool Horizon::hides(std::span<const Vec2> corners) const {
  double depth = std::numeric_limits<double>::infinity();
  double from = reach_;
  double to = -reach_;
  for (const Vec2 corner : corners) {
    if (corner.x <= nearest_) return false;
    depth = std::min(depth, corner.x);
    from = std::min(from, corner.y / corner.x);
    to = std::max(to, corner.y / corner.x);
  }
  from = std::max(from, -reach_);
  to = std::min(to, reach_);
  const double inverse = (1.0 + kSamePlane) / depth;
  for (std::size_t i = piece_at(from); i < pieces_.size() && pieces_[i].from < to; ++i) {
    const double begin = std::max(from, pieces_[i].from);
    const double end = std::min(to, end_of(i));
    const Line& line = pieces_[i].line;
    if (std::min(line.at(begin), line.at(end)) <= inverse) return false;
  }
  return true;
}

double Horizon::farthest() const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const double end = end_of(i);
    const Line& line = pieces_[i].line;
    least = std::min({least, line.at(pieces_[i].from), line.at(end)});
  }
  return 1.0 / std::max(least, 0.0);
}

void Horizon::list_seen(std::vector<std::uint32_t>& walls) const {
  for (const Piece& piece : pieces_) {
    if (piece.line.wall != kOpen) walls.push_back(piece.line.wall);
  }
  walls.insert(walls.end(), as_near_.begin(), as_near_.end());
}

}  // namespace eyebridge::camera
