#include "eyebridge/camera/birdseye.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "pictures/canvas.hpp"
#include "pictures/marker.hpp"

namespace eyebridge::camera {
namespace {

constexpr Rgb kAround{255, 255, 255};
constexpr Rgb kGround{244, 244, 240};
constexpr Rgb kGrid{222, 222, 216};
constexpr Rgb kFrame{150, 150, 146};
constexpr Rgb kLine{60, 60, 60};
constexpr Rgb kStart{70, 120, 200};

/// A wall as seen on white paper: walls of the default, nearly white colour are drawn dark.
Rgb wall_ink(Rgb colour) {
  const int lightest = std::max({int{colour.r}, int{colour.g}, int{colour.b}});
  const int darkest = std::min({int{colour.r}, int{colour.g}, int{colour.b}});
  return darkest > 200 && lightest - darkest < 40 ? kLine : colour;
}

void draw_floor(Canvas& canvas, const world::WorldModel& model) {
  const Vec2 near = model.corner;
  const Vec2 far = model.far_corner();
  canvas.fill_rectangle(near, far, kGround);
  double step = model.maze ? model.maze->cell : 1.0;
  while (canvas.to_pixels(step) < 6.0) step *= 10.0;  // lines must not run together
  const auto first = [step](double edge) { return (std::floor(edge / step) + 1) * step; };
  for (double x = first(near.x); x < far.x; x += step) {
    canvas.line({x, near.y}, {x, far.y}, 1.0, kGrid);
  }
  for (double y = first(near.y); y < far.y; y += step) {
    canvas.line({near.x, y}, {far.x, y}, 1.0, kGrid);
  }
  canvas.outline_rectangle(near, far, kFrame);
}

void draw_starts(Canvas& canvas, const world::WorldModel& model) {
  const double cell = model.maze ? model.maze->cell : 0.3;
  for (const world::StartPose& start : model.starts) {
    const Vec2 forward = Heading::from_angle(start.pose.theta).forward();
    const Vec2 at = start.pose.position();
    canvas.line(at + 0.22 * cell * forward, at + 0.40 * cell * forward, 2.0, kStart);
    if (start.letter != 0) {
      canvas.text(at, std::string(1, start.letter), 0.4 * canvas.to_pixels(cell), kStart);
    } else {
      canvas.ring(at, 0.12 * cell, kStart);
    }
  }
}

void draw_walls(Canvas& canvas, const world::WorldModel& model) {
  for (const world::Wall& wall : model.walls) {
    const double width = std::max(canvas.to_pixels(wall.thickness), Canvas::kThinLine);
    canvas.line(wall.a, wall.b, width, wall_ink(wall.colour));
  }
}

void draw_polygon(Canvas& canvas, const world::BodyView& body) {
  const Heading heading = Heading::from_angle(body.pose.theta);
  std::vector<Vec2> corners;
  for (const Vec2 corner : *body.corners) {
    corners.push_back(body.pose.position() + heading.rotate(corner));
  }
  canvas.polygon(corners, body.colour);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    canvas.line(corners[i], corners[(i + 1) % corners.size()], 1.0, kLine);
  }
}

void draw_body(Canvas& canvas, const world::BodyView& body) {
  if (body.corners) return draw_polygon(canvas, body);
  const Vec2 at = body.pose.position();
  const double radius = std::max(body.radius, 2.5 / canvas.to_pixels(1.0));
  canvas.disc(at, radius, body.colour);
  canvas.ring(at, radius, kLine);
  if (body.shape != world::BodyShape::Robot) return;
  const Heading heading = Heading::from_angle(body.pose.theta);
  const bool dark = 3 * body.colour.r + 6 * body.colour.g + body.colour.b < 1280;
  const Vec2 mark[] = {at + heading.rotate({0.85 * radius, 0.0}),
                       at + heading.rotate({-0.35 * radius, 0.5 * radius}),
                       at + heading.rotate({-0.35 * radius, -0.5 * radius})};
  canvas.polygon(mark, dark ? kAround : kLine);
}

/// A bar of 1, 2 or 5 times a power of ten metres, about a fifth of the picture long.
void draw_scale(Canvas& canvas, double world_width) {
  double length = 1e-3;
  for (double decade = 1e-3; decade < world_width; decade *= 10.0) {
    for (const double step : {decade, 2.0 * decade, 5.0 * decade}) {
      if (step <= std::max(0.25 * world_width, 1e-3)) length = step;
    }
  }
  // Integers, so that no locale and no rounding shows in the label.
  const long millimetres = std::lround(length * 1000.0);
  const std::string label = millimetres >= 1000 ? std::to_string(millimetres / 1000) + " m"
                                                : std::to_string(millimetres) + " mm";
  canvas.scale_bar(length, label, kLine);
}

}  // namespace

Frame draw_birdseye(const world::Scene& scene, std::span<const Trail> trails,
                    const BirdseyeOptions& options) {
  const world::WorldModel& model = *scene.model;
  Vec2 low = model.corner;
  Vec2 high = model.far_corner();
  for (const world::Wall& wall : model.walls) {
    for (const Vec2 end : {wall.a, wall.b}) {
      low = {std::min(low.x, end.x), std::min(low.y, end.y)};
      high = {std::max(high.x, end.x), std::max(high.y, end.y)};
    }
  }
  Canvas canvas(low, high, options.longest_side, kAround);
  draw_floor(canvas, model);
  for (const world::Marker& marker : model.markers) {
    canvas.disc(marker.position, kMarkerRadius, marker.colour);
  }
  draw_starts(canvas, model);
  for (const Trail& trail : trails) canvas.path(trail.points, 2.0, trail.colour);
  draw_walls(canvas, model);
  for (const world::BodyView& body : scene.bodies) draw_body(canvas, body);
  draw_scale(canvas, high.x - low.x);
  Frame frame = canvas.picture();
  frame.time = from_seconds(scene.time);
  return frame;
}

}  // namespace eyebridge::camera
