#include "convex.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace eyebridge::world {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// Of an edge along the unit vector `u` whose inner side is to the left.
Vec2 outward(Vec2 u) { return {u.y, -u.x}; }

/// How far beyond edge `i` of `a` all of `b` lies, metres.
double beyond(const Convex& a, std::size_t i, const Convex& b) {
  double least = kEndless;
  for (const Vec2 p : b.corners()) least = std::min(least, a.beyond(i, p));
  return least;
}

/// Calls visit(distance, axis) for all axes that can separate the two: how far apart they are along
/// it, metres, and its direction from `a` to `b`, a unit vector.
template <class Visit>
void each_axis(const Convex& a, const Convex& b, Visit visit) {
  for (std::size_t i = 0; i < a.count; ++i) visit(beyond(a, i, b), a.normal[i]);
  for (std::size_t i = 0; i < b.count; ++i) visit(beyond(b, i, a), -1.0 * b.normal[i]);
}

}  // namespace

Outline::Outline(std::vector<Vec2> its_corners) : corners(std::move(its_corners)) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    normals.push_back(outward(segment_between(corners[i], corners[(i + 1) % corners.size()]).u));
  }
}

Convex::Convex(const Outline& outline, Vec2 place, Vec2 u) : count(outline.corners.size()) {
  assert(count <= kMostCorners);
  const Heading heading{u.x, u.y};
  for (std::size_t i = 0; i < count; ++i) {
    corner[i] = place + heading.rotate(outline.corners[i]);
    normal[i] = heading.rotate(outline.normals[i]);
  }
}

Convex::Convex(const Segment& wall) : count(4) {
  corner[0] = corner[3] = wall.a;
  corner[1] = corner[2] = wall.a + wall.length * wall.u;
  normal[0] = outward(wall.u);
  normal[1] = wall.u;
  normal[2] = -1.0 * normal[0];
  normal[3] = -1.0 * normal[1];
}

Segment Convex::edge(std::size_t i) const {
  const Vec2 u{-normal[i].y, normal[i].x};
  return {corner[i], u, dot(corner[i + 1 < count ? i + 1 : 0] - corner[i], u)};
}

Vec2 closest_point(const Convex& shape, Vec2 p) {
  Vec2 best = p;
  double least = kEndless;
  bool within = true;
  for (std::size_t i = 0; i < shape.count; ++i) {
    if (shape.beyond(i, p) <= 0.0) continue;  // another edge is nearer
    within = false;
    const Vec2 near = closest_point(shape.edge(i), p);
    const double distance = norm_squared(p - near);
    if (distance >= least) continue;
    least = distance;
    best = near;
  }
  return within ? p : best;
}

double distance_to(const Convex& shape, Vec2 p) {
  double most = -kEndless;
  for (std::size_t i = 0; i < shape.count; ++i) most = std::max(most, shape.beyond(i, p));
  return most <= 0.0 ? most : norm(p - closest_point(shape, p));
}

Separation separation(const Convex& a, const Convex& b) {
  Separation best{-kEndless, {}};
  each_axis(a, b, [&](double distance, Vec2 axis) {
    if (distance > best.distance) best = {distance, axis};
  });
  return best;
}

Vec2 contact_place(const Convex& a, const Convex& b, Vec2 normal) {
  constexpr double kFlat = 1e-6;  // metres: corners that are as far out lie on one side
  const Vec2 along{-normal.y, normal.x};
  // What touches: the corners that are farthest out, from ... to along the contact.
  struct Touching {
    double out = -kEndless;
    double from = kEndless;
    double to = -kEndless;
  };
  const auto touching = [&](const Convex& shape, Vec2 way) {
    Touching found;
    for (const Vec2 p : shape.corners()) found.out = std::max(found.out, dot(way, p));
    for (const Vec2 p : shape.corners()) {
      if (dot(way, p) < found.out - kFlat) continue;
      found.from = std::min(found.from, dot(along, p));
      found.to = std::max(found.to, dot(along, p));
    }
    return found;
  };
  const Touching own = touching(a, normal);
  const Touching other = touching(b, -1.0 * normal);
  const double middle = 0.5 * (std::max(own.from, other.from) + std::min(own.to, other.to));
  return own.out * normal + std::clamp(middle, own.from, own.to) * along;
}

double nearer_convex_hit(const Convex& shape, Vec2 origin, Vec2 direction, double best) {
  double from = 0.0;
  double to = best;
  for (std::size_t i = 0; i < shape.count; ++i) {
    const double beyond = shape.beyond(i, origin);
    const double climb = dot(shape.normal[i], direction);
    if (std::fabs(climb) < kParallel) {
      if (beyond > 0.0) return best;
    } else if (climb < 0.0) {
      from = std::max(from, beyond / -climb);
    } else {
      to = std::min(to, -beyond / climb);
    }
  }
  return from <= to ? from : best;
}

double disc_convex_contact(const Convex& shape, Vec2 from, Vec2 motion, double reach) {
  if (distance_to(shape, from) < 0.0) return kNoContact;
  double first = kNoContact;
  for (std::size_t i = 0; i < shape.count; ++i) {
    first = std::min(first, wall_contact(shape.edge(i), from, motion, reach));
  }
  return first;
}

double convex_contact(const Convex& a, const Convex& b, Vec2 motion, double gap) {
  const double parallel = kParallelAngle * norm(motion);
  double meet = -kEndless;     // where they come within half the gap of each other,
  double leave = kEndless;     // where they are farther apart again
  double stop = -kEndless;     // and where they came within the gap
  double deepest = -kEndless;  // of the axes in which they overlap, the one with the least depth
  double inward = 0.0;         // and the motion along it
  bool apart = false;          // for good
  each_axis(a, b, [&](double distance, Vec2 axis) {
    // Who arrived stays out, whatever rounding made of the place: half the gap is room for it. And
    // who comes no nearer than that to a corner passes it, for it would be caught by the corners of
    // what it slides along: these are farther out than the gap where its own are sharp.
    const double left = distance - gap / 2;
    const double speed = dot(motion, axis);
    if (left >= 0.0) {
      if (speed <= parallel) {
        apart = true;
        return;
      }
      meet = std::max(meet, left / speed);
      stop = std::max(stop, std::max(0.0, (distance - gap) / speed));
      return;
    }
    if (left > deepest) {
      deepest = left;
      inward = speed;
    }
    if (speed < 0.0) leave = std::min(leave, left / speed);
  });
  if (apart) return kNoContact;
  if (meet == -kEndless) return inward > parallel ? 0.0 : kNoContact;
  return meet <= leave && stop <= 1.0 ? stop : kNoContact;
}

}  // namespace eyebridge::world
