#include <cmath>

#include <gmock/gmock.h>

#include "board_fixture.hpp"

namespace eyebridge::firmware {
namespace {

class SpeedControl : public testing::TestWithParam<double> {};

/// Ticks per period of both wheels over one second, after `settle_ms`.
std::vector<double> mean_speeds(Plant plant, const char* command, std::uint32_t settle_ms) {
  BoardUnderTest host;
  host.ask(command);
  const auto run = [&](std::uint32_t ms) {
    host.wait_ms(ms, [&] {
      plant.step(host.board);
      host.board.silent_us = 0;
    });
  };
  run(settle_ms);
  const double left = plant.travel[0];
  const double right = plant.travel[1];
  run(1000);
  return {(plant.travel[0] - left) / 100, (plant.travel[1] - right) / 100};
}

TEST_P(SpeedControl, ReachesItsSpeedOnAPlantWithThatLag) {
  const auto speeds = mean_speeds({.lag = GetParam()}, "M 1 40\rM 2 -25\r", 6000);
  EXPECT_NEAR(speeds[0], 40, 0.5);
  EXPECT_NEAR(speeds[1], -25, 0.5);
}

TEST_P(SpeedControl, ReachesItThoughTheMotorIsWeakerThanItKnows) {
  const auto speeds = mean_speeds({.full_ticks = 90, .lag = GetParam()}, "M 1 40\rM 2 -25\r", 6000);
  EXPECT_NEAR(speeds[0], 40, 0.5);
  EXPECT_NEAR(speeds[1], -25, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Lags, SpeedControl, testing::Values(0.0, 0.02, 0.1, 0.3),
                         [](const auto& row) {
                           return std::to_string(std::lround(row.param * 1000)) + "ms";
                         });

TEST(Encoders, AreExtendedOverTheWrapInBothDirections) {
  BoardUnderTest host;
  host.board.pins.encoder[0] = 65530;
  host.wait_ms(10);
  EXPECT_EQ(host.board.motors.motor[0].ticks, -6);
  host.board.pins.encoder[0] = 10;
  host.wait_ms(10);
  EXPECT_EQ(host.board.motors.motor[0].ticks, 10);
  for (int i = 0; i < 10; ++i) {
    host.board.pins.encoder[0] = static_cast<std::uint16_t>(host.board.pins.encoder[0] + 30000);
    host.wait_ms(10);
  }
  EXPECT_EQ(host.board.motors.motor[0].ticks, 300010);
}

TEST(Motors, AWheelCommandLeavesTheOtherStandingAfterAMove) {
  BoardUnderTest host(config_with([](eb_config& config) { config.io7.letters = EB_LETTERS_ALL; }));
  host.ask("x 200 0\r");
  host.wait_ms(100);
  EXPECT_GT(host.board.pins.duty[1], 0);
  host.ask("m 1 50\r");
  EXPECT_EQ(host.board.pins.duty[0], 5000);
  EXPECT_EQ(host.board.pins.duty[1], 0);
}

TEST(Motors, DutyNeverLeavesItsRange) {
  BoardUnderTest host;
  host.ask("d 1 255 255 255\r");
  for (int i = 0; i < 500; ++i) {
    host.ask(i % 2 == 0 ? "M 1 127\r" : "M 1 -128\r");
    host.board.pins.encoder[0] = static_cast<std::uint16_t>(i * 30011);
    host.wait_ms(10);
    ASSERT_LE(std::abs(host.board.pins.duty[0]), EB_DUTY_FULL);
  }
}

}  // namespace
}  // namespace eyebridge::firmware
