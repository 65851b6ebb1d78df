#include "boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace eyebridge::world {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

Vec2 left_of(Vec2 v) { return {-v.y, v.x}; }

/// The only directions in which two rectangles that do not meet can be told apart.
std::array<Vec2, 4> axes_of(const Rectangle& a, const Rectangle& b) {
  return {a.u, left_of(a.u), b.u, left_of(b.u)};
}

/// Half the width of the shadow that `box` throws on a line along `axis`.
double extent(const Rectangle& box, Vec2 axis) {
  return box.half.x * std::fabs(dot(box.u, axis)) + box.half.y * std::fabs(cross(box.u, axis));
}

/// Cuts the part of a ray with |offset + t * climb| <= half out of from ... to.
void cut(double offset, double climb, double half, double& from, double& to) {
  if (std::fabs(climb) < kParallel) {
    if (std::fabs(offset) > half) to = -1.0;
    return;
  }
  const double low = (-half - offset) / climb;
  const double high = (half - offset) / climb;
  from = std::max(from, std::min(low, high));
  to = std::min(to, std::max(low, high));
}

}  // namespace

Rectangle rectangle_of(const Segment& wall) {
  return {wall.a + (wall.length / 2) * wall.u, wall.u, {wall.length / 2, 0.0}};
}

Vec2 closest_point(const Rectangle& box, Vec2 p) {
  const Vec2 at = box.local(p);
  if (std::fabs(at.x) <= box.half.x && std::fabs(at.y) <= box.half.y) return p;
  const double x = std::clamp(at.x, -box.half.x, box.half.x);
  const double y = std::clamp(at.y, -box.half.y, box.half.y);
  return box.centre + x * box.u + y * left_of(box.u);
}

double distance_to(const Rectangle& box, Vec2 p) {
  const Vec2 at = box.local(p);
  const double x = std::fabs(at.x) - box.half.x;
  const double y = std::fabs(at.y) - box.half.y;
  if (x <= 0.0 && y <= 0.0) return std::max(x, y);
  return norm({std::max(x, 0.0), std::max(y, 0.0)});
}

Separation separation(const Rectangle& a, const Rectangle& b) {
  const Vec2 way = b.centre - a.centre;
  Separation best{-kEndless, {}};
  for (const Vec2 axis : axes_of(a, b)) {
    const double along = dot(way, axis);
    const double apart = std::fabs(along) - extent(a, axis) - extent(b, axis);
    if (apart > best.distance) best = {apart, along < 0.0 ? -1.0 * axis : axis};
  }
  return best;
}

double nearer_box_hit(const Rectangle& box, Vec2 origin, Vec2 direction, double best) {
  const Vec2 at = box.local(origin);
  double from = 0.0;
  double to = best;
  cut(at.x, dot(box.u, direction), box.half.x, from, to);
  cut(at.y, cross(box.u, direction), box.half.y, from, to);
  return from <= to ? from : best;
}

double disc_box_contact(const Rectangle& box, Vec2 from, Vec2 motion, double reach) {
  if (distance_to(box, from) < 0.0) return kNoContact;
  const Vec2 length = box.half.x * box.u;
  const Vec2 v = left_of(box.u);
  const Vec2 width = box.half.y * v;
  const Segment edges[] = {{box.centre - length - width, box.u, 2 * box.half.x},
                           {box.centre - length + width, box.u, 2 * box.half.x},
                           {box.centre - length - width, v, 2 * box.half.y},
                           {box.centre + length - width, v, 2 * box.half.y}};
  double first = kNoContact;
  for (const Segment& edge : edges) {
    first = std::min(first, wall_contact(edge, from, motion, reach));
  }
  return first;
}

double box_contact(const Rectangle& a, const Rectangle& b, Vec2 motion, double gap) {
  const Vec2 way = b.centre - a.centre;
  const double parallel = kParallelAngle * norm(motion);
  double enter = -kEndless;
  double leave = kEndless;
  double deepest = -kEndless;  // of the axes in which they overlap, the one with the least depth
  double inward = 0.0;         // and the motion along it
  for (const Vec2 axis : axes_of(a, b)) {
    const double reach = extent(a, axis) + extent(b, axis) + gap;
    const double along = dot(way, axis);
    const double distance = std::fabs(along);
    const double speed = along < 0.0 ? -dot(motion, axis) : dot(motion, axis);
    // Who arrived stays out, whatever rounding made of the place: half the gap is room for it.
    if (distance >= reach - gap / 2) {
      if (speed <= parallel) return kNoContact;
      enter = std::max(enter, std::max(0.0, (distance - reach) / speed));
      leave = std::min(leave, (distance + reach) / speed);
      continue;
    }
    if (distance - reach > deepest) {
      deepest = distance - reach;
      inward = speed;
    }
    if (speed > 0.0) leave = std::min(leave, (distance + reach) / speed);
    if (speed < 0.0) leave = std::min(leave, (reach - distance) / -speed);
  }
  if (enter == -kEndless) return inward > parallel ? 0.0 : kNoContact;
  return enter <= leave && enter <= 1.0 ? enter : kNoContact;
}

}  // namespace eyebridge::world
