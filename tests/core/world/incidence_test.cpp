// How squarely rays meet walls, discs and boxes, against what geometry says.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/world/world.hpp"
#include "scenes.hpp"

namespace eyebridge::world {
namespace {

/// Of a ray from `origin` at `angle`, where it ends.
double cosine_of_ray(const World& world, Vec2 origin, double angle, BodyId ignore = kNoBody) {
  const Vec2 direction = Heading::from_angle(angle).forward();
  const double range = world.cast_ray(origin, direction, 100.0, ignore);
  return world.incidence_cosine(origin + range * direction, direction, ignore);
}

TEST(Incidence, OfAWallIsTheCosineOfTheAngleToItsNormal) {
  WorldModel model = room(4, 4);
  const World world(shared(model));
  for (double angle = -0.7; angle <= 0.7; angle += 0.1) {
    EXPECT_NEAR(cosine_of_ray(world, {2, 2}, angle), std::cos(angle), 1e-12) << angle;
  }
  Wall thick;
  thick.a = {3, 1};
  thick.b = {3, 3};
  thick.thickness = 0.2;
  model.walls.push_back(thick);
  const World other(shared(model));
  EXPECT_NEAR(cosine_of_ray(other, {2, 2}, 0.4), std::cos(0.4), 1e-12);
}

TEST(Incidence, OfADiscFollowsFromHowFarTheRayPassesItsCentre) {
  World world(shared(room(4, 4)));
  const BodyId disc = world.add_robot({3, 2, 0}, 0.5, 0.1, {});
  for (const double aside : {0.0, 0.1, -0.2, 0.4, -0.49}) {
    const double sine = aside / 0.5;
    EXPECT_NEAR(cosine_of_ray(world, {1, 2 + aside}, 0), std::sqrt(1 - sine * sine), 1e-9) << aside;
  }
  EXPECT_NEAR(cosine_of_ray(world, {1, 2.4}, 0.3, disc), std::cos(0.3), 1e-12)
      << "the wall behind the disc that is left out";
}

TEST(Incidence, OfABoxIsThatOfTheSideThatIsMet) {
  WorldModel model = room(4, 4);
  ObjectSpec box;
  box.kind = ObjectKind::Box;
  box.pose = {3, 2, deg_to_rad(30)};
  box.size = {0.6, 0.4};
  model.objects = {box};
  const World world(shared(model));
  // At its centre: the end whose normal points back along 210 degrees.
  EXPECT_NEAR(cosine_of_ray(world, {1, 2}, 0), std::cos(deg_to_rad(30)), 1e-9);
  // From below: the long side.
  EXPECT_NEAR(cosine_of_ray(world, {3, 0.5}, kPi / 2), std::cos(deg_to_rad(30)), 1e-9);
}

TEST(Incidence, InACornerTheSquarerWallCounts) {
  const World world(shared(room(4, 4)));
  EXPECT_NEAR(world.incidence_cosine({4, 4}, Heading::from_angle(0.3).forward(), kNoBody),
              std::cos(0.3), 1e-12);
}

TEST(Incidence, OfNothingIsNone) {
  const World world(shared(room(4, 4)));
  EXPECT_EQ(world.incidence_cosine({2, 2}, {1, 0}, kNoBody), 0.0);
  EXPECT_EQ(world.incidence_cosine({3.99, 2}, {1, 0}, kNoBody), 0.0);
}

/// The slope of range over bearing tells the angle of incidence a: r' / r = tan a.
void expect_slopes(const WorldModel& model, std::uint64_t seed) {
  const World world(shared(model));
  Random random(seed);
  int compared = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec2 origin{model.width * random.uniform(), model.height * random.uniform()};
    const double angle = 2 * kPi * random.uniform();
    const auto range = [&](double at) {
      return world.cast_ray(origin, Heading::from_angle(at).forward(), 100, kNoBody);
    };
    constexpr double kTurn = 1e-5;
    const double before = range(angle - kTurn);
    const double here = range(angle);
    const double after = range(angle + kTurn);
    // Not at corners and edges, nor near the wall, where differences are all rounding.
    if (here < 0.05 || std::abs(after - 2 * here + before) > 1e-6) continue;
    const double tangent = (after - before) / (2 * kTurn) / here;
    const double cosine = cosine_of_ray(world, origin, angle);
    if (std::abs(tangent) > 5) continue;
    ++compared;
    ASSERT_NEAR(cosine, 1 / std::sqrt(1 + tangent * tangent), 1e-4)
        << origin.x << " " << origin.y << " " << angle;
  }
  EXPECT_GT(compared, 1000);
}

TEST(Incidence, AgreesWithTheSlopeOfTheRanges) {
  expect_slopes(random_walls(3, 60, 4, 0.05), 4);
  expect_slopes(random_maze(5, 8, 0.4), 6);
}

}  // namespace
}  // namespace eyebridge::world
