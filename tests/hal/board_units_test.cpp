// Every number on its way to a board and back.
#include "board/board_units.hpp"

#include <gtest/gtest.h>

#include "board/tick_counter.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {
namespace {

TEST(BoardUnits, DutiesGoThroughTheTableWithTheirSign) {
  BoardMotorTable table;
  EXPECT_EQ(to_percent(table, 0.335), 34);
  EXPECT_EQ(to_percent(table, -1.0), -100);
  for (int i = 0; i <= 100; ++i) table.duty.push_back(0.2 + 0.008 * i);
  EXPECT_EQ(to_percent(table, 0.0), 20);
  EXPECT_EQ(to_percent(table, 0.5), 60);
  EXPECT_EQ(to_percent(table, -0.5), -60);
  EXPECT_EQ(to_percent(table, 1.0), 100);
}

TEST(BoardUnits, TicksAreThoseOfTenMilliseconds) {
  EXPECT_EQ(to_ticks_per_10ms(400), 4);
  EXPECT_EQ(to_ticks_per_10ms(-1e12), -128);
  EXPECT_EQ(to_ticks_per_10ms(1e12), 127);
}

TEST(BoardUnits, ServosHave256Positions) {
  BoardServoTable table;
  EXPECT_EQ(to_servo_position(table, 0.0), 0);
  EXPECT_EQ(to_servo_position(table, 1.0), 255);
  for (int i = 0; i < 256; ++i) table.position.push_back(255 - i);
  EXPECT_EQ(to_servo_position(table, 1.0), 0);
}

TEST(BoardUnits, RangesLieBetweenTheEntriesOfTheirTable) {
  const BoardPsdTable table{1, {0.4, 0.2, 0.1}};
  EXPECT_DOUBLE_EQ(to_metres(table, 0), 0.4);
  EXPECT_DOUBLE_EQ(to_metres(table, 4095), 0.1);
  EXPECT_NEAR(to_metres(table, 1024), 0.3, 1e-3);
  EXPECT_DOUBLE_EQ(to_metres({1, {0.3}}, 4095), 0.3);
}

TEST(BoardUnits, BesideNothingSeenThereIsNoMean) {
  const BoardPsdTable table{1, {kBoardOutOfRange, 0.8, 0.2}};
  EXPECT_EQ(to_metres(table, 1000), kBoardOutOfRange);
  EXPECT_EQ(to_metres(table, 1100), 0.8);
}

TEST(BoardUnits, ALongTableHasAnEntryForEachReading) {
  BoardPsdTable table;
  for (int i = 0; i < 4096; ++i) table.metres.push_back(mm_to_m(i));
  EXPECT_DOUBLE_EQ(to_metres(table, 1234), 1.234);
}

TEST(BoardUnits, TheDefaultCurveFallsAndEnds) {
  const BoardPsdTable psd = default_board_tables().psds.at(0);
  EXPECT_EQ(to_metres(psd, 0), kBoardOutOfRange);
  EXPECT_GT(to_metres(psd, 1000), to_metres(psd, 2000));
  EXPECT_NEAR(to_metres(psd, 3640), 0.104, 0.005);  // 2.4 V
}

TEST(BoardUnits, SixteenBitsAreClampedNotWrapped) {
  EXPECT_EQ(to_mm(1.2345), 1235);
  EXPECT_EQ(to_mm(1e9), 32767);
  EXPECT_EQ(to_mm(-1e9), -32767);
  EXPECT_EQ(to_centi_degrees(-kPi / 2), -9000);
  EXPECT_EQ(to_tenth_degrees(kPi / 2), 900);
  EXPECT_EQ(to_degrees(1.0), 57);
  EXPECT_DOUBLE_EQ(from_centi_degrees(9000), kPi / 2);
}

TEST(TickCounter, GoesOnOverWrapsAndRestarts) {
  TickCounter counter;
  EXPECT_EQ(counter.feed16(65530, 1), 0);
  EXPECT_EQ(counter.feed16(4, 1), 10);
  EXPECT_EQ(counter.feed16(65535, 1), 5);
  EXPECT_EQ(counter.feed16(100, 2), 5);
  EXPECT_EQ(counter.feed16(101, 2), 6);
  TickCounter wide;
  EXPECT_EQ(wide.feed32(2147483647, 1), 0);
  EXPECT_EQ(wide.feed32(-2147483647, 1), 2);
}

}  // namespace
}  // namespace eyebridge::hal
