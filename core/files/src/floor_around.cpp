#include "floor_around.hpp"

#include <algorithm>
#include <limits>

namespace eyebridge::files {

bool floor_around(world::WorldModel& model) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Vec2 low{kFar, kFar};
  Vec2 high{-kFar, -kFar};
  const auto take = [&](Vec2 p, double around) {
    low = {std::min(low.x, p.x - around), std::min(low.y, p.y - around)};
    high = {std::max(high.x, p.x + around), std::max(high.y, p.y + around)};
  };
  for (const world::Wall& wall : model.walls) {
    take(wall.a, wall.thickness / 2);
    take(wall.b, wall.thickness / 2);
  }
  for (const world::ObjectSpec& object : model.objects) {
    take(object.pose.position(), object.outer_radius());
  }
  for (const world::StartPose& start : model.starts) take(start.pose.position(), 0);
  constexpr double kLeast = 0.001;
  if (!(high.x - low.x >= kLeast) || !(high.y - low.y >= kLeast)) return false;
  model.corner = low;
  model.width = high.x - low.x;
  model.height = high.y - low.y;
  return true;
}

}  // namespace eyebridge::files
