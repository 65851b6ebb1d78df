// The shapes that are drawn, by what every solid has: a volume, and faces that look outwards.
#include "render/mesh.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "optics/lens.hpp"
#include "pictures/marker.hpp"

namespace eyebridge::camera::testing {
namespace {

Vec3 minus(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Vec3 place(const BodyVertex& vertex) { return {vertex.x, vertex.y, vertex.z}; }
Vec3 normal(const BodyVertex& vertex) { return {vertex.nx, vertex.ny, vertex.nz}; }

/// The volume of a solid that stands on the floor and has no bottom face: the sum of the pyramids
/// from the origin to each triangle.
double volume(const BodyMesh& mesh) {
  double sixfold = 0.0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const auto corner = [&](std::size_t k) { return place(mesh.vertices.at(mesh.indices[i + k])); };
    sixfold += dot(corner(0), cross(corner(1), corner(2)));
  }
  return sixfold / 6.0;
}

void expect_normals_across_the_faces(const BodyMesh& mesh, double least_cosine) {
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const auto vertex = [&](std::size_t k) { return mesh.vertices.at(mesh.indices[i + k]); };
    const Vec3 across =
        cross(minus(place(vertex(1)), place(vertex(0))), minus(place(vertex(2)), place(vertex(0))));
    const double size = std::sqrt(dot(across, across));
    if (size < 1e-6) continue;  // at a pole of the ball
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(dot(normal(vertex(k)), normal(vertex(k))), 1.0, 1e-5);
      EXPECT_GT(dot(across, normal(vertex(k))) / size, least_cosine) << "triangle " << i / 3;
    }
  }
}

/// Area of the regular polygon in the unit circle.
double polygon_area(int corners) { return 0.5 * corners * std::sin(2.0 * kPi / corners); }

TEST(BodyMeshes, ARobotAndACanAreFlatSidedCylinders) {
  for (const BodyMesh& mesh : {robot_mesh(), can_mesh()}) {
    EXPECT_NEAR(volume(mesh), polygon_area(32), 1e-5);
    expect_normals_across_the_faces(mesh, 0.99999);
  }
}

TEST(BodyMeshes, OfARobotFiveSidesOf32LookForward) {
  const BodyMesh mesh = robot_mesh();
  const auto is_front = [&](std::size_t i) {
    const BodyVertex& vertex = mesh.vertices.at(mesh.indices[i]);
    return vertex.mark == 1.0F && std::abs(vertex.nz) < 0.5F;
  };
  double area = 0.0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    if (!is_front(i) || !is_front(i + 1) || !is_front(i + 2)) continue;
    const auto corner = [&](std::size_t k) { return place(mesh.vertices.at(mesh.indices[i + k])); };
    const Vec3 across = cross(minus(corner(1), corner(0)), minus(corner(2), corner(0)));
    area += 0.5 * std::sqrt(dot(across, across));
  }
  EXPECT_NEAR(area, 5 * 2.0 * std::sin(kPi / 32), 1e-5) << "and they are 1 high";
}

TEST(BodyMeshes, ABallIsRound) {
  const BodyMesh mesh = ball_mesh();
  // Layers between parallels, each a frustum of a pyramid with 24 sides.
  double expected = 0.0;
  for (int j = 0; j < 12; ++j) {
    const double below = std::sin(kPi * j / 12);
    const double above = std::sin(kPi * (j + 1) / 12);
    const double height = std::cos(kPi * j / 12) - std::cos(kPi * (j + 1) / 12);
    expected += height / 3 * (below * below + below * above + above * above) * polygon_area(24);
  }
  EXPECT_NEAR(volume(mesh), expected, 1e-5);
  expect_normals_across_the_faces(mesh, 0.97);
}

TEST(BodyMeshes, APolygonStandsOnItsCorners) {
  const BodyMesh mesh = polygon_mesh({{-0.2, 0.0}, {0.1, -0.2}, {0.3, 0.1}, {0.1, 0.2}});
  EXPECT_NEAR(volume(mesh), 0.1, 1e-6);
  expect_normals_across_the_faces(mesh, 0.99999);
}

TEST(MarkerMesh, CoversADiscOf24Corners) {
  const world::Marker marker{{0.75, 0.45}, {255, 0, 255}};
  const QuadMesh mesh = marker_mesh({marker});
  double area = 0.0;
  for (std::size_t quad = 0; quad < mesh.vertices.size(); quad += 4) {
    for (std::size_t k = 0; k < 4; ++k) {
      const WorldVertex& a = mesh.vertices.at(quad + k);
      const WorldVertex& b = mesh.vertices.at(quad + (k + 1) % 4);
      const Vec2 from{a.x - marker.position.x, a.y - marker.position.y};
      const Vec2 to{b.x - marker.position.x, b.y - marker.position.y};
      EXPECT_LE(norm(from), kMarkerRadius + 1e-6);
      area += 0.5 * cross(from, to);
    }
  }
  EXPECT_NEAR(area, polygon_area(24) * kMarkerRadius * kMarkerRadius, 1e-7);
}

}  // namespace
}  // namespace eyebridge::camera::testing
