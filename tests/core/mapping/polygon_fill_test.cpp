#include "polygon_fill.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::mapping {
namespace {

struct Polygon {
  Vec2 origin;
  std::vector<float> x;
  std::vector<float> y;
  bool open = false;

  [[nodiscard]] std::vector<Vec2> corners() const {
    std::vector<Vec2> all;
    if (open) all.push_back(origin);
    for (std::size_t i = 0; i < x.size(); ++i) all.push_back(origin + Vec2{x[i], y[i]});
    return all;
  }
};

/// By the crossing number of a ray to the left: the textbook's way.
bool is_within(const std::vector<Vec2>& corners, Vec2 p) {
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 a = corners[i];
    const Vec2 b = corners[(i + 1) % corners.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) < p.x) inside = !inside;
  }
  return inside;
}

/// Whether `p` is so close to an edge that rounding decides.
bool is_on_edge(const std::vector<Vec2>& corners, Vec2 p) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 a = corners[i];
    const Vec2 edge = corners[(i + 1) % corners.size()] - a;
    if (std::abs(cross(edge, p - a)) < 1e-4 * (1.0 + std::sqrt(dot(edge, edge)))) return true;
  }
  return false;
}

int count_wrong(PolygonFill& fill, const Box& box, const Polygon& polygon) {
  fill.begin(box);
  fill.flip(polygon.origin, polygon.x, polygon.y, polygon.open);
  const std::vector<Vec2> corners = polygon.corners();
  int wrong = 0;
  for (int row = 0; row < box.rows; ++row) {
    std::uint64_t carry = 0;
    for (int word = 0; word * PolygonFill::kBits < box.stride; ++word) {
      const std::uint64_t bits = fill.any(row) ? fill.take(row, word, carry) : 0;
      for (int bit = 0; bit < PolygonFill::kBits; ++bit) {
        const int column = word * PolygonFill::kBits + bit;
        if (column >= box.columns) break;
        const Vec2 middle{column + 0.5, row + 0.5};
        if (is_on_edge(corners, middle)) continue;
        if (((bits >> bit & 1) != 0) != is_within(corners, middle)) ++wrong;
      }
    }
  }
  return wrong;
}

TEST(PolygonFill, HoldsTheCellsWhoseMiddlesLieWithin) {
  Random random(3);
  PolygonFill fill;
  for (int round = 0; round < 200; ++round) {
    const Box box{1 + static_cast<int>(200 * random.uniform()),
                  1 + static_cast<int>(100 * random.uniform()), 256};
    Polygon polygon;
    // Some reach beyond the box, or lie outside.
    polygon.origin = {300 * random.uniform() - 50, 150 * random.uniform() - 25};
    polygon.open = random.chance(0.5);
    const int corners = 1 + static_cast<int>(60 * random.uniform());
    const double turn = polygon.open ? 1.7 * kPi : 2 * kPi;
    for (int i = 0; i < corners; ++i) {
      const double reach = random.chance(0.2) ? 0.0 : 120 * random.uniform();
      const Vec2 at = reach * Heading::from_angle(turn * i / corners).forward();
      polygon.x.push_back(static_cast<float>(at.x));
      polygon.y.push_back(static_cast<float>(at.y));
    }
    EXPECT_EQ(count_wrong(fill, box, polygon), 0) << round;
  }
}

TEST(PolygonFill, IsEmptyAfterItWasTaken) {
  PolygonFill fill;
  const Box box{70, 10, 128};
  const Polygon square{{5, 2}, {0, 60, 60, 0}, {0, 0, 5, 5}};
  EXPECT_EQ(count_wrong(fill, box, square), 0);
  EXPECT_EQ(count_wrong(fill, box, square), 0) << "what was flipped is forgotten";
  fill.begin(box);
  fill.flip({0, 0}, {}, {}, true);
  for (int row = 0; row < box.rows; ++row) EXPECT_FALSE(fill.any(row));
}

}  // namespace
}  // namespace eyebridge::mapping
