#include "eyebridge/planning/path_progress.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace eyebridge::planning {

PathProgress::PathProgress(std::vector<Vec2> points) : points_(std::move(points)) {
  if (points_.empty()) throw std::invalid_argument("a path to follow needs at least one point");
  starts_.push_back(0.0);
  for (std::size_t i = 1; i < points_.size(); ++i) {
    starts_.push_back(starts_.back() + norm(points_[i] - points_[i - 1]));
  }
}

std::size_t PathProgress::line_at(double along) const {
  const auto after = std::upper_bound(starts_.begin(), starts_.end(), along);
  const std::size_t next = static_cast<std::size_t>(after - starts_.begin());
  const std::size_t lines = points_.size() - 1;
  return std::min(next > 0 ? next - 1 : 0, lines > 0 ? lines - 1 : 0);
}

Vec2 PathProgress::at(double along) const {
  if (along >= starts_.back()) return points_.back();
  const std::size_t i = line_at(along);
  const double share = (along - starts_[i]) / (starts_[i + 1] - starts_[i]);
  return points_[i] + share * (points_[i + 1] - points_[i]);
}

void PathProgress::advance(Vec2 position, double window) {
  const double limit = std::min(done_ + window, starts_.back());
  double nearest = norm_squared(at(done_) - position);
  double reached = done_;
  for (std::size_t i = line_at(done_); i + 1 < points_.size() && starts_[i] <= limit; ++i) {
    const double length = starts_[i + 1] - starts_[i];
    if (length == 0.0) continue;
    const Vec2 direction = 1.0 / length * (points_[i + 1] - points_[i]);
    const double low = std::max(done_, starts_[i]);
    const double high = std::min(limit, starts_[i + 1]);
    const double along = std::clamp(starts_[i] + dot(position - points_[i], direction), low, high);
    const double away = norm_squared(at(along) - position);
    if (away >= nearest) continue;
    nearest = away;
    reached = along;
  }
  done_ = reached;
}

Vec2 PathProgress::ahead(double distance) const { return at(done_ + distance); }

Vec2 PathProgress::leaving_circle(Vec2 position, double distance) const {
  const double squared = distance * distance;
  Vec2 from = at(done_);
  if (norm_squared(from - position) >= squared) return from;
  for (std::size_t i = line_at(done_); i + 1 < points_.size(); ++i) {
    const Vec2 to = points_[i + 1];
    if (norm_squared(to - position) < squared) {
      from = to;
      continue;
    }
    // |from + t (to - from) - position| = distance, of which one solution lies ahead.
    const Vec2 line = to - from;
    const Vec2 out = from - position;
    const double a = norm_squared(line);
    const double b = dot(out, line);
    const double c = norm_squared(out) - squared;
    return from + (-b + std::sqrt(b * b - a * c)) / a * line;
  }
  return points_.back();
}

}  // namespace eyebridge::planning
