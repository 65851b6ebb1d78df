#include <vector>

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"
#include "rig.hpp"

namespace eyebridge::robot {
namespace {

constexpr RobotIndex kRobots = 12;

/// Robots of one kind of drive, with all errors, in a crowded room; `thinks_anew` keeps them from
/// what they may skip.
struct Crowd {
  Crowd(DriveKind kind, bool thinks_anew_each_step) : thinks_anew(thinks_anew_each_step) {
    for (RobotIndex i = 0; i < kRobots; ++i) {
      RobotModel model;
      model.drive.kind = kind;
      if (i % 2 == 0) model.drive.linear_acceleration = model.drive.angular_acceleration = 0.0;
      if (i % 5 == 1) model.drive.motor_time_constant = 0.05;
      if (i % 6 == 2) model.drive_error.left_scale = 0.01;
      if (i % 6 == 3) model.drive_error.encoder_quantised = true;
      if (i % 6 == 5) model.drive_error.angular_sigma = 0.1;
      const RobotIndex row = i / 4;
      sim.add_robot(model, {0.4 + 0.5 * (i % 4), 0.4 + 0.5 * row, 0.5 * i});
    }
    sim.on_collision([this](const CollisionEvent&) { ++collisions; });
  }

  void command(RobotIndex robot, double kind, double a, double b) {
    if (kind < 0.5) sim.set_speed(robot, {0.4 * a, b});
    if (kind >= 0.5 && kind < 0.6) sim.set_speed(robot, {0.3, 0.0});
    if (kind >= 0.6 && kind < 0.7) sim.drive(robot, {a, b, 0.4});
    if (kind >= 0.7 && kind < 0.75) sim.stop(robot);
    if (kind >= 0.75 && kind < 0.8) sim.set_motor_duty(robot, 0, a);
    if (kind >= 0.8 && kind < 0.85) sim.set_motor_speed(robot, last_motor(robot), 3000 * b);
    if (kind >= 0.85 && kind < 0.9) sim.set_odometry(robot, {a, b, a});
    if (kind >= 0.9 && kind < 0.95) sim.reset_encoder(robot, 1);
    if (kind >= 0.95) sim.set_pose(robot, {1.2 + a / 4, 2.2 + b / 4, 3 * b});
  }

  [[nodiscard]] unsigned last_motor(RobotIndex robot) const {
    return sim.model(robot).drive.motor_count() - 1;
  }

  void step() {
    for (RobotIndex robot = 0; thinks_anew && robot < kRobots; ++robot) sim.reset_encoder(robot, 0);
    sim.step();
  }

  bool thinks_anew;
  int collisions = 0;
  Simulation sim{room(2.4, 2.4), {}};
};

class Cruise : public testing::TestWithParam<DriveKind> {};

INSTANTIATE_TEST_SUITE_P(Drives, Cruise,
                         testing::Values(DriveKind::Differential, DriveKind::Ackermann,
                                         DriveKind::Omni, DriveKind::Swedish, DriveKind::Synchro),
                         [](const auto& drive) { return facts_of(drive.param).name; });

TEST_P(Cruise, WhatIsNotComputedAgainIsTheSame) {
  Crowd fast(GetParam(), false);
  Crowd slow(GetParam(), true);
  Random random(5);
  std::vector<Twist> last(kRobots);
  int stalls = 0;
  for (int step = 0; step < 20000; ++step) {
    for (RobotIndex robot = 0; robot < kRobots; ++robot) {
      if (!random.chance(0.01)) {
        // Programs say the same again and again.
        if (robot % 3 == 0 && step % 10 == 0) {
          for (Crowd* crowd : {&fast, &slow}) crowd->sim.set_speed(robot, last[robot]);
        }
        continue;
      }
      const double kind = random.uniform();
      const double a = 2 * random.uniform() - 1;
      const double b = 2 * random.uniform() - 1;
      last[robot] = {0.5 * a, b};
      for (Crowd* crowd : {&fast, &slow}) crowd->command(robot, kind, a, b);
      ASSERT_EQ(fast.sim.stalled(robot), slow.sim.stalled(robot)) << step;
    }
    fast.step();
    slow.step();
    if (step % 7 != 0) continue;  // who looks must not be what keeps them alike
    ASSERT_EQ(fast.sim.state_hash(), slow.sim.state_hash()) << step;
    const auto robot = static_cast<RobotIndex>(step) % kRobots;
    ASSERT_EQ(fast.sim.odometry(robot), slow.sim.odometry(robot)) << step;
    ASSERT_EQ(fast.sim.twist(robot), slow.sim.twist(robot)) << step;
    ASSERT_EQ(fast.sim.measured_twist(robot), slow.sim.measured_twist(robot)) << step;
    ASSERT_EQ(fast.sim.encoder_ticks(robot, 1), slow.sim.encoder_ticks(robot, 1)) << step;
    ASSERT_EQ(fast.sim.stalled(robot), slow.sim.stalled(robot)) << step;
    stalls += fast.sim.stalled(robot) != kStallNone ? 1 : 0;
  }
  EXPECT_EQ(fast.collisions, slow.collisions);
  EXPECT_GT(fast.collisions, 100);
  EXPECT_GT(stalls, 200);
}

}  // namespace
}  // namespace eyebridge::robot
