// The firmware's own logic and the plant, in one process and on virtual time.
#include "eyebridge/mps2/plant.hpp"

#include <cmath>
#include <cstring>

#include <gmock/gmock.h>

#include "board_app.h"
#include "eyebridge/base/units.hpp"
#include "eyebridge/files/readers.hpp"

namespace eyebridge::mps2 {
namespace {

using Bytes = std::vector<std::uint8_t>;

files::Scenario room() {
  files::Scenario scenario;
  scenario.world = files::read_world(
      "floor 4000 2000\n0 0 4000 0 0 200\n4000 0 4000 2000 0 200\n"
      "4000 2000 0 2000 0 200\n0 2000 0 0 0 200\n",
      "room.wld", scenario.warnings);
  robot::RobotModel model;
  robot::RangeSensorModel front;
  front.id = 1;
  front.max_range = 9.999;
  model.range_sensors.push_back(front);
  scenario.models.push_back(model);
  files::RobotPlacement robot;
  robot.pose = {1.0, 1.0, 0.0};
  scenario.robots.push_back(robot);
  return scenario;
}

eb_config with_vw() {
  eb_config config;
  eb_config_default(&config);
  config.io7.letters = EB_LETTERS_ALL;
  return config;
}

class PlantLink : public testing::Test {
 protected:
  PlantLink() { eb_app_init(&app); }

  /// What the firmware sends now.
  Bytes from_firmware() {
    Bytes bytes(EB_PLANT_FRAME);
    bytes.resize(eb_app_to_plant(&app, bytes.data()));
    return bytes;
  }
  void to_firmware(const Bytes& bytes) {
    for (const std::uint8_t byte : bytes) eb_app_plant(&app, byte);
  }
  void exchange() { to_firmware(plant.receive(from_firmware())); }
  /// Lets `count` milliseconds pass; what is sent arrives within the same one.
  void live(int count) {
    for (int i = 0; i < count; ++i) {
      exchange();
      eb_app_time(&app, 1000);
      exchange();
    }
  }
  void say(const char* text) {
    for (std::size_t i = 0; i < std::strlen(text); ++i) {
      eb_app_host(&app, static_cast<std::uint8_t>(text[i]));
    }
  }
  Bytes heard() {
    Bytes bytes(256);
    bytes.resize(eb_app_to_host(&app, bytes.data(), bytes.size()));
    return bytes;
  }
  [[nodiscard]] Pose pose() { return world.simulation().pose(0); }

