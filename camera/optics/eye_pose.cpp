#include "optics/eye_pose.hpp"

#include <algorithm>
#include <cmath>

namespace eyebridge::camera {
namespace {

constexpr double kNearest = 0.001;  // metres

}  // namespace

Vector<6> difference(const EyePose& a, const EyePose& b) {
  Vector<6> d{};
  for (std::size_t i = 0; i < 6; ++i) d[i] = a.values[i] - b.values[i];
  for (const std::size_t angle : {kHeading, kPitch, kRoll}) d[angle] = wrap_angle(d[angle]);
  return d;
}

EyePose moved(const EyePose& pose, const Vector<6>& step) {
  EyePose out = pose;
  for (std::size_t i = 0; i < 6; ++i) out.values[i] += step[i];
  for (const std::size_t angle : {kHeading, kPitch, kRoll}) {
    out.values[angle] = wrap_angle(out.values[angle]);
  }
  return out;
}

EyePose eye_pose(Vec3 position, Vec3 right, Vec3 forward) {
  const double level = std::sqrt(forward.x * forward.x + forward.y * forward.y);
  const double heading = arc_tan2(forward.y, forward.x);
  const double pitch = arc_tan2(forward.z, level);
  const SinCos h = sin_cos(heading);
  const SinCos p = sin_cos(pitch);
  const Vec3 level_right{h.sin, -h.cos, 0.0};
  const Vec3 level_down{h.cos * p.sin, h.sin * p.sin, -p.cos};
  const double roll = arc_tan2(dot(right, level_down), dot(right, level_right));
  return {{position.x, position.y, position.z, heading, pitch, roll}};
}

std::optional<Projection> project(const EyePose& pose, const Calibration& lens, Vec3 point) {
  const SinCos h = sin_cos(pose.values[kHeading]);
  const SinCos p = sin_cos(pose.values[kPitch]);
  const SinCos r = sin_cos(pose.values[kRoll]);
  const Vec3 forward{h.cos * p.cos, h.sin * p.cos, p.sin};
  const Vec3 level_right{h.sin, -h.cos, 0.0};
  const Vec3 level_down{h.cos * p.sin, h.sin * p.sin, -p.cos};

  const Vec3 at = pose.position();
  const Vec3 d{point.x - at.x, point.y - at.y, point.z - at.z};
  const double z = dot(forward, d);
  if (z < kNearest) return std::nullopt;
  const double x0 = dot(level_right, d);
  const double y0 = dot(level_down, d);
  const double x = r.cos * x0 + r.sin * y0;
  const double y = r.cos * y0 - r.sin * x0;

  // How (x, y, z) in the camera's frame changes with each value: derivatives of the rotations.
  const double ahead = p.cos * z + p.sin * y0;  // along the level part of the axis
  const double turned_x = ahead;
  const double turned_y = -p.sin * x0;
  const Vec3 by[6] = {
      {-(r.cos * level_right.x + r.sin * level_down.x),
       -(r.cos * level_down.x - r.sin * level_right.x), -forward.x},
      {-(r.cos * level_right.y + r.sin * level_down.y),
       -(r.cos * level_down.y - r.sin * level_right.y), -forward.y},
      {-r.sin * level_down.z, -r.cos * level_down.z, -forward.z},
      {r.cos * turned_x + r.sin * turned_y, r.cos * turned_y - r.sin * turned_x, -p.cos * x0},
      {r.sin * z, r.cos * z, -y0},
      {y, -x, 0.0},
  };
  Projection out;
  out.pixel = {lens.cx + lens.fx * x / z, lens.cy + lens.fy * y / z};
  for (std::size_t i = 0; i < 6; ++i) {
    out.jacobian(0, i) = lens.fx * (by[i].x - x / z * by[i].z) / z;
    out.jacobian(1, i) = lens.fy * (by[i].y - y / z * by[i].z) / z;
  }
  return out;
}

std::array<Vec3, 4> corners_of(const Fiducial& fiducial) {
  const Vec2 normal = Heading::from_angle(fiducial.facing).forward();
  const Vec2 right{-normal.y, normal.x};
  const double half = 0.5 * fiducial.size;
  const auto corner = [&](double across, double up) {
    const Vec2 at = fiducial.centre + across * right;
    return Vec3{at.x, at.y, fiducial.z + up};
  };
  return {corner(-half, half), corner(half, half), corner(half, -half), corner(-half, -half)};
}

}  // namespace eyebridge::camera
