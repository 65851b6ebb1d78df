#pragma once

#include <cstddef>

#include "eyebridge/base/drive_goal.hpp"
#include "eyebridge/base/pose.hpp"
#include "eyebridge/base/result.hpp"

namespace eyebridge::hal {

// What the device interfaces call OutOfRange: asked by every backend, so that all say the same.

/// Success when `good`; else OutOfRange: what `device` was asked for, and what it takes.
Result<void> require(bool good, const char* device, double value, const char* expected);

// Of a drive: all numbers are finite, the speed of a goal is not negative.
Result<void> check_speed(const Twist& twist);
Result<void> check_goal(const DriveGoal& goal);
Result<void> check_pose(const Pose& pose);

// Of a motor: -1 … 1; finite; 0 … 255 each.
Result<void> check_duty(double duty);
Result<void> check_motor_speed(double ticks_per_second);
Result<void> check_gains(int p, int i, int d);

/// Of a servo: 0 … 1.
Result<void> check_servo_position(double position);

/// Of a lidar's scan: as many ranges as the scan has points.
Result<void> check_scan_size(std::size_t ranges, int points);

/// A digital line of 1 … 16.
Result<void> check_line(int line);
/// An analog channel of 0 … 8.
Result<void> check_channel(int channel);

}  // namespace eyebridge::hal
