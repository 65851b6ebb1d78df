#include "render/mesh.hpp"

#include <array>
#include <cmath>

#include "eyebridge/base/math.hpp"
#include "eyebridge/base/units.hpp"
#include "pictures/marker.hpp"

namespace eyebridge::camera {
namespace {

constexpr int kCylinderSides = 32;

void add_upright(QuadMesh& mesh, Vec2 from, Vec2 to, const world::Wall& wall) {
  const Vec2 along = to - from;
  const double length = norm(along);
  const Vec2 normal{along.y / length, -along.x / length};
  const double u = length / kBrickLength;
  const double v = wall.height / kCourseHeight;
  add_quad(mesh,
           {{{from, 0.0, 0.0, 0.0},
             {to, 0.0, u, 0.0},
             {to, wall.height, u, v},
             {from, wall.height, 0.0, v}}},
           wall.colour, Pattern::Bricks, light_on(normal));
}

void add_box(QuadMesh& mesh, const world::Wall& wall) {
  const std::array<Vec2, 4> corner = outline_of(wall);
  add_upright(mesh, corner[0], corner[1], wall);
  add_upright(mesh, corner[2], corner[3], wall);
  add_upright(mesh, corner[1], corner[2], wall);
  add_upright(mesh, corner[3], corner[0], wall);
  const double u = norm(wall.b - wall.a) / kBrickLength;
  const double v = wall.thickness / kCourseHeight;
  add_quad(mesh,
           {{{corner[0], wall.height, 0.0, 0.0},
             {corner[1], wall.height, u, 0.0},
             {corner[2], wall.height, u, v},
             {corner[3], wall.height, 0.0, v}}},
           wall.colour, Pattern::Bricks, 1.0);
}

/// Point `i` of `count` on the unit circle, half a step off, so that a side faces +x.
Vec2 on_circle(int i, int count) {
  return Heading::from_angle((i - 0.5) * (2.0 * kPi / count)).forward();
}

/// A strip of `sides` flat sides from `bottom` to `top`; `mark(side)` says how it is coloured.
template <class Mark>
void add_band(BodyMesh& mesh, double bottom, double top, Mark mark) {
  for (int side = 0; side < kCylinderSides; ++side) {
    const Vec2 a = on_circle(side, kCylinderSides);
    const Vec2 b = on_circle(side + 1, kCylinderSides);
    const Vec2 n = (1.0 / norm(a + b)) * (a + b);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto add = [&](Vec2 p, double z) {
      mesh.vertices.push_back({static_cast<float>(p.x), static_cast<float>(p.y),
                               static_cast<float>(z), static_cast<float>(n.x),
                               static_cast<float>(n.y), 0.0F, mark(side)});
    };
    add(a, bottom);
    add(b, bottom);
    add(b, top);
    add(a, top);
    for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.indices.push_back(first + i);
  }
}

template <class Mark>
void add_lid(BodyMesh& mesh, Mark mark) {
  for (int side = 0; side < kCylinderSides; ++side) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Vec2 p :
         {Vec2{}, on_circle(side, kCylinderSides), on_circle(side + 1, kCylinderSides)}) {
      mesh.vertices.push_back(
          {static_cast<float>(p.x), static_cast<float>(p.y), 1.0F, 0.0F, 0.0F, 1.0F, mark(side)});
    }
    for (const std::uint32_t i : {0U, 1U, 2U}) mesh.indices.push_back(first + i);
  }
}

}  // namespace

double light_on(Vec2 normal) {
  const Vec2 sun{0.342, 0.940};
  return 0.70 + 0.30 * std::abs(dot(normal, sun));
}

void add_quad(QuadMesh& mesh, const std::array<Corner, 4>& corners, Rgb colour, Pattern pattern,
              double light) {
  const auto lit = [&](std::uint8_t c) {
    return static_cast<std::uint8_t>(std::lround(c * light));
  };
  for (const Corner& corner : corners) {
    mesh.vertices.push_back({static_cast<float>(corner.at.x),
                             static_cast<float>(corner.at.y),
                             static_cast<float>(corner.z),
                             static_cast<float>(corner.u),
                             static_cast<float>(corner.v),
                             {lit(colour.r), lit(colour.g), lit(colour.b)},
                             pattern});
  }
}

std::array<Vec2, 4> outline_of(const world::Wall& wall) {
  const Vec2 along = wall.b - wall.a;
  const Vec2 half = (0.5 * wall.thickness / norm(along)) * Vec2{-along.y, along.x};
  return {wall.a + half, wall.b + half, wall.b - half, wall.a - half};
}

QuadMesh wall_mesh(const std::vector<world::Wall>& walls) {
  QuadMesh mesh;
  for (const world::Wall& wall : walls) {
    if (wall.thickness > 0.0) {
      add_box(mesh, wall);
    } else {
      add_upright(mesh, wall.a, wall.b, wall);
    }
  }
  return mesh;
}

