// The central test: digital lines and analog inputs. Its rows are in *_rows.cpp.
#include <utility>

#include "backend_contract.hpp"
#include "sim/sim_sensors.hpp"

namespace eyebridge::hal {
namespace {

// The rig's robot has a bumper on line 1 and a proximity switch on line 2; the others float.
constexpr int kBumper = 1;
constexpr int kProximity = 2;
constexpr int kFree = 5;     // an input with pull-up at the start
constexpr int kOutput = 12;  // an output at the start

/// Whether the rig's robot has lines and inputs. One that has none has none of them.
bool has_lines(const Rig& rig, const RigTraits& traits) {
  EXPECT_EQ(rig.backend->digital() != nullptr, traits.lines);
  EXPECT_EQ(rig.backend->analog() != nullptr, traits.lines);
  return traits.lines;
}

bool level(const Rig& rig, int line) { return must(rig.backend->digital()->read(line)); }

TEST_P(BackendContract, LinesStartAsOnTheBoard) {
  const Rig rig = make(1.0);
  if (!has_lines(rig, traits())) return;
  // 3 … 8 are pulled up, 9 … 16 drive 0, the switches on 1 and 2 are open.
  EXPECT_EQ(must(rig.backend->digital()->read_all()), 0x00FC);
  EXPECT_TRUE(level(rig, kFree));
  EXPECT_FALSE(level(rig, kOutput));
}

TEST_P(BackendContract, ALineReadsWhatItsModeSays) {
  const Rig rig = make(1.0);
  if (!has_lines(rig, traits())) return;
  DigitalLines& lines = *rig.backend->digital();
  for (const auto& [mode, expected] :
       {std::pair{LineMode::PullDown, false}, {LineMode::PullUp, true}, {LineMode::Input, false}}) {
    ASSERT_TRUE(lines.setup(kFree, mode));
    rig.wait(traits().age);
    EXPECT_EQ(level(rig, kFree), expected) << static_cast<int>(mode);
  }
}

TEST_P(BackendContract, AnOutputReadsAsWhatItDrives) {
  const Rig rig = make(1.0);
  if (!has_lines(rig, traits())) return;
  DigitalLines& lines = *rig.backend->digital();
  for (const bool high : {true, false, true}) {
    ASSERT_TRUE(lines.write(kOutput, high));
    rig.wait(traits().age);
    EXPECT_EQ(level(rig, kOutput), high);
  }
  // Bit n - 1 is line n.
  EXPECT_EQ(must(lines.read_all()), 0x00FC | 1 << (kOutput - 1));
}

TEST_P(BackendContract, WhatIsWrittenToAnInputWaitsUntilItIsAnOutput) {
  const Rig rig = make(1.0);
  if (!has_lines(rig, traits())) return;
  DigitalLines& lines = *rig.backend->digital();
  ASSERT_TRUE(lines.setup(kFree, LineMode::PullDown));
  ASSERT_TRUE(lines.write(kFree, true));
  rig.wait(traits().age);
  EXPECT_FALSE(level(rig, kFree));
  ASSERT_TRUE(lines.setup(kFree, LineMode::Output));
  rig.wait(traits().age);
  EXPECT_TRUE(level(rig, kFree));
}

TEST_P(BackendContract, SwitchesDriveTheirLines) {
  const Rig far = make(1.0);
  if (!has_lines(far, traits())) return;
  EXPECT_FALSE(level(far, kBumper));
  EXPECT_FALSE(level(far, kProximity));
  const Rig near = make(kThreshold / 2);
  near.wait(traits().age);
  EXPECT_TRUE(level(near, kProximity));
}

TEST_P(BackendContract, LinesAndChannelsThatAreNotThereAreOutOfRange) {
  const Rig rig = make(1.0);
  if (!has_lines(rig, traits())) return;
  DigitalLines& lines = *rig.backend->digital();
  for (const int line : {-1, 0, 17}) {
    EXPECT_EQ(lines.read(line).error().code, Errc::OutOfRange);
    EXPECT_EQ(lines.write(line, true).error().code, Errc::OutOfRange);
    EXPECT_EQ(lines.setup(line, LineMode::Input).error().code, Errc::OutOfRange);
  }
  for (const int channel : {-1, 9}) {
    EXPECT_EQ(rig.backend->analog()->read(channel).error().code, Errc::OutOfRange);
  }
}

TEST_P(BackendContract, AnalogInputsKnowTheSupplyAndTheMicrophone) {
  const Rig rig = make(1.0);
  if (!has_lines(rig, traits())) return;
  AnalogInputs& inputs = *rig.backend->analog();
  EXPECT_NEAR(must(inputs.supply_voltage()), 7.4, 0.005);
  EXPECT_NEAR(must(inputs.read(AnalogInputs::kSupply)),
              7.4 / SimAnalog::kVoltsAtMost * AnalogInputs::kMost, 1);
  EXPECT_EQ(must(inputs.read(AnalogInputs::kMicrophone)), 2048);
  EXPECT_EQ(must(inputs.read(3)), 0);
}

TEST_P(BackendContract, OnlyABoardHasAVersionOfItsOwn) {
  const Rig rig = make(1.0);
  IoBoard* board = rig.backend->io_board();
  ASSERT_EQ(board != nullptr, !traits().world && !GetParam().replayed);
  if (board == nullptr) return;
  const auto version = board->version();
  ASSERT_EQ(version.has_value(), traits().lines);
  if (version) {
    EXPECT_EQ(version->size(), 4u);
  } else {
    EXPECT_EQ(version.error().code, Errc::Unsupported);
  }
}

TEST_P(BackendContract, LostLinesAndInputsAreErrors) {
  const Rig rig = make(1.0);
  if (!has_lines(rig, traits())) return;
  if (rig.unplug) rig.unplug();
  rig.wait(0.5);
  const bool there = !rig.unplug;
  EXPECT_EQ(rig.backend->digital()->read(kFree).has_value(), there);
  EXPECT_EQ(rig.backend->digital()->read_all().has_value(), there);
  EXPECT_EQ(rig.backend->digital()->write(kOutput, true).has_value(), there);
  EXPECT_EQ(rig.backend->analog()->read(1).has_value(), there);
  EXPECT_EQ(rig.backend->analog()->supply_voltage().has_value(), there);
}

}  // namespace
}  // namespace eyebridge::hal
