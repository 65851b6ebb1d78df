#include <cmath>

#include <gmock/gmock.h>

#include "board_fixture.hpp"
#include "eb_math.h"
#include "opcodes.h"

namespace eyebridge::firmware {
namespace {

constexpr double kTurn = 6.283185307179586;

/// One move on a plant, with what it was asked and what it drove.
struct Drive {
  explicit Drive(const eb_config& config = config_with(), const Plant& on = {})
      : host(config), plant(on) {}

  /// Until the move ends, at most `limit_s`; true when it is done.
  bool move(float distance, float angle, float speed, int limit_s = 60) {
    eb_drive_move(&host.board.drive, distance, angle, speed);
    for (int i = 0; i < limit_s * 100; ++i) {
      run(1);
      if (host.board.drive.move_state != EYECAN_MOVE_RUNNING) break;
    }
    run(60);
    return host.board.drive.move_state == EYECAN_MOVE_DONE;
  }
  void run(int periods) {
    for (int i = 0; i < periods; ++i) {
      plant.step(host.board);
      host.wait_ms(10);
    }
  }
  /// Of the wheels, by what they really rolled: metres and radians.
  double way() const { return (plant.travel[0] + plant.travel[1]) / 2 / 6484; }
  double angle() const { return (plant.travel[1] - plant.travel[0]) / 6484 / 0.09; }