QuadMesh floor_mesh(const world::WorldModel& model, Pattern pattern) {
  // A hair under the walls on its rim: edges that only touch leave pixels of sky between them.
  constexpr double kUnderWalls = 0.001;
  const double right = model.width + kUnderWalls;
  const double top = model.height + kUnderWalls;
  const double u = 1.0 / (pattern == Pattern::Tiles ? kTileSize : right);
  const double v = 1.0 / (pattern == Pattern::Tiles ? kTileSize : top);
  const auto corner = [&](double x, double y) {
    return Corner{model.corner + Vec2{x, y}, 0.0, x * u, y * v};
  };
  QuadMesh mesh;
  add_quad(mesh,
           {corner(-kUnderWalls, -kUnderWalls), corner(right, -kUnderWalls), corner(right, top),
            corner(-kUnderWalls, top)},
           {255, 255, 255}, pattern, 1.0);
  return mesh;
}

QuadMesh marker_mesh(const std::vector<world::Marker>& markers) {
  constexpr int kPoints = 24;
  QuadMesh mesh;
  for (const world::Marker& marker : markers) {
    const auto rim = [&](int i) {
      return Corner{marker.position + kMarkerRadius * on_circle(i, kPoints), 0, 0, 0};
    };
    for (int i = 0; i < kPoints; i += 2) {
      add_quad(mesh, {{{marker.position, 0, 0, 0}, rim(i), rim(i + 1), rim(i + 2)}}, marker.colour,
               Pattern::Plain, 1.0);
    }
  }
  return mesh;
}

BodyMesh robot_mesh() {
  // Sides -2 … 2 of 32: 56 degrees of the rim look forward.
  const auto front = [](int side) { return side <= 2 || side >= kCylinderSides - 2 ? 1.0F : 0.0F; };
  BodyMesh mesh;
  add_band(mesh, 0.0, 1.0, front);
  add_lid(mesh, front);
  return mesh;
}

BodyMesh can_mesh() {
  BodyMesh mesh;
  const auto plain = [](int) { return 0.0F; };
  const auto marked = [](int) { return 1.0F; };
  add_band(mesh, 0.0, 0.06, marked);
  add_band(mesh, 0.06, 0.94, plain);
  add_band(mesh, 0.94, 1.0, marked);
  add_lid(mesh, marked);
  return mesh;
}

BodyMesh ball_mesh() {
  constexpr int kMeridians = 24;
  constexpr int kParallels = 12;
  BodyMesh mesh;
  for (int j = 0; j <= kParallels; ++j) {
    const SinCos latitude = sin_cos(kPi * j / kParallels - kPi / 2);
    for (int i = 0; i <= kMeridians; ++i) {
      const Vec2 p = latitude.cos * on_circle(i % kMeridians, kMeridians);
      const auto x = static_cast<float>(p.x);
      const auto y = static_cast<float>(p.y);
      const auto z = static_cast<float>(latitude.sin);
      mesh.vertices.push_back({x, y, z + 1.0F, x, y, z, 0.0F});
    }
  }
  for (int j = 0; j < kParallels; ++j) {
    for (int i = 0; i < kMeridians; ++i) {
      const auto a = static_cast<std::uint32_t>(j * (kMeridians + 1) + i);
      const std::uint32_t b = a + kMeridians + 1;
      for (const std::uint32_t index : {a, a + 1, b + 1, a, b + 1, b}) {
        mesh.indices.push_back(index);
      }
    }
  }
  return mesh;
}

BodyMesh polygon_mesh(const std::vector<Vec2>& corners) {
  BodyMesh mesh;
  const auto add_corner = [&](Vec2 at, float z, Vec2 normal, float up) {
    mesh.vertices.push_back({static_cast<float>(at.x), static_cast<float>(at.y), z,
                             static_cast<float>(normal.x), static_cast<float>(normal.y), up, up});
  };
  const auto add_fan = [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t i = 2; i < count; ++i) {
      for (const std::uint32_t k : {0U, i - 1, i}) mesh.indices.push_back(first + k);
    }
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 from = corners[i];
    const Vec2 to = corners[(i + 1) % corners.size()];
    const Vec2 along = (1.0 / norm(to - from)) * (to - from);
    const Vec2 normal{along.y, -along.x};
    add_fan(static_cast<std::uint32_t>(mesh.vertices.size()), 4);
    add_corner(from, 0.0F, normal, 0.0F);
    add_corner(to, 0.0F, normal, 0.0F);
    add_corner(to, 1.0F, normal, 0.0F);
    add_corner(from, 1.0F, normal, 0.0F);
  }
  add_fan(static_cast<std::uint32_t>(mesh.vertices.size()),
          static_cast<std::uint32_t>(corners.size()));
  for (const Vec2 corner : corners) add_corner(corner, 1.0F, {}, 1.0F);
  return mesh;
}

}  // namespace eyebridge::camera
