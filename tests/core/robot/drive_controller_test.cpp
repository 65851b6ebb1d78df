#include "eyebridge/robot/drive_controller.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::robot {
namespace {

constexpr double kSlack = 1e-9;  // of rounding, relative

/// A robot without lag and errors around the controller; checks every step against the limits.
class PerfectRobot {
 public:
  explicit PerfectRobot(const DriveLimits& limits = {}) : limits_(limits), controller_(limits) {}

  DriveController& controller() { return controller_; }
  double distance() const { return distance_; }
  double angle() const { return angle_; }
  double top_linear() const { return top_linear_; }
  double top_angular() const { return top_angular_; }

  void step() {
    const Twist before = controller_.twist();
    const Twist now = controller_.next({});
    EXPECT_LE(std::abs(now.linear - before.linear), limits_.linear_step * (1 + kSlack));
    EXPECT_LE(std::abs(now.angular - before.angular), limits_.angular_step * (1 + kSlack));
    EXPECT_LE(std::abs(now.linear), limits_.linear * (1 + kSlack));
    EXPECT_LE(std::abs(now.angular), limits_.angular * (1 + kSlack));
    EXPECT_LE(std::abs(now.linear) + std::abs(now.angular) * limits_.half_base,
              limits_.wheel * (1 + kSlack));
    distance_ += now.linear * limits_.dt;
    angle_ += now.angular * limits_.dt;
    top_linear_ = std::max(top_linear_, std::abs(now.linear));
    top_angular_ = std::max(top_angular_, std::abs(now.angular));
    controller_.advance({now.linear * limits_.dt, now.angular * limits_.dt});
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) step();
  }
  /// Drives until the goal is reached; the number of steps it took.
  int finish() {
    int count = 0;
    for (; controller_.state() == DriveState::Driving && count < 100000; ++count) step();
    EXPECT_EQ(controller_.state(), DriveState::Idle);
    return count;
  }

 private:
  DriveLimits limits_;
  DriveController controller_;
  double distance_ = 0.0;
  double angle_ = 0.0;
  double top_linear_ = 0.0;
  double top_angular_ = 0.0;
};

struct GoalCase {
  const char* name;
  DriveGoal goal;
};
void PrintTo(const GoalCase& tested, std::ostream* out) { *out << tested.name; }

class ExactGoal : public testing::TestWithParam<GoalCase> {};

TEST_P(ExactGoal, EndsExactlyAndStandsStillAfterIt) {
  const DriveGoal goal = GetParam().goal;
  PerfectRobot robot;
  robot.controller().start(goal, {});
  robot.finish();
  EXPECT_NEAR(robot.distance(), goal.distance, 1e-9);
  EXPECT_NEAR(robot.angle(), goal.angle, 1e-9);
  robot.steps(50);
  EXPECT_TRUE(robot.controller().at_rest());
  EXPECT_NEAR(robot.distance(), goal.distance, 1e-9);
  EXPECT_NEAR(robot.angle(), goal.angle, 1e-9);
}

