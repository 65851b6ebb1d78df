#include "geometry.hpp"

namespace eyebridge::world {
namespace {

/// Who is this near to the reach (metres) has arrived: more than the rounding of a position, so
/// that a body that was stopped is stopped for good.
constexpr double kContactSlack = 1e-12;

/// True when `motion` leads against `outward`, the vector from the obstacle.
bool leads_inward(Vec2 motion, Vec2 outward) {
  const double along = dot(motion, outward);
  return along < 0.0 && along * along > kParallelAngle * kParallelAngle * norm_squared(motion) *
                                            norm_squared(outward);
}

}  // namespace

Segment segment_between(Vec2 a, Vec2 b) {
  const Vec2 span = b - a;
  const double length = norm(span);
  return {a, {span.x / length, span.y / length}, length};
}

std::vector<Segment> outlines_of(const std::vector<Wall>& walls) {
  std::vector<Segment> segments;
  segments.reserve(walls.size());
  for (const Wall& wall : walls) {
    const Segment axis = segment_between(wall.a, wall.b);
    if (wall.thickness <= 0.0) {
      segments.push_back(axis);
      continue;
    }
    const Vec2 side = (wall.thickness / 2) * Vec2{-axis.u.y, axis.u.x};
    const Vec2 corners[] = {wall.a - side, wall.b - side, wall.b + side, wall.a + side};
    for (std::size_t i = 0; i < 4; ++i) {
      segments.push_back(segment_between(corners[i], corners[(i + 1) % 4]));
    }
  }
  return segments;
}

double disc_contact(Vec2 from, Vec2 motion, double reach) {
  const double c = norm_squared(from) - reach * reach;
  if (c <= 2 * kContactSlack * reach) return leads_inward(motion, from) ? 0.0 : kNoContact;
  const double b = dot(from, motion);
  if (b >= 0.0) return kNoContact;
  const double discriminant = b * b - norm_squared(motion) * c;
  if (discriminant <= 0.0) return kNoContact;
  // The smaller root, in the form that does not cancel.
  const double fraction = c / (std::sqrt(discriminant) - b);
  return fraction <= 1.0 ? fraction : kNoContact;
}

double wall_contact(const Segment& wall, Vec2 from, Vec2 motion, double reach) {
  const Vec2 rel = from - wall.a;
  const double s = dot(rel, wall.u);
  const double height = cross(wall.u, rel);
  const double distance = height < 0 ? -height : height;
  const double climb = cross(wall.u, motion);
  if (distance > reach + kContactSlack) {
    const double approach = height < 0 ? climb : -climb;
    const double gap = distance - reach;
    if (approach < gap) return kNoContact;  // also when it moves away
    const double fraction = gap / approach;
    const double s_there = s + fraction * dot(motion, wall.u);
    if (s_there >= 0.0 && s_there <= wall.length) return fraction;
  } else if (s >= 0.0 && s <= wall.length) {
    const Vec2 normal{-wall.u.y, wall.u.x};
    return leads_inward(motion, height * normal) ? 0.0 : kNoContact;
  }
  const double at_a = disc_contact(rel, motion, reach);
  const double at_b = disc_contact(rel - wall.length * wall.u, motion, reach);
  return at_a < at_b ? at_a : at_b;
}

}  // namespace eyebridge::world
