#include "eyebridge/mapping/ground_truth.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace eyebridge::mapping {
namespace {

/// A rectangle in the plane: a wall.
struct Slab {
  Vec2 centre;
  Heading heading;  ///< Of its length.
  double half_length;
  double half_width;
};

// Cells hold their lower and left edge; what lies on one to within this share of a cell is on it.
constexpr double kEdge = 1e-6;

/// The corners of a cell as its centre and half its edge, moved a little so that it holds what lies
/// on its lower and left edge, and not what lies on the others.
struct Square {
  Vec2 centre;
  double half;
};

Square square_of(const GridGeometry& g, Cell cell) {
  const Vec2 middle = g.centre_of(cell);
  const double slip = kEdge * g.resolution;
  return {{middle.x - slip, middle.y - slip}, 0.5 * g.resolution};
}

/// Whether the two overlap: no axis of either separates them.
bool overlap(const Slab& slab, const Square& square) {
  const Vec2 away = square.centre - slab.centre;
  const double c = std::abs(slab.heading.cos);
  const double s = std::abs(slab.heading.sin);
  const Vec2 in_slab{dot(away, slab.heading.forward()), cross(slab.heading.forward(), away)};
  const double own = square.half * (c + s);
  return std::abs(away.x) <= square.half + c * slab.half_length + s * slab.half_width &&
         std::abs(away.y) <= square.half + s * slab.half_length + c * slab.half_width &&
         std::abs(in_slab.x) <= slab.half_length + own &&
         std::abs(in_slab.y) <= slab.half_width + own;
}

/// The same of a convex polygon, corners counter-clockwise.
bool overlap(const std::vector<Vec2>& corners, const Square& square) {
  Vec2 low = corners.front();
  Vec2 high = low;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 from = corners[i];
    low = {std::min(low.x, from.x), std::min(low.y, from.y)};
    high = {std::max(high.x, from.x), std::max(high.y, from.y)};
    const Vec2 along = corners[(i + 1) % corners.size()] - from;
    const double own = square.half * (std::abs(along.x) + std::abs(along.y));
    if (cross(along, square.centre - from) < -own) return false;  // all of it is beyond that edge
  }
  return std::abs(2.0 * square.centre.x - low.x - high.x) <= 2.0 * square.half + high.x - low.x &&
         std::abs(2.0 * square.centre.y - low.y - high.y) <= 2.0 * square.half + high.y - low.y;
}

bool overlap(Vec2 centre, double radius, const Square& square) {
  const double x = std::max(std::abs(square.centre.x - centre.x) - square.half, 0.0);
  const double y = std::max(std::abs(square.centre.y - centre.y) - square.half, 0.0);
  return x * x + y * y <= radius * radius;
}

/// Marks the cells within `reach` of `centre` along both axes for which touches(square) holds.
template <class Touches>
void fill(OccupancyGrid& grid, Vec2 centre, Vec2 reach, Touches&& touches) {
  const GridGeometry& g = grid.geometry();
  const auto bound = [&](double place, double corner, int count) {
    const double cell = std::floor((place - corner) / g.resolution);
    return static_cast<int>(std::min(std::max(cell, -1.0), static_cast<double>(count)));
  };
  const int left = std::max(bound(centre.x - reach.x, g.origin.x, g.columns) - 1, 0);
  const int right = std::min(bound(centre.x + reach.x, g.origin.x, g.columns) + 1, g.columns - 1);
  const int low = std::max(bound(centre.y - reach.y, g.origin.y, g.rows) - 1, 0);
  const int high = std::min(bound(centre.y + reach.y, g.origin.y, g.rows) + 1, g.rows - 1);
  for (int row = low; row <= high; ++row) {
    for (int column = left; column <= right; ++column) {
      if (touches(square_of(g, {column, row}))) grid.set_probability({column, row}, 1.0);
    }
  }
}

void fill(OccupancyGrid& grid, const Slab& slab) {
  // A long slanted wall has many cells around it that it does not touch: it is taken in pieces.
  const double piece = 16.0 * grid.geometry().resolution;
  const int pieces = static_cast<int>(std::min(slab.half_length / piece, 1e6)) + 1;
  const double half = slab.half_length / pieces;
  for (int i = 0; i < pieces; ++i) {
    const double along = (2 * i + 1) * half - slab.half_length;
    const Slab part{slab.centre + along * slab.heading.forward(), slab.heading, half,
                    slab.half_width};
    const double c = std::abs(part.heading.cos);
    const double s = std::abs(part.heading.sin);
    fill(grid, part.centre, {c * half + s * part.half_width, s * half + c * part.half_width},
         [&](const Square& square) { return overlap(part, square); });
  }
}

void fill(OccupancyGrid& grid, const world::Wall& wall) {
  const Vec2 along = wall.b - wall.a;
  const double length = norm(along);
  fill(grid, Slab{0.5 * (wall.a + wall.b),
                  {along.x / length, along.y / length},
                  0.5 * length,
                  0.5 * wall.thickness});
}

void fill(OccupancyGrid& grid, const world::ObjectSpec& object) {
  if (object.kind == world::ObjectKind::Ball) return;
  const Vec2 centre = object.pose.position();
  std::vector<Vec2> corners = world::corners_of(object);
  if (!corners.empty()) {
    const Heading heading = Heading::from_angle(object.pose.theta);
    for (Vec2& corner : corners) corner = centre + heading.rotate(corner);
    const double reach = object.outer_radius();
    fill(grid, centre, {reach, reach},
         [&](const Square& square) { return overlap(corners, square); });
    return;
  }
  fill(grid, centre, {object.radius, object.radius},
       [&](const Square& square) { return overlap(centre, object.radius, square); });
}

}  // namespace

OccupancyGrid truth_of(const world::WorldModel& model, const TruthSettings& settings) {
  const auto refuse = [](const char* what) {
    throw std::invalid_argument(std::string("ground truth: ") + what);
  };
  if (!(settings.resolution > 0.0) || !std::isfinite(settings.resolution)) {
    refuse("the resolution is not a positive number of metres");
  }
  if (settings.margin < 0 || settings.margin > 1'000'000) refuse("the margin is not 0 to 1000000");
  if (!(model.width > 0.0 && model.height > 0.0)) refuse("the world has no floor");
  const double columns = model.width / settings.resolution + 2.0 * settings.margin;
  const double rows = model.height / settings.resolution + 2.0 * settings.margin;
  if (!((columns + 1) * (rows + 1) <= static_cast<double>(settings.max_cells))) {
    refuse("the world has more cells than max_cells");
  }
  GridGeometry g = GridGeometry::covering({0, 0}, model.width, model.height, settings.resolution);
  g.columns += 2 * settings.margin;
  g.rows += 2 * settings.margin;
  const double around = settings.margin * settings.resolution;
  g.origin = model.corner - Vec2{around, around};
  OccupancySettings certain;
  certain.max_cells = settings.max_cells;
  OccupancyGrid grid(g, certain);
  std::fill_n(grid.edit(), g.size(), grid.lowest());
  for (const world::Wall& wall : model.walls) fill(grid, wall);
  if (settings.objects) {
    for (const world::ObjectSpec& object : model.objects) fill(grid, object);
  }
  return grid;
}

}  // namespace eyebridge::mapping