TEST_P(ExactGoal, NeverOvershootsOnTheWay) {
  const DriveGoal goal = GetParam().goal;
  PerfectRobot robot;
  robot.controller().start(goal, {});
  while (robot.controller().state() == DriveState::Driving) {
    robot.step();
    ASSERT_LE(std::abs(robot.distance()), std::abs(goal.distance) + 1e-9);
    ASSERT_LE(std::abs(robot.angle()), std::abs(goal.angle) + 1e-9);
    if (goal.distance != 0.0) {
      ASSERT_NEAR(robot.angle() * goal.distance, robot.distance() * goal.angle, 1e-9)
          << "the turn is tied to the way";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(DriveController, ExactGoal,
                         testing::Values(GoalCase{"OneMetre", {1.0, 0.0, 0.3}},
                                         GoalCase{"Backwards", {-0.37, 0.0, 0.6}},
                                         GoalCase{"FasterThanTheRobotCan", {2.0, 0.0, 9.0}},
                                         GoalCase{"LessThanAStep", {1e-5, 0.0, 0.3}},
                                         GoalCase{"TooShortForTopSpeed", {0.0123, 0.0, 0.5}},
                                         GoalCase{"VerySlow", {0.01, 0.0, 0.002}},
                                         GoalCase{"QuarterTurn", {0.0, kPi / 2, 1.0}},
                                         GoalCase{"QuarterTurnRight", {0.0, -kPi / 2, 4.0}},
                                         GoalCase{"TwoTurnsAndABit", {0.0, 4 * kPi + 0.3, 3.0}},
                                         GoalCase{"GentleCurve", {1.0, 0.5, 0.4}},
                                         GoalCase{"TightCurve", {0.05, 3.0, 0.5}},
                                         GoalCase{"BackwardsCurve", {-0.5, 1.2, 0.3}},
                                         GoalCase{"CircleAndMore", {1.5, -7.5, 0.6}}),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(DriveController, StraightRunsAtTheSpeedItWasGiven) {
  PerfectRobot robot;
  robot.controller().start({1.0, 0.0, 0.3}, {});
  const int steps = robot.finish();
  EXPECT_NEAR(robot.top_linear(), 0.3, 1e-12);
  // Closed form of a trapezoid: t = d / v + v / a, up to a step at either end.
  EXPECT_NEAR(steps * 0.01, 1.0 / 0.3 + 0.3 / 1.0, 0.021);
}

TEST(DriveController, TurnRunsAtTheSpeedItWasGiven) {
  PerfectRobot robot;
  robot.controller().start({0.0, 6.0, 2.0}, {});
  const int steps = robot.finish();
  EXPECT_NEAR(robot.top_angular(), 2.0, 1e-12);
  EXPECT_NEAR(steps * 0.01, 6.0 / 2.0 + 2.0 / 10.0, 0.021);
}

TEST(DriveController, ShortWayIsATriangle) {
  PerfectRobot robot;
  robot.controller().start({0.09, 0.0, 0.6}, {});
  robot.finish();
  EXPECT_NEAR(robot.top_linear(), std::sqrt(0.09 * 1.0), 0.011);
}

TEST(DriveController, WheelLimitSlowsBothPartsOfACurve) {
  DriveLimits limits;
  limits.wheel = 0.3;
  limits.half_base = 0.1;
  PerfectRobot robot(limits);
  robot.controller().start({2.0, 4.0, 0.6}, {});  // outer wheel: v (1 + 2 * 0.1)
  robot.finish();
  EXPECT_NEAR(robot.top_linear(), 0.25, 1e-12);
  EXPECT_NEAR(robot.top_angular(), 0.5, 1e-12);
}

TEST(DriveController, SpeedIsRampedAndReachedExactly) {
  PerfectRobot robot;
  robot.controller().set_speed({0.25, -1.0}, {});
  robot.steps(24);
  EXPECT_NEAR(robot.controller().twist().linear, 0.24, 1e-12);
  EXPECT_EQ(robot.controller().twist().angular, -1.0);
  robot.steps(2);
  EXPECT_EQ(robot.controller().twist(), (Twist{0.25, -1.0}));
  EXPECT_EQ(robot.controller().state(), DriveState::Idle);
}

TEST(DriveController, SpeedBeyondTheLimitsIsClamped) {
  PerfectRobot robot;
  robot.controller().set_speed({5.0, 0.0}, {});
  robot.steps(200);
  EXPECT_EQ(robot.controller().twist(), (Twist{0.6, 0.0}));
}

TEST(DriveController, SpeedBeyondTheWheelsKeepsItsCurvature) {
  DriveLimits limits;
  limits.wheel = 0.2;
  PerfectRobot robot(limits);
  robot.controller().set_speed({0.4, 4.0}, {});
  robot.steps(200);
  const Twist twist = robot.controller().twist();
  EXPECT_NEAR(twist.angular / twist.linear, 10.0, 1e-12);
  EXPECT_NEAR(twist.linear + twist.angular * limits.half_base, 0.2, 1e-12);
}

TEST(DriveController, ChangingFromFullWayToFullTurnNeverAsksTooMuchOfAWheel) {
  DriveLimits limits;
  limits.linear = 0.5;
  limits.wheel = 0.5;
  limits.half_base = 0.2;
  limits.angular = 2.5;
  PerfectRobot robot(limits);
  robot.controller().set_speed({0.5, 0.0}, {});
  robot.steps(100);
  robot.controller().set_speed({0.0, 2.5}, robot.controller().twist());
  robot.steps(100);
  EXPECT_EQ(robot.controller().twist(), (Twist{0.0, 2.5}));
}

TEST(DriveController, NewGoalStartsFromTheSpeedTheRobotHas) {
  PerfectRobot robot;
  robot.controller().set_speed({0.5, 0.0}, {});
  robot.steps(100);
  const double before = robot.distance();
  robot.controller().start({1.0, 0.0, 0.2}, robot.controller().twist());
  robot.step();
  EXPECT_NEAR(robot.controller().twist().linear, 0.49, 1e-12);
  robot.finish();
  EXPECT_NEAR(robot.distance() - before, 1.0, 1e-9);
}

TEST(DriveController, GoalTooNearForItsSpeedIsPassedAndReturnedTo) {
  PerfectRobot robot;
  robot.controller().set_speed({0.5, 0.0}, {});
  robot.steps(100);
  const double before = robot.distance();
  robot.controller().start({0.02, 0.0, 0.5}, robot.controller().twist());
  robot.finish();
  EXPECT_NEAR(robot.distance() - before, 0.02, 1e-9);
}

TEST(DriveController, GoalBehindAMovingRobotIsReached) {
  PerfectRobot robot;
  robot.controller().set_speed({0.5, 0.0}, {});
  robot.steps(100);
  const double before = robot.distance();
  robot.controller().start({-0.3, 0.0, 0.4}, robot.controller().twist());
  robot.finish();
  EXPECT_NEAR(robot.distance() - before, -0.3, 1e-9);
}

TEST(DriveController, CurveEndsExactlyThoughTheRobotCameFromAnotherCurve) {
  for (const Twist start : {Twist{0.5, 0.0}, Twist{0.3, 3.0}, Twist{0.0, -4.0}, Twist{-0.4, 1.0}}) {
    PerfectRobot robot;
    robot.controller().set_speed(start, {});
    robot.steps(200);
    const double distance = robot.distance();
    const double angle = robot.angle();
    robot.controller().start({0.6, 1.5, 0.4}, robot.controller().twist());
    robot.finish();
    EXPECT_NEAR(robot.distance() - distance, 0.6, 1e-9);
    EXPECT_NEAR(robot.angle() - angle, 1.5, 1e-9);
  }
}

TEST(DriveController, AnySequenceOfCommandsKeepsTheLimitsAndEndsExactly) {
  Random random(11);
  const auto between = [&](double low, double high) {
    return low + (high - low) * random.uniform();
  };
  for (int run = 0; run < 300; ++run) {
    PerfectRobot robot;
    for (int command = 0; command < 4; ++command) {
      const Twist present = robot.controller().twist();
      if (random.chance(0.5)) {
        robot.controller().set_speed({between(-1, 1), between(-8, 8)}, present);
      } else {
        robot.controller().start({between(-0.3, 0.3), between(-4, 4), between(0.01, 1)}, present);
      }
      robot.steps(static_cast<int>(between(1, 80)));
    }
    const double distance = robot.distance();
    const double angle = robot.angle();
    const DriveGoal goal{between(-0.5, 0.5), between(-4, 4), between(0.05, 1)};
    robot.controller().start(goal, robot.controller().twist());
    robot.finish();
    ASSERT_NEAR(robot.distance() - distance, goal.distance, 1e-9) << run;
    ASSERT_NEAR(robot.angle() - angle, goal.angle, 1e-9) << run;
  }
}

TEST(DriveController, TurnIsNotDoneBeforeTheWayHasRunOut) {
  PerfectRobot robot;
  robot.controller().set_speed({0.5, 0.0}, {});
  robot.steps(100);
  robot.controller().start({0.0, 0.01, 1.0}, robot.controller().twist());
  robot.finish();
  robot.step();
  EXPECT_EQ(robot.controller().twist(), Twist{});
}

TEST(DriveController, EmptyGoalIsDoneAtOnceAndRunsOut) {
  for (const DriveGoal goal :
       {DriveGoal{0.0, 0.0, 0.3}, DriveGoal{1.0, 0.0, 0.0}, DriveGoal{0.0, 1.0, 0.0}}) {
    PerfectRobot robot;
    robot.controller().set_speed({0.5, 0.0}, {});
    robot.steps(10);
    robot.controller().start(goal, robot.controller().twist());
    EXPECT_EQ(robot.controller().state(), DriveState::Idle);
    robot.steps(100);  // none faster than the ramp
    EXPECT_TRUE(robot.controller().at_rest());
  }
}

TEST(DriveController, EmptyGoalsTakeNoSpeedFromTheGoalsAfterThem) {
  // As programs that steer with VWTurn(angle, 60); VWStraight(500, 200); all the time.
  PerfectRobot robot;
  for (int i = 0; i < 500; ++i) {
    robot.controller().start({0.0, 0.0, 1.0}, robot.controller().twist());
    robot.controller().start({0.5, 0.0, 0.2}, robot.controller().twist());
    robot.steps(5);
  }
  EXPECT_NEAR(robot.top_linear(), 0.2, 1e-9);
}

TEST(DriveController, RemainingFallsToZero) {
  PerfectRobot robot;
  robot.controller().start({-0.5, 0.0, 0.3}, {});
  EXPECT_EQ(robot.controller().remaining(), 0.5);
  double last = 0.5;
  while (robot.controller().state() == DriveState::Driving) {
    robot.step();
    EXPECT_LT(robot.controller().remaining(), last);
    last = robot.controller().remaining();
  }
  EXPECT_EQ(last, 0.0);
}

TEST(DriveController, RemainingOfATurnIsZero) {
  PerfectRobot robot;
  robot.controller().start({0.0, 2.0, 1.0}, {});
  robot.steps(5);
  EXPECT_EQ(robot.controller().remaining(), 0.0);
}

TEST(DriveController, NothingRemainsOfAGoalThatIsGivenUp) {
  DriveController controller(DriveLimits{});
  const auto remaining_after = [&](auto give_up) {
    controller.start({-0.5, 0.0, 0.3}, {});
    EXPECT_EQ(controller.remaining(), 0.5);
    give_up();
    return controller.remaining();
  };
  EXPECT_EQ(remaining_after([&] { controller.stop(); }), 0.0);
  EXPECT_EQ(remaining_after([&] { controller.fail(); }), 0.0);
  EXPECT_EQ(remaining_after([&] { controller.set_speed({0.1, 0.0}, {}); }), 0.0);
}

TEST(DriveController, AStopIsAtOnceAndFinal) {
  PerfectRobot robot;
  robot.controller().start({1.0, 1.0, 0.3}, {});
  robot.steps(50);
  const double distance = robot.distance();
  robot.controller().stop();
  EXPECT_EQ(robot.controller().state(), DriveState::Idle);
  EXPECT_TRUE(robot.controller().at_rest());
  robot.steps(50);
  EXPECT_EQ(robot.distance(), distance);
  robot.controller().fail();
  EXPECT_EQ(robot.controller().state(), DriveState::Failed);
}

TEST(DriveController, ObstacleRestartsTheRamp) {
  PerfectRobot robot;
  robot.controller().start({1.0, 0.0, 0.3}, {});
  robot.steps(40);
  robot.controller().hold({}, false);
  robot.step();
  EXPECT_NEAR(robot.controller().twist().linear, 0.01, 1e-12);
}

TEST(StoppingShare, FullDecelerationFromItEndsExactly) {
  for (const double remaining : {1e-6, 0.00009, 0.0001, 0.00037, 0.0042, 0.3, 7.0}) {
    const double dt = 0.01;
    const double speed_step = 0.01;
    double left = remaining;
    double speed = stopping_share(speed_step * dt / left) * left / dt;
    for (; speed > 1e-12; speed -= speed_step) left -= speed * dt;
    EXPECT_NEAR(left, 0.0, 1e-12) << remaining;
  }
}

}  // namespace
}  // namespace eyebridge::robot
