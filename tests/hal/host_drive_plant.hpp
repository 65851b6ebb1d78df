#pragma once

#include <cmath>

#include <gtest/gtest.h>

#include "../core/robot/rig.hpp"
#include "board/host_drive.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {

/// Side of the room, which has its lower left at the origin; metres.
inline constexpr double kPlantRoom = 8.0;

inline robot::RobotModel plant_model(double motor_time_constant = 0.0) {
  robot::RobotModel model;
  model.drive.motor_time_constant = motor_time_constant;
  return model;
}

/// What the host must know of a robot of `model`.
inline HostDriveSettings plant_settings(const robot::RobotModel& model) {
  HostDriveSettings out;
  out.wheel_base = model.drive.wheel_base;
  out.left_ticks_per_metre = model.drive.ticks_per_revolution / (kPi * model.drive.wheel_diameter);
  out.right_ticks_per_metre = out.left_ticks_per_metre;
  out.max_linear = model.drive.max_linear;
  out.max_angular = model.drive.max_angular;
  out.motor_lag = model.drive.motor_time_constant;
  return out;
}

/// A simulated robot whose board knows letters `M` and `e` only, under a HostDrive.
class Plant {
 public:
  explicit Plant(const robot::RobotModel& model = plant_model())
      : Plant(model, plant_settings(model)) {}
  Plant(const robot::RobotModel& model, const HostDriveSettings& settings)
      : sim(robot::room(kPlantRoom, kPlantRoom), {}),
        robot(sim.add_robot(model, {kPlantRoom / 2, kPlantRoom / 2, 0.0})),
        drive(settings),
        left_sign_(settings.left_reversed ? -1 : 1),
        right_sign_(settings.right_reversed ? -1 : 1) {}

  /// The board's counters, near their wrap-around at the start.
  [[nodiscard]] WheelCounts counts() const {
    const auto count = [&](unsigned motor, int sign) {
      return static_cast<std::int32_t>(
          static_cast<std::uint32_t>(0x7FFFFFF8 + sign * sim.encoder_ticks(robot, motor)));
    };
    return {count(0, left_sign_), count(1, right_sign_)};
  }

  /// One period of the host; `periods` of the plant pass until the next one.
  void step(int periods = 1) {
    const auto speeds = drive.step(counts(), now);
    ASSERT_TRUE(speeds) << speeds.error().what;
    ASSERT_LE(std::abs(speeds->left), 127);
    ASSERT_LE(std::abs(speeds->right), 127);
    if (drive.engaged()) {
      sim.set_motor_speed(robot, 0, 100.0 * left_sign_ * speeds->left);
      sim.set_motor_speed(robot, 1, 100.0 * right_sign_ * speeds->right);
    }
    for (int i = 0; i < periods; ++i) sim.step();
    now += periods * HostDrive::kPeriod;
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) step();
  }
  /// Until the goal is over and the wheels stand; the periods it took until it was over.
  int finish(int limit = 6000) {
    int count = 0;
    for (; drive.status().progress == DriveProgress::Driving && count < limit; ++count) step();
    EXPECT_LT(count, limit) << "the goal never ended";
    steps(50);
    return count;
  }

  robot::Simulation sim;
  robot::RobotIndex robot;
  HostDrive drive;
  Time now{0};

 private:
  int left_sign_;
  int right_sign_;
};

}  // namespace eyebridge::hal
