#include "eyebridge/pins/board_world.hpp"

#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include "eyebridge/base/math.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/files/load.hpp"
#include "eyebridge/pins/psd_table.hpp"
#include "opcodes.h"

namespace eyebridge::pins {
namespace {

eb_config settings() {
  eb_config config;
  eb_config_default(&config);
  config.io7.letters = EB_LETTERS_ALL;
  return config;
}

files::Scenario world_of(const std::string& name) {
  return files::load_scenario(files::own_worlds() / name);
}

void say(eb_board& board, const std::string& text) {
  eb_board_receive(&board, reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

void run(BoardWorld& world, eb_board& board, double seconds) {
  for (double t = 0; t < seconds; t += world.simulation().settings().step) {
    board.silent_us = 0;  // a host that keeps talking
    world.step();
  }
}

struct Move {
  const char* name;
  double distance, angle_deg, speed;  // metres, degrees; of a turn degrees per second
};
void PrintTo(const Move& move, std::ostream* out) { *out << move.name; }

class MovesAgree : public testing::TestWithParam<std::tuple<Move, double>> {};

TEST_P(MovesAgree, WithTheSimulatedRobots) {
  const auto& [move, lag] = GetParam();
  files::Scenario scenario = files::default_scenario();
  scenario.models[0].drive.motor_time_constant = lag;
  const bool turn = move.distance == 0;
  const double angle = deg_to_rad(move.angle_deg);

  BoardWorld direct(scenario);
  direct.simulation().drive(0, {move.distance, angle, turn ? deg_to_rad(move.speed) : move.speed});
  for (int i = 0; i < 1500; ++i) direct.simulation().step();

  BoardWorld by_board(scenario);
  eb_board& board = by_board.add_board(0, settings());
  const int mm = static_cast<int>(std::lround(move.distance * 1000));
  const int speed = static_cast<int>(std::lround(turn ? move.speed : move.speed * 1000));
  const int degrees = static_cast<int>(move.angle_deg);
  say(board, turn ? "Y " + std::to_string(speed) + " " + std::to_string(degrees) + "\r"
                  : "C " + std::to_string(mm) + " " + std::to_string(degrees) + " " +
                        std::to_string(speed) + "\r");
  run(by_board, board, 15);

  const Pose want = direct.simulation().pose(0);
  const Pose got = by_board.simulation().pose(0);
  const double length = std::abs(move.distance);
  EXPECT_NEAR(got.x, want.x, 0.02 * length + 5e-4);
  EXPECT_NEAR(got.y, want.y, 0.02 * length + 5e-4);
  EXPECT_NEAR(wrap_angle(got.theta - want.theta), 0, deg_to_rad(2));
  EXPECT_EQ(board.drive.move_state, EYECAN_MOVE_DONE);
  const Pose start = scenario.robots[0].pose;
  const double believed_x = eb_drive_x_mm(&board.drive) / 1000.0;
  EXPECT_NEAR(std::hypot(got.x - start.x, got.y - start.y),
              std::hypot(believed_x, eb_drive_y_mm(&board.drive) / 1000.0), 0.003);
}

INSTANTIATE_TEST_SUITE_P(
    All, MovesAgree,
    testing::Combine(testing::Values(Move{"Straight", 0.7, 0, 0.3}, Move{"Back", -0.5, 0, 0.2},
                                     Move{"Fast", 0.7, 0, 0.6}, Move{"Short", 0.02, 0, 0.3},
                                     Move{"Left", 0, 90, 60}, Move{"RightAround", 0, -360, 180},
                                     Move{"Curve", 0.6, 90, 0.25}, Move{"Circle", 1.5, 360, 0.3},
                                     Move{"CurveBack", -0.4, -60, 0.2}),
                     testing::Values(0.0, 0.05)),
    [](const auto& row) {
      return std::string(std::get<0>(row.param).name) + (std::get<1>(row.param) > 0 ? "Lag" : "");
    });

TEST(BoardWorld, AWallStopsAMoveAndPressesTheBumper) {
  files::Scenario scenario = files::default_scenario();
  scenario.models[0].bumpers = {{.id = 1, .name = "FRONT", .start = -1, .end = 1}};
  BoardWorld world(scenario);
  eb_board& board = world.add_board(0, settings());
  say(board, "y 300 3000\r");
  run(world, board, 1);
  EXPECT_EQ(eb_board_levels(&board) & 1, 0);
  run(world, board, 9);
  EXPECT_EQ(eb_board_levels(&board) & 1, 1);
  EXPECT_EQ(board.drive.move_state, EYECAN_MOVE_ABORTED);
  EXPECT_EQ(board.pins.duty[0], 0);
}

// The board has six inputs.
TEST(BoardWorld, DistancesArriveAsRawValues) {
  BoardWorld world(files::default_scenario());
  eb_board& board = world.add_board(0, settings());
  const auto& sensors = world.simulation().model(0).range_sensors;
  ASSERT_FALSE(sensors.empty());
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (sensors[i].id > EB_PSDS) continue;
    const double mm = m_to_mm(world.simulation().true_range(0, i));
    EXPECT_NEAR(psd_table()[board.pins.psd[sensors[i].id - 1]], mm, 2) << sensors[i].name;
  }
}

TEST(BoardWorld, SensorsThatTheRobotLacksAreNotConnected) {
  files::Scenario scenario = files::default_scenario();
  scenario.models[0] = *files::builtin_robot("LabBot");
  BoardWorld world(scenario);
  eb_board& board = world.add_board(0, settings());
  for (const auto& sensor : world.simulation().model(0).range_sensors) {
    EXPECT_NE(board.pins.psd[sensor.id - 1], EB_PSD_ABSENT) << sensor.name;
  }
  EXPECT_EQ(board.pins.psd[EB_PSDS - 1], EB_PSD_ABSENT);
  EXPECT_EQ(board.config.lidar, world.simulation().model(0).lidar.has_value());
  EXPECT_EQ(board.config.matrices, 0);
}

TEST(BoardWorld, ARobotsRangeMatricesAreAnnounced) {
  files::Scenario scenario = files::default_scenario();
  scenario.models[0].range_matrices.resize(2);
  scenario.models[0].range_matrices[1].id = 4;
  BoardWorld world(scenario);
  EXPECT_EQ(world.add_board(0, settings()).config.matrices, 0x09);
}

TEST(BoardWorld, EachBoardDrivesItsOwnRobot) {
  BoardWorld world(world_of("two-robots.sim"));
  ASSERT_EQ(world.robots(), 2U);
  eb_board& first = world.add_board(0, settings());
  eb_board& second = world.add_board(1, settings());
  const Pose before[] = {world.simulation().pose(0), world.simulation().pose(1)};
  say(second, "M 1 20\rM 2 20\r");
  run(world, second, 1);
  EXPECT_EQ(world.simulation().pose(0), before[0]);
  EXPECT_NE(world.simulation().pose(1), before[1]);
  EXPECT_EQ(first.pins.encoder[0], 0);
  EXPECT_NEAR(second.pins.encoder[0], 2000, 40);
  EXPECT_THROW(world.add_board(2, settings()), std::out_of_range);
}

TEST(BoardWorld, ASilentHostStopsItsRobot) {
  BoardWorld world(files::default_scenario());
  eb_board& board = world.add_board(0, settings());
  say(board, "m 1 20\rm 2 20\r");
  for (int i = 0; i < 31; ++i) world.step();
  EXPECT_EQ(world.simulation().twist(0).linear, 0);
  EXPECT_EQ(board.watchdogs, 1U);
}

TEST(BoardWorld, FollowsTheClockAndLeavesOutWhatIsTooLate) {
  using std::chrono::milliseconds;
  BoardWorld world(files::default_scenario());
  EXPECT_EQ(world.advance(milliseconds(0)), milliseconds(10));
  EXPECT_EQ(world.advance(milliseconds(25)), milliseconds(30));
  EXPECT_NEAR(world.simulation().time(), 0.03, 1e-9);
  EXPECT_EQ(world.advance(milliseconds(10'000)), milliseconds(10'010));
  EXPECT_LT(world.simulation().time(), 0.6);
}

TEST(BoardWorld, AServoTurnsTheCamera) {
  BoardWorld world(files::default_scenario());
  eb_board& board = world.add_board(0, settings());
  say(board, "s 1 255\rs 2 0\r");
  world.step();
  EXPECT_EQ(world.simulation().servo(0, 0), 1.0);
  EXPECT_EQ(world.simulation().servo(0, 1), 0.0);
  EXPECT_EQ(world.simulation().servo(0, 2), 0.5);
}

TEST(PsdTable, IsTheInverseOfWhatTheWorldGives) {
  for (double mm = 0; mm < 9000; mm += 7) {
    const double step = (mm + 500) * (mm + 500) / 2'047'500;
    ASSERT_NEAR(psd_table()[psd_raw(mm / 1000)], mm, step / 2 + 0.51) << mm;
  }
  EXPECT_EQ(psd_raw(9.999), 0);
  EXPECT_EQ(psd_table()[0], 9999);
  EXPECT_EQ(psd_raw(-0.1), 4095);
}

TEST(PsdTable, NeverRises) {
  for (std::size_t raw = 1; raw < psd_table().size(); ++raw) {
    ASSERT_LE(psd_table()[raw], psd_table()[raw - 1]) << raw;
  }
}

TEST(PsdTable, IsPrintedAsAnHdtFile) {
  const std::string text = hdt_text(files::default_scenario().models[0]);
  EXPECT_THAT(text, testing::HasSubstr("ENCODER 1 6484\n"));
  EXPECT_THAT(text, testing::HasSubstr("DRIVE 90 60 0 0\n"));
  EXPECT_THAT(text, testing::HasSubstr("PSD 1 PSD_Table\n"));
  EXPECT_THAT(text, testing::HasSubstr("TABLE PSD_Table\n9999 "));
  EXPECT_TRUE(text.ends_with("\nEND TABLE\n"));
}

}  // namespace
}  // namespace eyebridge::pins
