// The central test: single motors, encoders, stopping, and the trace of a run. Its rows are in
// backend_contract_test.cpp.
#include <cmath>
#include <mutex>

#include <gmock/gmock.h>

#include "backend_contract.hpp"
#include "eyebridge/base/math.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {
namespace {

constexpr double kMotorSpeed = 0.3;  // metres per second

/// Ticks of a wheel for so many metres.
double ticks_of(double metres) {
  const robot::DriveModel drive = rig_model().drive;
  return metres / (kPi * drive.wheel_diameter) * drive.ticks_per_revolution;
}

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

TEST_P(BackendContract, EncodersCountTheDistance) {
  const Rig rig = make(1.0);
  ASSERT_TRUE(rig.backend->encoder(1)->reset());
  ASSERT_TRUE(rig.backend->encoder(2)->reset());
  ASSERT_TRUE(rig.backend->drive()->start({0.5, 0.0, kMotorSpeed}));
  rig.wait_for_drive();
  rig.wait(traits().age);
  const double tolerance = ticks_of(traits().way) + 1;
  EXPECT_NEAR(must(rig.backend->encoder(1)->read()), ticks_of(0.5), tolerance);
  EXPECT_NEAR(must(rig.backend->encoder(2)->read()), ticks_of(0.5), tolerance);
  ASSERT_TRUE(rig.backend->encoder(1)->reset());
  EXPECT_EQ(must(rig.backend->encoder(1)->read()), 0);
  EXPECT_NE(must(rig.backend->encoder(2)->read()), 0);
}

TEST_P(BackendContract, EncodersCountDownBackwards) {
  const Rig rig = make(1.0);
  EXPECT_EQ(must(rig.backend->encoder(1)->read()), 0);
  ASSERT_TRUE(rig.backend->drive()->start({-0.2, 0.0, kMotorSpeed}));
  rig.wait_for_drive();
  rig.wait(traits().age);
  EXPECT_NEAR(must(rig.backend->encoder(1)->read()), ticks_of(-0.2), ticks_of(traits().way) + 1);
}

TEST_P(BackendContract, MotorsMoveTheirOwnWheel) {
  const Rig rig = make(1.0);
  ASSERT_TRUE(rig.backend->motor(2)->set_duty(0.1));
  rig.wait(0.5);
  ASSERT_TRUE(rig.backend->motor(2)->set_duty(0.0));
  rig.wait(0.5);
  EXPECT_EQ(must(rig.backend->encoder(1)->read()), 0);
  const int right = must(rig.backend->encoder(2)->read());
  EXPECT_GT(right, 0);
  // The right wheel alone turns the robot to the left, around the other wheel.
  const robot::DriveModel drive = rig_model().drive;
  const double travel = right / drive.ticks_per_revolution * kPi * drive.wheel_diameter;
  EXPECT_NEAR(wrap_angle(odometry(rig).theta - travel / drive.wheel_base), 0.0,
              5e-3 + traits().turn);
}

TEST_P(BackendContract, ADutyIsAShareOfTheTopSpeed) {
  const Rig rig = make(1.5);
  ASSERT_TRUE(rig.backend->motor(1)->set_duty(0.2));
  ASSERT_TRUE(rig.backend->motor(2)->set_duty(0.2));
  rig.wait(1.0);
  const robot::DriveModel drive = rig_model().drive;
  EXPECT_NEAR(must(rig.backend->drive()->measured_twist()).linear,
              0.2 * drive.max_wheel_speed * drive.wheel_diameter / 2, traits().linear);
  EXPECT_EQ(must(rig.backend->drive()->status()).progress, DriveProgress::Done);
}

TEST_P(BackendContract, MotorsKeepTheSpeedTheyAreTold) {
  const Rig rig = make(1.5);
  constexpr double kTicksPerSecond = 1600;
  const auto gains = rig.backend->motor(1)->set_pid(4, 1, 1);
  ASSERT_EQ(gains.has_value(), traits().gains);
  if (!gains) {
    EXPECT_EQ(gains.error().code, Errc::Unsupported);
  }
  ASSERT_TRUE(rig.backend->motor(1)->set_speed(kTicksPerSecond));
  ASSERT_TRUE(rig.backend->motor(2)->set_speed(kTicksPerSecond));
  rig.wait(1.0);
  EXPECT_NEAR(must(rig.backend->drive()->measured_twist()).linear, kTicksPerSecond / ticks_of(1.0),
              traits().linear);
}

TEST_P(BackendContract, AMotorThatIsUsedEndsTheMovement) {
  const Rig rig = make(1.5);
  ASSERT_TRUE(rig.backend->drive()->start({1.2, 0.0, kMotorSpeed}));
  rig.wait(0.5);
  ASSERT_TRUE(rig.backend->motor(1)->set_duty(0.0));
  ASSERT_TRUE(rig.backend->motor(2)->set_duty(0.0));
  rig.wait(0.2);
  const double stopped = front(rig);
  rig.wait(0.5);
  EXPECT_NEAR(front(rig), stopped, traits().range);
  EXPECT_NE(must(rig.backend->drive()->status()).progress, DriveProgress::Driving);
  // And the drive takes it back.
  ASSERT_TRUE(rig.backend->drive()->start({-0.1, 0.0, kMotorSpeed}));
  EXPECT_EQ(rig.wait_for_drive().progress, DriveProgress::Done);
  rig.wait(traits().age);
  EXPECT_NEAR(front(rig), stopped + 0.1, traits().way + 2 * traits().range);
}

TEST_P(BackendContract, StopStopsAtOnceWhateverMovedTheRobot) {
  for (const bool by_motor : {false, true}) {
    const Rig rig = make(1.5);
    if (by_motor) {
      ASSERT_TRUE(rig.backend->motor(1)->set_duty(0.1));
      ASSERT_TRUE(rig.backend->motor(2)->set_duty(0.1));
    } else {
      ASSERT_TRUE(rig.backend->drive()->start({1.0, 0.0, kMotorSpeed}));
    }
    rig.wait(0.5);
    EXPECT_LT(front(rig), 1.49);
    rig.backend->stop();
    if (GetParam().replayed) continue;  // the end of a recording
    rig.wait(traits().age);
    const double stopped = front(rig);
    rig.wait(1.0);
    EXPECT_NEAR(front(rig), stopped, traits().range);
  }
}

TEST_P(BackendContract, LosingTheRobotIsAnErrorNotAReading) {
  const Rig rig = make(1.5);
  ASSERT_TRUE(rig.backend->drive()->start({1.0, 0.0, kMotorSpeed}));
  rig.wait(0.5);
  if (rig.unplug) rig.unplug();
  rig.wait(0.5);
  // A robot that has no line cannot be lost, and its readings go on.
  const bool there = !rig.unplug;
  EXPECT_EQ(rig.backend->range_sensor(1)->read().has_value(), there);
  EXPECT_EQ(rig.backend->encoder(1)->read().has_value(), there);
  EXPECT_EQ(rig.backend->drive()->odometry().has_value(), there);
  EXPECT_EQ(rig.backend->drive()->status().has_value(), there);
  EXPECT_EQ(rig.backend->motor(1)->set_duty(0.1).has_value(), there);
  EXPECT_EQ(rig.backend->drive()->set_speed({0.1, 0.0}).has_value(), there);
  if (there) return;
  EXPECT_EQ(rig.backend->range_sensor(1)->read().error().code, Errc::Disconnected);
  // And the robot that has lost its host stands.
  const Pose stood = rig.truth().pose;
  rig.wait(0.3);
  EXPECT_EQ(rig.truth().pose, stood);
}

TEST_P(BackendContract, TraceTellsOfTheRunInOrder) {
  const Rig rig = make(1.5);
  KeepingTrace trace;
  rig.backend->trace_to(&trace);
  ASSERT_TRUE(rig.backend->drive()->start({0.3, 0.0, kMotorSpeed}));
  rig.wait_for_drive();
  rig.wait(2 * to_seconds(traits().trace_period));  // the last point may be a period old
  rig.backend->trace_to(nullptr);

  const auto points = trace.points();
  if (traits().trace_period == Time{0}) {
    EXPECT_TRUE(points.empty());
    return;
  }
  ASSERT_GT(static_cast<Time::rep>(points.size()), from_seconds(0.5) / traits().trace_period);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Time apart = points[i].time - points[i - 1].time;
    // In a simulation every step is told; a board is asked when there is time.
    ASSERT_GE(apart, traits().trace_period) << i;
    ASSERT_LE(apart, traits().world ? traits().trace_period : Time::max()) << i;
    // Who passed its goal comes back.
    ASSERT_GE(points[i].pose.x, points[i - 1].pose.x - (traits().world ? 0 : traits().way)) << i;
  }
  EXPECT_NEAR(points.back().odometry.x, 0.3, traits().way);
  const std::vector<double> ranges = trace.ranges().back();
  ASSERT_EQ(ranges.size(), 4u);
  EXPECT_NEAR(ranges[0], front(rig), traits().way + traits().range);  // in order of id
  EXPECT_NEAR(ranges[1], kSideWall, traits().range);

  rig.wait(0.5);
  EXPECT_EQ(trace.points().size(), points.size());
}

}  // namespace
}  // namespace eyebridge::hal