  eb_app app{};
  pins::BoardWorld world{room()};
  Plant plant{world, 0, with_vw()};
};

TEST_F(PlantLink, TheFirmwareBeginsWithTheConfigurationAndTheInputs) {
  EXPECT_EQ(app.state, EB_APP_ASKING);
  exchange();
  EXPECT_EQ(app.state, EB_APP_RUNNING);
  EXPECT_STREQ(app.board.io7.letters, EB_LETTERS_ALL);
  EXPECT_EQ(app.board.pins.supply_cv, 740);
  EXPECT_EQ(plant.starts(), 1);
  EXPECT_EQ(plant.periods(), 0u);
}

TEST_F(PlantLink, OnePeriodOfTheBoardIsOneStepOfTheWorld) {
  live(1000);
  EXPECT_NEAR(static_cast<double>(plant.periods()), 100, 1);
  EXPECT_NEAR(world.simulation().time(), static_cast<double>(plant.periods()) * 0.01, 1e-9);
  EXPECT_EQ(app.board.uptime_us, plant.periods() * EB_TICK_US);
}

TEST_F(PlantLink, TheRobotDoesWhatItDoesWithABoardInTheSameProcess) {
  pins::BoardWorld other{room()};
  eb_board& board = other.add_board(0, with_vw());
  const std::string move = "C 500 90 200\r";  // a curve
  live(1);
  say(move.c_str());
  eb_board_receive(&board, reinterpret_cast<const std::uint8_t*>(move.data()), move.size());
  const std::uint64_t begun = plant.periods();
  for (int i = 0; i < 400; ++i) {
    say("v\r");
    heard();
    live(10);
  }
  for (std::uint64_t i = begun; i < plant.periods(); ++i) {
    const std::uint8_t ask[] = {'v', '\r'};
    eb_board_receive(&board, ask, sizeof ask);
    std::uint8_t answer[8];
    eb_board_transmit(&board, answer, sizeof answer);
    other.step();
  }
  const Pose there = other.simulation().pose(0);
  EXPECT_GT(there.x, 1.05);
  EXPECT_EQ(pose().x, there.x);
  EXPECT_EQ(pose().y, there.y);
  EXPECT_EQ(pose().theta, there.theta);
}

TEST_F(PlantLink, WhatThePlantReadsIsWhatTheHostIsTold) {
  live(30);
  say("p 1\r");
  const Bytes raw = heard();
  ASSERT_EQ(raw.size(), 2u);
  EXPECT_EQ(raw[0] * 256 + raw[1], std::lround(4095.0 * 500 / (3000 + 500)));
}

TEST_F(PlantLink, ALostAnswerIsAskedForAgainAndTheWorldGoesOnOnlyOnce) {
  live(20);
  const double time = world.simulation().time();
  Bytes outputs;
  while (outputs.empty()) {
    eb_app_time(&app, 1000);
    outputs = from_firmware();
  }
  plant.receive(outputs);  // and its answer is lost
  EXPECT_NEAR(world.simulation().time(), time + 0.01, 1e-9);
  Bytes again;
  for (int i = 0; i < 200 && again.empty(); ++i) {
    eb_app_time(&app, 1000);
    again = from_firmware();
  }
  EXPECT_EQ(again, outputs);
  EXPECT_FALSE(app.fresh);
  to_firmware(plant.receive(again));
  EXPECT_TRUE(app.fresh);
  EXPECT_NEAR(world.simulation().time(), time + 0.01, 1e-9);
}

TEST_F(PlantLink, AnAnswerThatComesTwiceIsTakenOnce) {
  live(20);
  Bytes outputs;
  while (outputs.empty()) {
    eb_app_time(&app, 1000);
    outputs = from_firmware();
  }
  const Bytes inputs = plant.receive(outputs);
  to_firmware(inputs);
  while ((outputs = from_firmware()).empty()) eb_app_time(&app, 1000);
  to_firmware(inputs);  // the old one once more: not the answer to what was just sent
  EXPECT_FALSE(app.fresh);
  to_firmware(plant.receive(outputs));
  EXPECT_TRUE(app.fresh);
}

TEST_F(PlantLink, TimeThatThePlantWasLateIsMadeUpFor) {
  live(20);
  for (int i = 0; i < 300; ++i) eb_app_time(&app, 1000);  // nobody answers
  const std::uint64_t before = plant.periods();
  live(60);
  EXPECT_NEAR(static_cast<double>(plant.periods() - before), 36, 2);
}

TEST_F(PlantLink, ABoardWhosePlantIsSilentAnswersNothing) {
  live(20);
  for (int i = 0; i < 600; ++i) eb_app_time(&app, 1000);
  say("p 1\r");
  EXPECT_TRUE(heard().empty());
  live(100);
  say("p 1\r");
  EXPECT_EQ(heard().size(), 2u);
}

TEST_F(PlantLink, TheMotorsStopWhenTheHostFallsSilent) {
  live(20);
  say("m 1 50\rm 2 50\r");
  live(100);
  const double x = pose().x;
  EXPECT_GT(x, 1.0);
  EXPECT_NE(app.board.pins.duty[0], 0);
  live(1000);
  EXPECT_EQ(app.board.pins.duty[0], 0);
  EXPECT_EQ(app.board.watchdogs, 1u);
  const double stopped = pose().x;
  live(200);
  EXPECT_EQ(pose().x, stopped);
}

TEST_F(PlantLink, TheMotorsStopAtOnceWhenTheHostGoesAway) {
  live(20);
  say("m 1 50\rm 2 50\rp 1\r");
  live(20);
  EXPECT_TRUE(plant.settled());
  plant.host_lost();
  EXPECT_FALSE(plant.settled());
  live(30);
  EXPECT_TRUE(plant.settled());
  EXPECT_EQ(app.board.pins.duty[0], 0);
  EXPECT_TRUE(heard().empty());  // the answer was for the one that is gone
  EXPECT_TRUE(eb_app_host_lost(&app));
  EXPECT_FALSE(eb_app_host_lost(&app));
}

TEST_F(PlantLink, AFirmwareThatRestartsFindsItsMotorsOff) {
  live(20);
  say("m 1 50\rm 2 50\r");
  live(200);
  eb_app_init(&app);
  exchange();
  EXPECT_EQ(plant.starts(), 2);
  EXPECT_EQ(app.state, EB_APP_RUNNING);
  live(1000);
  const double x = pose().x;
  live(200);
  EXPECT_EQ(pose().x, x);
}

TEST_F(PlantLink, AskingTwiceIsNotARestart) {
  const Bytes hello = from_firmware();
  plant.receive(hello);
  to_firmware(plant.receive(hello));
  EXPECT_EQ(plant.starts(), 1);
  live(100);
  EXPECT_NEAR(static_cast<double>(plant.periods()), 10, 1);
}

TEST_F(PlantLink, NothingMovesBeforeTheFirmwareHasSaidHello) {
  eb_plant_frame outputs{};
  eb_pins pins{};
  pins.duty[0] = pins.duty[1] = 5000;
  eb_plant_outputs(&outputs, 1, EB_TICK_US, 0, &pins);
  Bytes bytes(EB_PLANT_FRAME);
  bytes.resize(eb_plant_pack(&outputs, bytes.data()));
  EXPECT_TRUE(plant.receive(bytes).empty());
  EXPECT_EQ(world.simulation().time(), 0);
}

TEST_F(PlantLink, AFirmwareOfAnotherFormatIsRefusedByName) {
  PlantFrame hello{PlantKind::Hello, 0, 1, {2}};
  EXPECT_TRUE(plant.receive(encode(hello)).empty());
  EXPECT_EQ(plant.refusal(), "its firmware speaks format 2 on the plant link, expected 1");
}

TEST_F(PlantLink, NoiseOnBothWaysIsSurvived) {
  live(20);
  unsigned random = 1;
  const auto spoil = [&random](Bytes bytes) {
    random = random * 1664525U + 1013904223U;
    if (!bytes.empty() && random >> 26U == 0) bytes[random % bytes.size()] ^= 0x10;
    if (random >> 28U == 15) bytes.insert(bytes.begin(), {0xA5, 0x4F});
    return bytes;
  };
  for (int i = 0; i < 20'000; ++i) {
    eb_app_time(&app, 1000);
    to_firmware(spoil(plant.receive(spoil(from_firmware()))));
  }
  EXPECT_GT(plant.dropped(), 100u);
  EXPECT_GT(app.parser.dropped, 100u);
  // Three exchanges of a hundred are spoilt, each for 100 ms; what that costs is made up for.
  EXPECT_NEAR(world.simulation().time(), 20, 1);
  EXPECT_EQ(plant.starts(), 1);
}

}  // namespace
}  // namespace eyebridge::mps2