  BoardUnderTest host;
  Plant plant;
};

struct Case {
  const char* name;
  float distance, angle, speed;
};
void PrintTo(const Case& move, std::ostream* out) { *out << move.name; }

class Moves : public testing::TestWithParam<std::tuple<Case, double>> {};

TEST_P(Moves, EndWhereTheyShould) {
  const Case& goal = std::get<0>(GetParam());
  const double lag = std::get<1>(GetParam());
  Drive drive(config_with([&](eb_config& c) { c.drive.motor_lag = static_cast<float>(lag); }),
              Plant{.lag = lag});
  ASSERT_TRUE(drive.move(goal.distance, goal.angle, goal.speed));
  // A lagging motor cannot be told exactly when to slow down: the limits of a parity run, halved.
  EXPECT_NEAR(drive.way(), goal.distance, lag > 0 ? 0.001 + 0.01 * 0.6 : 0.001);
  EXPECT_NEAR(drive.angle(), goal.angle, lag > 0 ? 0.017 : 0.006);
  EXPECT_EQ(eb_drive_remaining_mm(&drive.host.board.drive), 0);
  EXPECT_EQ(drive.host.board.pins.duty[0], 0);
}

INSTANTIATE_TEST_SUITE_P(
    Goals, Moves,
    testing::Combine(
        testing::Values(Case{"Straight", 1.0F, 0.0F, 0.3F}, Case{"Back", -0.5F, 0.0F, 0.2F},
                        Case{"Short", 0.01F, 0.0F, 0.6F}, Case{"Left", 0.0F, 1.5708F, 1.0F},
                        Case{"RightAllRound", 0.0F, -6.2832F, 3.0F},
                        Case{"Curve", 0.5F, 3.1416F, 0.3F}, Case{"CurveBack", -0.4F, 0.8F, 0.25F}),
        testing::Values(0.0, 0.1)),
    [](const auto& row) {
      return std::string(std::get<0>(row.param).name) + (std::get<1>(row.param) > 0 ? "Lag" : "");
    });

TEST(Drive, DeadReckoningFollowsACircle) {
  Drive drive;
  ASSERT_TRUE(drive.move(static_cast<float>(kTurn * 0.25), static_cast<float>(kTurn / 2), 0.3F));
  EXPECT_NEAR(eb_drive_x_mm(&drive.host.board.drive), 0, 3);
  EXPECT_NEAR(eb_drive_y_mm(&drive.host.board.drive), 1000, 3);
  EXPECT_NEAR(std::abs(eb_drive_heading_cdeg(&drive.host.board.drive)), 18000, 30);
}

TEST(Drive, SpeedIsRampedAndHeld) {
  Drive drive;
  eb_drive_speed(&drive.host.board.drive, 0.3F, 0.0F);
  drive.run(10);
  EXPECT_NEAR(drive.host.board.drive.linear, 0.1, 0.011) << "1 m/s^2 for 0.1 s";
  drive.run(90);
  EXPECT_NEAR(drive.plant.speed[0], 0.3 * 6484 * 0.01, 0.3);
  EXPECT_NEAR(eb_drive_linear(&drive.host.board.drive), 0.3, 0.004);
}

TEST(Drive, EmptyMovesTakeNoSpeedFromTheMovesAfterThem) {
  Drive drive;
  for (int i = 0; i < 50; ++i) {
    eb_drive_move(&drive.host.board.drive, 0.0F, 0.0F, 1.0F);
    EXPECT_EQ(drive.host.board.drive.move_state, EYECAN_MOVE_DONE);
    eb_drive_move(&drive.host.board.drive, 0.5F, 0.0F, 0.2F);
    drive.run(5);
  }
  EXPECT_NEAR(drive.host.board.drive.linear, 0.2, 0.01);
}

TEST(Drive, AHeldRobotStallsAndGivesUpAfterTwoSeconds) {
  Drive drive;
  drive.plant.held = true;
  eb_drive_move(&drive.host.board.drive, 1.0F, 0.0F, 0.3F);
  drive.run(100);
  EXPECT_TRUE(drive.host.board.drive.stalled[0] && drive.host.board.drive.stalled[1]);
  EXPECT_EQ(drive.host.board.drive.move_state, EYECAN_MOVE_RUNNING);
  drive.run(200);
  EXPECT_EQ(drive.host.board.drive.move_state, EYECAN_MOVE_ABORTED);
  EXPECT_EQ(drive.host.board.pins.duty[0], 0);
}

TEST(Drive, AFreedRobotGoesOn) {
  Drive drive;
  drive.plant.held = true;
  eb_drive_move(&drive.host.board.drive, 0.3F, 0.0F, 0.3F);
  drive.run(100);
  drive.plant.held = false;
  drive.run(400);
  EXPECT_EQ(drive.host.board.drive.move_state, EYECAN_MOVE_DONE);
  EXPECT_NEAR(drive.way(), 0.3, 0.002);
  EXPECT_FALSE(drive.host.board.drive.stalled[0]);
}

TEST(Drive, TheHeadingWrapsWithoutDrift) {
  eb_drive drive;
  const eb_config config = config_with();
  eb_drive_init(&drive, &config.drive);
  for (const int cdeg : {0, 1, -1, 9000, -9000, 17999, -18000, 4500}) {
    eb_drive_set_pose(&drive, 0, 0, cdeg);
    EXPECT_EQ(eb_drive_heading_cdeg(&drive), cdeg);
  }
  eb_drive_set_pose(&drive, 0, 0, 18000);
  EXPECT_EQ(eb_drive_heading_cdeg(&drive), -18000);
}

TEST(BoardMath, SineAndRootAreAsInLibm) {
  for (int i = 0; i < 10'000; ++i) {
    const auto turn = static_cast<std::uint32_t>(i) * 429'497U;
    float sine = 0;
    float cosine = 0;
    eb_sin_cos(turn, &sine, &cosine);
    const double angle = turn * (kTurn / 4294967296.0);
    ASSERT_NEAR(sine, std::sin(angle), 1e-6) << turn;
    ASSERT_NEAR(cosine, std::cos(angle), 1e-6) << turn;
  }
  for (const float value : {1e-12F, 1e-4F, 0.5F, 1.0F, 2.0F, 3.99F, 4.0F, 1e6F, 1e20F}) {
    EXPECT_NEAR(eb_sqrt(value) / std::sqrt(value), 1.0, 1e-6) << value;
  }
  EXPECT_EQ(eb_sqrt(0.0F), 0.0F);
  EXPECT_EQ(eb_round(-2.5F), -3);
  EXPECT_EQ(eb_round(3e9F), 2'000'000'000);
}

TEST(Drive, WhatTurnsLackDoesNotAddUp) {
  Drive drive;
  for (int i = 0; i < 40; ++i) {
    ASSERT_TRUE(drive.move(0.0F, 1.5707963F, 4.0F));
    ASSERT_TRUE(drive.move(0.05F, 0.0F, 0.4F));
  }
  EXPECT_NEAR(drive.angle(), 40 * 1.5707963, 0.009);
}

TEST(Drive, ARobotTurnedByHandIsNotTurnedBack) {
  Drive drive;
  ASSERT_TRUE(drive.move(0.0F, 1.0F, 4.0F));
  drive.plant.travel[0] -= 200;  // the wheels follow the hand
  drive.plant.travel[1] += 200;
  drive.run(5);
  const double before = drive.angle();
  ASSERT_TRUE(drive.move(0.0F, 1.0F, 4.0F));
  EXPECT_NEAR(drive.angle() - before, 1.0, 0.006);
}

}  // namespace
}  // namespace eyebridge::firmware
