// The central test, second part: how a robot moves. Its rows are in backend_contract_test.cpp.
#include <cmath>

#include <gmock/gmock.h>

#include "backend_contract.hpp"
#include "eyebridge/base/math.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {
namespace {

constexpr double kSpeed = 0.3;  // metres per second
// For movements that must still be under way when the test looks, however late it does.
constexpr double kSlowly = 0.05;

/// Keeps the trace points and a copy of their ranges.
class KeepingTrace final : public TraceSink {
 public:
  void point(const TracePoint& point) noexcept override {
    const std::lock_guard lock(mutex_);
    points_.push_back(point);
    ranges_.emplace_back(point.ranges.begin(), point.ranges.end());
  }
  std::vector<TracePoint> points() const {
    const std::lock_guard lock(mutex_);
    return points_;
  }
  std::vector<std::vector<double>> ranges() const {
    const std::lock_guard lock(mutex_);
    return ranges_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<TracePoint> points_;
  std::vector<std::vector<double>> ranges_;
};

TEST_P(BackendContract, StandsStillUntilItIsTold) {
  const Rig rig = make(0.5);
  rig.wait(1.0);
  EXPECT_NEAR(front(rig), 0.5, range_tolerance());
  EXPECT_EQ(rig.backend->drive()->status().value().progress, DriveProgress::Done);
}

TEST_P(BackendContract, DrivesStraightAsFarAsItIsTold) {
  for (const double distance : {0.4, -0.3}) {
    const Rig rig = make(1.0);
    ASSERT_TRUE(rig.backend->drive()->start({distance, 0.0, kSpeed}));
    const DriveStatus status = rig.wait_for_drive();
    EXPECT_EQ(status.progress, DriveProgress::Done);
    EXPECT_NEAR(status.remaining, 0.0, drive_tolerance());
    EXPECT_NEAR(front(rig), 1.0 - distance, drive_tolerance());
    EXPECT_NEAR(odometry(rig).x, distance, drive_tolerance());
    EXPECT_NEAR(odometry(rig).y, 0.0, drive_tolerance());
  }
}

TEST_P(BackendContract, TurnsOnTheSpotAsFarAsItIsTold) {
  for (const double angle : {kPi / 2, -kPi / 4}) {
    const Rig rig = make(1.0);
    ASSERT_TRUE(rig.backend->drive()->start({0.0, angle, 1.0}));
    EXPECT_EQ(rig.wait_for_drive().progress, DriveProgress::Done);
    EXPECT_NEAR(rig.backend->compass()->read().value(), angle, drive_tolerance());
    EXPECT_NEAR(odometry(rig).theta, angle, drive_tolerance());
    EXPECT_NEAR(odometry(rig).x, 0.0, drive_tolerance());
  }
}

TEST_P(BackendContract, DrivesAQuarterCircle) {
  const Rig rig = make(1.5);
  constexpr double kRadius = 0.4;
  ASSERT_TRUE(rig.backend->drive()->start({kRadius * kPi / 2, kPi / 2, kSpeed}));
  EXPECT_EQ(rig.wait_for_drive().progress, DriveProgress::Done);
  EXPECT_NEAR(odometry(rig).x, kRadius, drive_tolerance());
  EXPECT_NEAR(odometry(rig).y, kRadius, drive_tolerance());
  EXPECT_NEAR(odometry(rig).theta, kPi / 2, drive_tolerance());
}

TEST_P(BackendContract, SaysHowFarItHasToGo) {
  const Rig rig = make(1.5);
  ASSERT_TRUE(rig.backend->drive()->start({1.0, 0.0, kSlowly}));
  rig.wait(3.0);
  const double before = odometry(rig).x;
  const DriveStatus status = rig.backend->drive()->status().value();
  const double after = odometry(rig).x;
  EXPECT_EQ(status.progress, DriveProgress::Driving);
  EXPECT_GT(before, 0.1);
  EXPECT_LE(status.remaining, 1.0 - before + drive_tolerance());
  EXPECT_GE(status.remaining, 1.0 - after - drive_tolerance());
}

TEST_P(BackendContract, ANewCommandReplacesTheRunningOne) {
  const Rig rig = make(1.5);
  ASSERT_TRUE(rig.backend->drive()->start({1.2, 0.0, kSlowly}));
  rig.wait(0.5);
  ASSERT_TRUE(rig.backend->drive()->start({0.0, kPi / 2, 1.0}));
  EXPECT_EQ(rig.wait_for_drive().progress, DriveProgress::Done);
  EXPECT_LT(odometry(rig).x, 1.0);
  EXPECT_NEAR(odometry(rig).theta, kPi / 2, 0.05);  // it was not at rest when the turn began
}

TEST_P(BackendContract, StallsAtTheWallAndGivesUp) {
  const Rig rig = make(0.2);
  ASSERT_TRUE(rig.backend->drive()->start({1.0, 0.0, kSpeed}));
  const DriveStatus status = rig.wait_for_drive();
  EXPECT_EQ(status.progress, DriveProgress::Failed);
  const double gap = rig_model().radius() - kFrontOffset;  // the rim touches, not the sensor
  EXPECT_NEAR(front(rig), gap, 2e-3);
}

TEST_P(BackendContract, ShowsTheStallWhileItPushes) {
  const Rig rig = make(0.2);
  ASSERT_TRUE(rig.backend->drive()->set_speed({kSpeed, 0.0}));
  rig.wait(1.5);
  const DriveStatus status = rig.backend->drive()->status().value();
  EXPECT_TRUE(status.stalled_left);
  EXPECT_TRUE(status.stalled_right);
  ASSERT_TRUE(rig.backend->drive()->set_speed({-kSlowly, 0.0}));
  rig.wait(0.5);
  EXPECT_FALSE(rig.backend->drive()->status().value().stalled_left);
}

TEST_P(BackendContract, KeepsASpeedUntilTheNextCommand) {
  const Rig rig = make(1.5);
  ASSERT_TRUE(rig.backend->drive()->set_speed({0.2, 0.5}));
  rig.wait(1.0);
  const Twist twist = rig.backend->drive()->measured_twist().value();
  EXPECT_NEAR(twist.linear, 0.2, 0.01);
  EXPECT_NEAR(twist.angular, 0.5, 0.02);
  ASSERT_TRUE(rig.backend->drive()->set_speed({0.0, 0.0}));
  rig.wait(1.0);
  const Pose pose = odometry(rig);
  rig.wait(0.5);
  EXPECT_NEAR(odometry(rig).x, pose.x, 1e-9);
  EXPECT_NEAR(odometry(rig).theta, pose.theta, 1e-9);
}

TEST_P(BackendContract, OdometryGoesOnFromWhereItIsSet) {
  const Rig rig = make(1.5);
  ASSERT_TRUE(rig.backend->drive()->set_odometry({1.0, 2.0, kPi / 2}));
  EXPECT_NEAR(odometry(rig).x, 1.0, 1e-9);
  EXPECT_NEAR(odometry(rig).y, 2.0, 1e-9);
  EXPECT_NEAR(odometry(rig).theta, kPi / 2, 1e-9);
  ASSERT_TRUE(rig.backend->drive()->start({0.3, 0.0, kSpeed}));
  rig.wait_for_drive();
  EXPECT_NEAR(odometry(rig).x, 1.0, drive_tolerance());
  EXPECT_NEAR(odometry(rig).y, 2.3, drive_tolerance());
}

TEST_P(BackendContract, EncodersCountTheDistance) {
  const Rig rig = make(1.0);
  ASSERT_TRUE(rig.backend->encoder(1)->reset());
  ASSERT_TRUE(rig.backend->encoder(2)->reset());
  ASSERT_TRUE(rig.backend->drive()->start({0.5, 0.0, kSpeed}));
  rig.wait_for_drive();
  const robot::DriveModel drive = rig_model().drive;
  const double ticks = 0.5 / (kPi * drive.wheel_diameter) * drive.ticks_per_revolution;
  const double tolerance = drive_tolerance() * ticks / 0.5 + 1;
  EXPECT_NEAR(rig.backend->encoder(1)->read().value(), ticks, tolerance);
  EXPECT_NEAR(rig.backend->encoder(2)->read().value(), ticks, tolerance);
  ASSERT_TRUE(rig.backend->encoder(1)->reset());
  EXPECT_EQ(rig.backend->encoder(1)->read().value(), 0);
  EXPECT_NE(rig.backend->encoder(2)->read().value(), 0);
}

TEST_P(BackendContract, MotorsMoveTheirOwnWheel) {
  const Rig rig = make(1.0);
  ASSERT_TRUE(rig.backend->motor(2)->set_duty(0.1));
  rig.wait(0.5);
  ASSERT_TRUE(rig.backend->motor(2)->set_duty(0.0));
  rig.wait(0.5);
  EXPECT_EQ(rig.backend->encoder(1)->read().value(), 0);
  const int right = rig.backend->encoder(2)->read().value();
  EXPECT_GT(right, 0);
  // The right wheel alone turns the robot to the left, around the other wheel.
  const robot::DriveModel drive = rig_model().drive;
  const double travel = right / drive.ticks_per_revolution * kPi * drive.wheel_diameter;
  EXPECT_NEAR(wrap_angle(odometry(rig).theta - travel / drive.wheel_base), 0.0, 5e-3);
}

TEST_P(BackendContract, MotorsKeepTheSpeedTheyAreTold) {
  const Rig rig = make(1.5);
  constexpr double kTicksPerSecond = 400;
  ASSERT_TRUE(rig.backend->motor(1)->set_pid(4, 1, 1));
  ASSERT_TRUE(rig.backend->motor(1)->set_speed(kTicksPerSecond));
  ASSERT_TRUE(rig.backend->motor(2)->set_speed(kTicksPerSecond));
  rig.wait(1.0);
  const robot::DriveModel drive = rig_model().drive;
  const double expected = kTicksPerSecond / drive.ticks_per_revolution * kPi * drive.wheel_diameter;
  EXPECT_NEAR(rig.backend->drive()->measured_twist().value().linear, expected, 0.02 * expected);
}

TEST_P(BackendContract, StopStopsAtOnceWhateverMovedTheRobot) {
  for (const bool by_motor : {false, true}) {
    const Rig rig = make(1.5);
    if (by_motor) {
      ASSERT_TRUE(rig.backend->motor(1)->set_duty(0.1));
      ASSERT_TRUE(rig.backend->motor(2)->set_duty(0.1));
    } else {
      ASSERT_TRUE(rig.backend->drive()->start({1.0, 0.0, kSpeed}));
    }
    rig.wait(0.5);
    EXPECT_LT(front(rig), 1.49);
    rig.backend->stop();
    const double stopped = front(rig);
    rig.wait(1.0);
    EXPECT_NEAR(front(rig), stopped, range_tolerance());
  }
}

TEST_P(BackendContract, TraceTellsOfEveryStepInOrder) {
  const Rig rig = make(1.5);
  KeepingTrace trace;
  rig.backend->trace_to(&trace);
  ASSERT_TRUE(rig.backend->drive()->start({0.3, 0.0, kSpeed}));
  rig.wait_for_drive();
  rig.backend->trace_to(nullptr);

  const auto points = trace.points();
  ASSERT_GT(points.size(), 50u);
  for (std::size_t i = 1; i < points.size(); ++i) {
    ASSERT_EQ(points[i].time - points[i - 1].time, from_seconds(0.01)) << i;
    ASSERT_GE(points[i].pose.x, points[i - 1].pose.x) << i;
  }
  EXPECT_NEAR(points.back().odometry.x, 0.3, drive_tolerance());
  const std::vector<double> ranges = trace.ranges().back();
  ASSERT_EQ(ranges.size(), 4u);
  EXPECT_NEAR(ranges[0], front(rig), drive_tolerance());  // in order of id
  EXPECT_NEAR(ranges[1], kSideWall, range_tolerance());

  rig.wait(0.5);
  EXPECT_EQ(trace.points().size(), points.size());
}

}  // namespace
}  // namespace eyebridge::hal
