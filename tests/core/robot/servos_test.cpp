#include <stdexcept>

#include <gtest/gtest.h>

#include "rig.hpp"

namespace eyebridge::robot {
namespace {

constexpr unsigned kLeft = 11;
constexpr unsigned kRight = 12;

RobotModel on_servos() {
  RobotModel model;
  model.servos = {{kLeft, "SERVO_LEFT", ServoModel::Wheel::Left},
                  {kRight, "SERVO_RIGHT", ServoModel::Wheel::Right},
                  {6, "ARM", ServoModel::Wheel::None}};
  return model;
}

/// Where SERVOSet(servo, `angle`) puts a servo.
double at(int angle) { return 0.5 + (angle - 128) / 254.0; }

TEST(WheelServos, DoWhatMotorsDo) {
  for (const auto& [left, right] : {std::pair{255, 255}, {200, 60}, {1, 100}, {128, 255}}) {
    Rig by_servos(on_servos());
    by_servos.sim.set_servo(by_servos.robot, kLeft, at(left));
    by_servos.sim.set_servo(by_servos.robot, kRight, at(right));
    Rig by_motors;
    by_motors.sim.set_motor_duty(by_motors.robot, 0, (left - 128) / 127.0);
    by_motors.sim.set_motor_duty(by_motors.robot, 1, (right - 128) / 127.0);
    by_servos.steps(200);
    by_motors.steps(200);
    const Pose a = by_servos.sim.pose(by_servos.robot);
    const Pose b = by_motors.sim.pose(by_motors.robot);
    EXPECT_NEAR(a.x, b.x, 1e-9) << left << ' ' << right;
    EXPECT_NEAR(a.y, b.y, 1e-9) << left << ' ' << right;
    EXPECT_NEAR(a.theta, b.theta, 1e-9) << left << ' ' << right;
    EXPECT_NE(a, (Pose{2.0, 2.0, 0.0})) << left << ' ' << right;
  }
}

TEST(WheelServos, StandAboutTheMiddle) {
  for (const int angle : {127, 128, 129}) {
    Rig rig(on_servos());
    rig.sim.set_servo(rig.robot, kLeft, at(angle));
    rig.sim.set_servo(rig.robot, kRight, at(angle));
    rig.steps(100);
    EXPECT_EQ(rig.sim.pose(rig.robot), (Pose{2.0, 2.0, 0.0})) << angle;
  }
  Rig rig(on_servos());
  rig.sim.set_servo(rig.robot, kLeft, at(130));
  rig.sim.set_servo(rig.robot, kRight, at(130));
  rig.steps(100);
  EXPECT_GT(rig.sim.pose(rig.robot).x, 2.0);
}

TEST(WheelServos, AnArmMovesNothing) {
  Rig rig(on_servos());
  rig.sim.set_servo(rig.robot, 6, 1.0);
  rig.steps(100);
  EXPECT_EQ(rig.sim.pose(rig.robot), (Pose{2.0, 2.0, 0.0}));
  EXPECT_EQ(rig.sim.servo(rig.robot, 6), 1.0);
}

TEST(WheelServos, ModelsThatCannotBeAreRefused) {
  Rig rig;
  RobotModel model = on_servos();
  model.drive.kind = DriveKind::Omni;
  EXPECT_THROW(rig.sim.add_robot(model, {1.0, 1.0, 0.0}), std::invalid_argument);
  model = on_servos();
  model.servos[2].servo = 1;
  EXPECT_THROW(rig.sim.add_robot(model, {1.0, 1.0, 0.0}), std::invalid_argument);
  model.servos[2].servo = kServoCount;
  EXPECT_THROW(rig.sim.add_robot(model, {1.0, 1.0, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace eyebridge::robot
