#include "known_rays.hpp"

#include <cmath>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"
#include "eyebridge/base/units.hpp"
#include "instruction_sets.hpp"
#include "rig.hpp"

namespace eyebridge::robot {
namespace {

std::uint64_t bits(std::initializer_list<unsigned> sensors) {
  std::uint64_t all = 0;
  for (const unsigned sensor : sensors) all |= std::uint64_t{1} << sensor;
  return all;
}

/// A program's question: what it leads to is measured.
std::uint64_t ask(KnownRays& rays, std::uint64_t moment, unsigned sensor) {
  const std::uint64_t missing = rays.ask({moment, {}}, sensor);
  for (unsigned i = 0; i < KnownRays::kMost; ++i) {
    if (((missing >> i) & 1U) != 0) rays.keep(i, 1.0 * i);
  }
  return missing;
}

TEST(KnownRays, TheFirstQuestionIsAnsweredWithThoseOfLately) {
  KnownRays rays;
  for (const unsigned sensor : {0U, 5U, 63U}) {
    EXPECT_EQ(ask(rays, 1, sensor), bits({sensor})) << "nobody asked for it before";
    EXPECT_EQ(ask(rays, 1, sensor), 0U);
  }
  EXPECT_EQ(ask(rays, 2, 5), bits({0, 5, 63}));
  EXPECT_EQ(ask(rays, 2, 63), 0U);
  EXPECT_EQ(rays.range(63), 63.0);
  EXPECT_EQ(ask(rays, 2, 7), bits({7}));
}

TEST(KnownRays, ASensorThatIsAloneForAWhileIsMeasuredAlone) {
  KnownRays rays;
  for (const unsigned sensor : {0U, 1U, 2U}) ask(rays, 1, sensor);
  std::uint64_t moment = 2;
  for (; ask(rays, moment, 1) != bits({1}); ++moment) ASSERT_LT(moment, 10U);
  EXPECT_GT(moment, 3U) << "a decision may take several steps";
}

TEST(KnownRays, TurningMakesThemUnknown) {
  KnownRays rays;
  ask(rays, 1, 0);
  EXPECT_EQ(rays.ask({1, Heading::from_angle(0.1)}, 0), bits({0}));
}

/// Looks outwards from its rim every 40 degrees, and twice along one bearing from two places.
RobotModel with_sensors() {
  RobotModel model;
  model.diameter = 0.2;
  for (int i = 0; i < 9; ++i) {
    RangeSensorModel psd;
    psd.id = i + 1;
    const double bearing = deg_to_rad(40.0 * i);
    psd.pose_in_robot = {0.08 * std::cos(bearing), 0.08 * std::sin(bearing), bearing};
    psd.max_range = psd.out_of_range = i % 4 == 3 ? 0.7 : 3.0;
    model.range_sensors.push_back(psd);
  }
  model.range_sensors.push_back(model.range_sensors.front());
  model.range_sensors.back().pose_in_robot.y = 0.03;
  model.range_sensors[4].kind = RangeKind::Infrared;
  return model;
}

/// What a ray of the test's own meets.
double looked(Simulation& sim, RobotIndex robot, std::size_t sensor) {
  const RangeSensorModel& model = sim.model(robot).range_sensors[sensor];
  const world::BodyId self = sim.body(robot);
  const Heading heading = sim.world().heading(self);
  const Vec2 origin = sim.world().position(self) + heading.rotate(model.pose_in_robot.position());
  const Heading towards = heading.turned(Heading::from_angle(model.pose_in_robot.theta));
  const double range = sim.world().cast_ray(origin, towards.forward(), model.max_range, self);
  return range < model.max_range ? range : model.out_of_range;
}

world::ObjectSpec thing(world::ObjectKind kind, Vec2 place) {
  world::ObjectSpec object;
  object.kind = kind;
  object.pose = {place.x, place.y, 0.0};
  object.radius = 0.1;
  return object;
}

// Random moves, additions and removals between random readings.
void expect_ranges_of_the_world_as_it_is() {
  Simulation sim(room(4.0, 4.0), {});
  const RobotModel model = with_sensors();
  const RobotIndex a = sim.add_robot(model, {1.0, 1.0, 0.3});
  const RobotIndex b = sim.add_robot(model, {3.0, 2.0, 2.0});
  const world::BodyId ball = sim.world().add_object(thing(world::ObjectKind::Ball, {2.0, 3.0}));
  Random random(7);
  const auto draw = [&](int below) { return static_cast<int>(random.uniform() * below); };
  std::size_t others = 0;
  for (int i = 0; i < 4000; ++i) {
    switch (draw(12)) {
      case 0:
        sim.set_speed(a, {0.3 * random.uniform(), 2.0 * random.uniform() - 1.0});
        break;
      case 1:
        sim.set_speed(a, {0.0, 1.0});  // it turns on the spot, nothing else changes
        break;
      case 2:
        sim.stop(a);
        break;
      case 3:
        sim.world().set_velocity(ball, {random.uniform() - 0.5, random.uniform() - 0.5});
        break;
      case 4:
        sim.set_pose(b, {0.5 + 3.0 * random.uniform(), 3.5, 6.0 * random.uniform()});
        break;
      case 5:
        if (others < 20 && sim.world().is_free({3.7, 0.3}, 0.2)) {
          const world::BodyId other =
              sim.world().add_object(thing(world::ObjectKind::Can, {3.7, 0.3}));
          if (++others % 2 == 0) sim.world().remove(other);
        }
        break;
      case 6:
        sim.step();
        break;
      default: {
        const RobotIndex who = draw(2) == 0 ? a : b;
        const auto sensor = static_cast<std::size_t>(draw(10));
        ASSERT_EQ(sim.read_range(who, sensor), looked(sim, who, sensor)) << i;
      }
    }
  }
}

TEST(KnownRays, AreThoseOfTheWorldAsItIs) {
  in_every_instruction_set([](const std::string& name) {
    SCOPED_TRACE(name);
    expect_ranges_of_the_world_as_it_is();
  });
}

}  // namespace
}  // namespace eyebridge::robot
