#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "eyebridge/files/hdt.hpp"

namespace eyebridge::files {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Nothing moves below 40 %; above it is linear.
HdtTable motor_table() {
  HdtTable table{"motor", {0}, {}};
  for (int i = 1; i <= 100; ++i) table.values.push_back(40 + 6 * i / 10);
  return table;
}

TEST(MotorDuty, TheTableIsLookedUpByMagnitudeAndKeepsTheSign) {
  const HdtTable table = motor_table();
  EXPECT_DOUBLE_EQ(motor_duty(&table, 0.5), 0.70);
  EXPECT_DOUBLE_EQ(motor_duty(&table, -0.5), -0.70);
  EXPECT_DOUBLE_EQ(motor_duty(&table, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(motor_duty(&table, -7.0), -1.0);
  EXPECT_DOUBLE_EQ(motor_duty(&table, 0.0), 0.0);
}

TEST(MotorDuty, BetweenTwoPercentagesItIsLinear) {
  const HdtTable table = motor_table();
  EXPECT_NEAR(motor_duty(&table, 0.005), 0.20, 1e-12) << "between 0 and 40";
  EXPECT_NEAR(motor_duty(&table, -0.995), -0.995, 1e-12);
}

TEST(MotorDuty, WithoutATableItIsTheSpeed) {
  EXPECT_EQ(motor_duty(nullptr, 0.37), 0.37);
  EXPECT_EQ(motor_duty(nullptr, -2.0), -1.0);
  EXPECT_EQ(motor_duty(nullptr, kNan), 0.0);
}

TEST(ServoPosition, IsTheTablesEntry) {
  HdtTable table{"servo", {}, {}};
  for (int i = 0; i < 256; ++i) table.values.push_back(255 - i);
  EXPECT_EQ(servo_position(&table, 0.0), 255);
  EXPECT_EQ(servo_position(&table, 1.0), 0);
  EXPECT_EQ(servo_position(&table, 0.2), 204);
}

TEST(ServoPosition, WithoutATableItIsTheNearestOf256) {
  EXPECT_EQ(servo_position(nullptr, 0.0), 0);
  EXPECT_EQ(servo_position(nullptr, 0.5), 128);
  EXPECT_EQ(servo_position(nullptr, 1.0), 255);
  EXPECT_EQ(servo_position(nullptr, -3.0), 0);
  EXPECT_EQ(servo_position(nullptr, kNan), 128);
}

TEST(PsdRange, AShortTableSpansTwelveBits) {
  const HdtTable table{"psd", {1000, 500, 100}, {}};
  EXPECT_DOUBLE_EQ(psd_range(table, 0), 1.0);
  EXPECT_DOUBLE_EQ(psd_range(table, 4095), 0.1);
  EXPECT_NEAR(psd_range(table, 1024), 0.75, 2e-4);
  EXPECT_NEAR(psd_range(table, 3071), 0.3, 2e-4);
}

TEST(PsdRange, ALongTableHasAnEntryForEachReading) {
  HdtTable table{"psd", {}, {}};
  for (int i = 0; i < 4096; ++i) table.values.push_back(5000 - i);
  EXPECT_DOUBLE_EQ(psd_range(table, 17), 4.983);
  EXPECT_DOUBLE_EQ(psd_range(table, 4095), 0.905);
  EXPECT_DOUBLE_EQ(psd_range(table, 4096), kHdtOutOfRange);
}

TEST(PsdRange, WhatIsOutOfRangeIsNeverMixedIntoAReading) {
  const HdtTable table{"psd", {9999, 800, 80, 20000}, {}};
  EXPECT_DOUBLE_EQ(psd_range(table, 600), kHdtOutOfRange) << "nearer to 9999";
  EXPECT_DOUBLE_EQ(psd_range(table, 800), 0.8) << "nearer to 800";
  EXPECT_DOUBLE_EQ(psd_range(table, 4095), kHdtOutOfRange);
}

TEST(PsdRange, ReadingsThatCannotBeAreOutOfRange) {
  const HdtTable table{"psd", {100, 200}, {}};
  EXPECT_DOUBLE_EQ(psd_range(table, -1), kHdtOutOfRange);
  EXPECT_DOUBLE_EQ(psd_range(table, 4096), kHdtOutOfRange);
  EXPECT_DOUBLE_EQ(psd_range(table, 65535), kHdtOutOfRange);
}

TEST(ServoLimits, AreInTensOfMicrosecondsAndAtMost255) {
  HdtServo servo;
  servo.shortest_pulse = 704e-6;
  servo.longest_pulse = 2300e-6;
  EXPECT_EQ(servo_limits(servo), (ServoLimits{70, 230}));
  servo.longest_pulse = 3000e-6;
  EXPECT_EQ(servo_limits(servo).upper, 255);
}

}  // namespace
}  // namespace eyebridge::files
