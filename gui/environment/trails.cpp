#include "environment/trails.hpp"

#include <algorithm>

namespace eyebridge::gui {
namespace {

constexpr double kNearest = 0.005;  // metres between two points
constexpr double kFastest = 5.0;    // metres a second: whoever is faster was carried
constexpr double kLeastJump = 0.1;  // metres

}  // namespace

void Trails::add(const hal::WorldLook& look) {
  robots_.resize(std::max(robots_.size(), look.robots.size()));
  const double jump = std::max(kLeastJump, kFastest * (look.scene.time - last_time_));
  last_time_ = look.scene.time;
  for (std::size_t i = 0; i < look.robots.size(); ++i) {
    std::deque<Point>& trail = robots_[i].points;
    if (!look.robots[i].is_there) {
      if (!trail.empty()) ++version_;
      trail.clear();
      continue;
    }
    const Vec2 place = look.robots[i].pose.position();
    const double way = trail.empty() ? jump * 2 : norm(place - trail.back().place);
    if (way < kNearest) continue;
    trail.push_back({place, way > jump});
    if (trail.size() <= kLongest) continue;
    trail.pop_front();
    ++robots_[i].gone;
  }
}

const Trails::Trail& Trails::of(std::size_t robot) const {
  static const Trail none;
  return robot < robots_.size() ? robots_[robot] : none;
}

}  // namespace eyebridge::gui
