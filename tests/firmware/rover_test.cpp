// The robot with messages of its own: what it obeys, and that it stops by itself.
#include <algorithm>
#include <array>
#include <vector>

#include <gmock/gmock.h>

#include "rv_rover.h"

namespace eyebridge::firmware {
namespace {

class RoverTest : public ::testing::Test {
 protected:
  RoverTest() {
    config.ticks_per_turn = 1100;
    config.full_ticks = 110;
    config.psd_mm = table.data();
    for (std::size_t i = 0; i < table.size(); ++i) table[i] = static_cast<std::uint16_t>(i);
    pins.psd[1] = pins.psd[2] = pins.psd[4] = pins.psd[5] = EB_PSD_ABSENT;
    pins.psd[0] = 100;
    pins.psd[3] = 200;
    rv_rover_init(&rover, &config, &pins);
  }

  /// A command to drive forwards; `speed` of both wheels in 0.1 rpm.
  static eb_can_frame drive(int speed, int counter) {
    eb_can_frame frame{};
    frame.id = RV_DRIVE;
    frame.extended = true;
    frame.length = 8;
    frame.data[1] = static_cast<std::uint8_t>(0x10 | counter);
    const auto put = [&](std::size_t at, int value) {
      frame.data[at] = static_cast<std::uint8_t>(static_cast<unsigned>(value) >> 8U);
      frame.data[at + 1] = static_cast<std::uint8_t>(value);
    };
    put(2, speed);
    put(4, -speed);
    frame.data[0] = rv_checksum(frame.data);
    return frame;
  }
  void say(const eb_can_frame& frame) { rv_rover_receive(&rover, &frame); }
  std::vector<eb_can_frame> live(unsigned ms) {
    std::vector<eb_can_frame> out;
    for (unsigned i = 0; i < ms; ++i) {
      rv_rover_process(&rover, 1000);
      eb_can_frame frame{};
      while (rv_rover_transmit(&rover, &frame)) out.push_back(frame);
    }
    return out;
  }
  [[nodiscard]] bool turns() const { return rover.pins.duty[0] != 0 || rover.pins.duty[1] != 0; }

  rv_rover rover{};
  rv_config config{};
  eb_pins pins{};
  std::array<std::uint16_t, RV_PSD_TABLE> table{};
};

TEST_F(RoverTest, DrivesForwardOnBothSides) {
  say(drive(1000, 0));
  live(20);
  EXPECT_EQ(rover.state, RV_DRIVING);
  EXPECT_GT(rover.pins.duty[0], 0);
  EXPECT_GT(rover.pins.duty[1], 0) << "forward is negative on its bus, not on its pins";
}

TEST_F(RoverTest, AWrongChecksumIsRefused) {
  for (std::size_t byte = 0; byte < 8; ++byte) {
    eb_can_frame frame = drive(1000, 0);
    frame.data[byte] ^= 0x04;
    say(frame);
  }
  live(20);
  EXPECT_FALSE(turns());
  EXPECT_EQ(rover.rejected, 8);
}

TEST_F(RoverTest, OnlyNewCommandsAreObeyed) {
  say(drive(1000, 5));
  EXPECT_EQ(rover.rejected, 0) << "the first one may have any counter";
  say(drive(1000, 5));
  say(drive(1000, 4));
  say(drive(1000, 9));
  EXPECT_EQ(rover.rejected, 3) << "the same, an old one, and four steps further";
  say(drive(1000, 8));
  say(drive(1000, 10));
  say(drive(1000, 13));
  say(drive(1000, 1));
  EXPECT_EQ(rover.rejected, 3) << "and over the end of the counter";
  eb_can_frame invalid = drive(1000, 15);
  say(invalid);
  EXPECT_EQ(rover.rejected, 4);
}

TEST_F(RoverTest, StopsByItself) {
  say(drive(1000, 0));
  live(99);
  EXPECT_TRUE(turns());
  live(1);
  EXPECT_FALSE(turns());
  EXPECT_EQ(rover.state, RV_SILENT);
  live(50);
  EXPECT_FALSE(turns());
  say(drive(1000, 11));
  live(20);
  EXPECT_TRUE(turns()) << "after silence any counter is a new beginning";
  rv_rover_lost(&rover);
  EXPECT_FALSE(turns());
}

TEST_F(RoverTest, ARefusedCommandDoesNotKeepItGoing) {
  say(drive(1000, 0));
  for (int i = 0; i < 12; ++i) {
    live(10);
    say(drive(1000, 0));
  }
  EXPECT_FALSE(turns());
}

TEST_F(RoverTest, StandsWhenToldOrNotEnabled) {
  say(drive(1000, 0));
  live(20);
  say(drive(0, 1));
  EXPECT_FALSE(turns());
  EXPECT_EQ(rover.state, RV_STANDING);
  say(drive(1000, 2));
  live(20);
  eb_can_frame disabled = drive(1000, 3);
  disabled.data[1] &= 0x0F;
  disabled.data[0] = rv_checksum(disabled.data);
  say(disabled);
  EXPECT_FALSE(turns());
}

TEST_F(RoverTest, OtherFramesAreNoCommands) {
  eb_can_frame frame = drive(1000, 0);
  frame.extended = false;
  say(frame);
  frame = drive(1000, 0);
  frame.length = 7;
  say(frame);
  frame = drive(1000, 0);
  frame.remote = true;
  say(frame);
  live(20);
  EXPECT_FALSE(turns());
  EXPECT_EQ(rover.rejected, 1) << "only the short one is a command at all";
}

TEST_F(RoverTest, CountsInTwentyFourBitsBothWays) {
  rover.pins.encoder[0] = 0xFFFE;  // two back
  rover.pins.encoder[1] = 3;
  const auto frames = live(10);
  const auto encoders = std::ranges::find(frames, RV_ENCODERS, &eb_can_frame::id);
  ASSERT_NE(encoders, frames.end());
  EXPECT_TRUE(encoders->extended);
  EXPECT_THAT(std::vector<int>(encoders->data, encoders->data + 6),
              ::testing::ElementsAre(0xFF, 0xFF, 0xFE, 0xFF, 0xFF, 0xFD));
}

TEST_F(RoverTest, TellsOneDistanceAfterTheOther) {
  std::vector<std::vector<int>> told;
  for (const eb_can_frame& frame : live(40)) {
    if (frame.id == RV_RANGES) told.emplace_back(frame.data, frame.data + 3);
  }
  EXPECT_THAT(told, ::testing::ElementsAre(std::vector{1, 0, 100}, std::vector{4, 0, 200},
                                           std::vector{1, 0, 100}, std::vector{4, 0, 200}));
}

}  // namespace
}  // namespace eyebridge::firmware
