#include "motor.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace eyebridge::robot {
namespace {

MotorModel lagging(double time_constant) {
  MotorModel model;
  model.time_constant = time_constant;
  model.decay = decay_of(model.dt / time_constant);
  model.lag = time_constant * (1.0 - model.decay);
  model.ticks_per_metre = 6000;
  return model;
}

TEST(Motor, DecayIsTheExponentialFunction) {
  for (const double x : {0.0, 1e-9, 0.01, 0.24, 0.26, 1.0, 3.7, 20.0, 300.0}) {
    EXPECT_NEAR(decay_of(x) / std::exp(-x), 1.0, 1e-12) << x;
  }
  EXPECT_EQ(decay_of(1e6), 0.0);
}

TEST(Motor, WithoutLagFollowsAtOnce) {
  const MotorModel model;
  Wheel wheel;
  EXPECT_EQ(wheel.drive_controlled(0.5, model), 0.5 * model.dt);
  EXPECT_EQ(wheel.speed(), 0.5);
  EXPECT_EQ(wheel.drive_controlled(-0.2, model), -0.2 * model.dt);
}

TEST(Motor, ReachesSixtyThreePercentAfterItsTimeConstant) {
  const MotorModel model = lagging(0.2);
  Wheel wheel;
  double travel = 0.0;
  for (int i = 0; i < 20; ++i) travel += wheel.drive(1.0, model);
  EXPECT_NEAR(wheel.speed(), 1.0 - std::exp(-1.0), 1e-12);
  // Integral of 1 - e^(-t/T) from 0 to T: T e^-1.
  EXPECT_NEAR(travel, 0.2 * std::exp(-1.0), 1e-12);
}

TEST(Motor, DutyBeyondFullIsFull) {
  const MotorModel model;
  Wheel wheel;
  EXPECT_EQ(wheel.drive(99.0, model), model.top * model.dt);
}

TEST(Motor, PidConvergesWithoutSteadyStateErrorOrMuchOvershoot) {
  for (const double time_constant : {0.001, 0.01, 0.05, 0.2, 1.0}) {
    const MotorModel model = lagging(time_constant);
    Wheel wheel;
    double top = 0.0;
    for (int i = 0; i < 3000; ++i) {
      wheel.drive_controlled(0.5, model);
      top = std::max(top, wheel.speed());
    }
    EXPECT_NEAR(wheel.speed(), 0.5, 1e-7) << time_constant;
    EXPECT_LT(top, 0.65) << time_constant;
  }
}

TEST(Motor, PidIsFasterThanTheMotorAlone) {
  const MotorModel model = lagging(0.2);
  Wheel controlled;
  Wheel alone;
  for (int i = 0; i < 15; ++i) {
    controlled.drive_controlled(0.5, model);
    alone.drive(0.5, model);
  }
  EXPECT_GT(controlled.speed(), alone.speed() + 0.01);
}

TEST(Motor, RollsAsFarAsPredictedWhenToldToStand) {
  const MotorModel model = lagging(0.1);
  Wheel wheel;
  for (int i = 0; i < 100; ++i) wheel.drive_controlled(0.5, model);
  const double predicted = wheel.rolling(model);
  double travel = 0.0;
  for (int i = 0; i < 500; ++i) travel += wheel.drive_controlled(0.0, model);
  EXPECT_NEAR(travel, predicted, 0.1 * predicted);
  EXPECT_NEAR(wheel.speed(), 0.0, 1e-12);
}

TEST(Motor, EveryGainHasAnEffect) {
  const auto speed_after = [](const PidGains& gains) {
    const MotorModel model = lagging(0.2);
    Wheel wheel;
    wheel.set_gains(gains);
    for (int i = 0; i < 10; ++i) wheel.drive_controlled(0.5, model);
    return wheel.speed();
  };
  const double none = speed_after({0, 0, 0});
  EXPECT_GT(speed_after({50, 0, 0}), none);
  EXPECT_GT(speed_after({0, 50, 0}), none);
  EXPECT_NE(speed_after({0, 0, 50}), none);
}

TEST(Motor, AnObstacleDoesNotWindTheControllerUp) {
  const MotorModel model = lagging(0.1);
  Wheel held;
  for (int i = 0; i < 500; ++i) {
    held.drive_controlled(0.5, model);
    held.turn(0.0, true, model);
  }
  Wheel fresh;
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(held.drive_controlled(0.5, model), fresh.drive_controlled(0.5, model));
  }
}

TEST(Encoder, CountsTravelToTheNearestTick) {
  const MotorModel model = lagging(0.1);
  Wheel wheel;
  wheel.turn(0.25, false, model);
  EXPECT_EQ(wheel.ticks(model), 1500);
  wheel.turn(-0.5, false, model);
  EXPECT_EQ(wheel.ticks(model), -1500);
}

TEST(Encoder, ResetStartsFromZeroAndKeepsTheFraction) {
  const MotorModel model = lagging(0.1);
  Wheel wheel;
  wheel.turn(10.4 / 6000, false, model);
  wheel.reset_ticks(model);
  EXPECT_EQ(wheel.ticks(model), 0);
  wheel.turn(0.3 / 6000, false, model);
  EXPECT_EQ(wheel.ticks(model), 1);
  EXPECT_EQ(wheel.raw_ticks(model), 11);
}

}  // namespace
}  // namespace eyebridge::robot
