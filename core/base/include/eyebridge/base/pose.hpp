#pragma once

#include <cmath>

#include "eyebridge/base/math.hpp"

namespace eyebridge {

/// A point or a displacement in the plane, metres. x forward or east, y left or north.
struct Vec2 {
  double x = 0.0;
  double y = 0.0;

  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator*(double k, Vec2 v) { return {k * v.x, k * v.y}; }
  friend constexpr Vec2 operator*(Vec2 v, double k) { return {k * v.x, k * v.y}; }
  friend constexpr bool operator==(Vec2, Vec2) = default;
};

constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
constexpr double norm_squared(Vec2 v) { return dot(v, v); }
inline double norm(Vec2 v) { return std::sqrt(norm_squared(v)); }

/// Which way something points, as a unit vector: no trigonometry in the stepping loop.
struct Heading {
  double cos = 1.0;
  double sin = 0.0;

  /// From an angle in radians, counter-clockwise from +x.
  static Heading from_angle(double angle) {
    const SinCos sc = sin_cos(angle);
    return {sc.cos, sc.sin};
  }
  /// Radians, (-pi, pi].
  [[nodiscard]] double angle() const { return arc_tan2(sin, cos); }
  [[nodiscard]] constexpr Vec2 forward() const { return {cos, sin}; }
  /// A vector of this frame, in the frame the heading is given in.
  [[nodiscard]] constexpr Vec2 rotate(Vec2 v) const {
    return {cos * v.x - sin * v.y, sin * v.x + cos * v.y};
  }
  /// This heading, turned counter-clockwise by `other`.
  [[nodiscard]] constexpr Heading turned(Heading other) const {
    return {cos * other.cos - sin * other.sin, sin * other.cos + cos * other.sin};
  }
  friend constexpr bool operator==(Heading, Heading) = default;
};

/// Place and heading in the plane: metres, radians counter-clockwise from +x.
struct Pose {
  double x = 0.0;
  double y = 0.0;
  double theta = 0.0;

  [[nodiscard]] constexpr Vec2 position() const { return {x, y}; }
  friend constexpr bool operator==(const Pose&, const Pose&) = default;
};

/// `local` (a pose in the frame `frame`) as a pose in the frame that `frame` is given in.
inline Pose transform(const Pose& frame, const Pose& local) {
  const Vec2 p = frame.position() + Heading::from_angle(frame.theta).rotate(local.position());
  return {p.x, p.y, wrap_angle(frame.theta + local.theta)};
}

/// `pose` as seen from `frame`; both are given in the same frame. Undoes transform().
inline Pose relative_to(const Pose& frame, const Pose& pose) {
  const Vec2 away = pose.position() - frame.position();
  const Vec2 p = Heading::from_angle(-frame.theta).rotate(away);
  return {p.x, p.y, wrap_angle(pose.theta - frame.theta)};
}

/// Speed of a robot: metres per second forward, radians per second counter-clockwise.
struct Twist {
  double linear = 0.0;
  double angular = 0.0;

  friend constexpr bool operator==(const Twist&, const Twist&) = default;
};

/// Speed of a robot that may go sideways, too, in its own frame: metres per second forward and to
/// the left, radians per second counter-clockwise.
struct HolonomicTwist {
  double linear = 0.0;
  double lateral = 0.0;
  double angular = 0.0;

  friend constexpr bool operator==(const HolonomicTwist&, const HolonomicTwist&) = default;
};

}  // namespace eyebridge
