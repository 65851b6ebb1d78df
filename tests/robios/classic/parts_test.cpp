// Handles, the cycle of distance sensors, samples.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "psd_cycle.hpp"
#include "sample.hpp"
#include "slots.hpp"

namespace eyebridge::robios::classic {
namespace {

using ::testing::HasSubstr;
using std::chrono::milliseconds;

TEST(Slots, HandlesAreBitsThatCanBeAdded) {
  Slots<char> slots("letter", 3);
  EXPECT_EQ(slots.open(10, 'a').value(), 1);
  EXPECT_EQ(slots.open(20, 'b').value(), 2);
  EXPECT_EQ(*slots.one(2).value(), 'b');
  EXPECT_FALSE(slots.one(3));
  EXPECT_EQ(slots.all(3).value().size(), 2U);
  EXPECT_FALSE(slots.all(0));
  EXPECT_FALSE(slots.all(7));
  EXPECT_THAT(slots.all(4).error().what, HasSubstr("0x4 is no open letter"));
}

TEST(Slots, ADeviceIsOpenOnceAndThereIsAnEnd) {
  Slots<char> slots("letter", 2);
  EXPECT_TRUE(slots.open(10, 'a'));
  EXPECT_FALSE(slots.open(10, 'a'));
  EXPECT_TRUE(slots.open(20, 'b'));
  EXPECT_FALSE(slots.open(30, 'c'));
}

TEST(Slots, NothingIsClosedUnlessAllOfItIsOpen) {
  Slots<char> slots("letter", 4);
  EXPECT_TRUE(slots.open(10, 'a'));
  EXPECT_TRUE(slots.open(20, 'b'));
  EXPECT_EQ(slots.close(4), 0x11110000);
  EXPECT_EQ(slots.close(0), 0x11110000);
  EXPECT_EQ(slots.close(6), 2);
  EXPECT_EQ(slots.open_mask(), 3);
  EXPECT_EQ(slots.close(3), 0);
  EXPECT_EQ(slots.open_mask(), 0);
  EXPECT_EQ(slots.open(30, 'c').value(), 1);
}

TEST(PsdCycle, ASingleMeasurementIsBusyThenReadyAndStaysTheOne) {
  PsdCycle cycle;
  EXPECT_FALSE(cycle.is_ready(milliseconds(0)));
  EXPECT_TRUE(cycle.start(1, false, milliseconds(100)));
  EXPECT_FALSE(cycle.start(2, false, milliseconds(159)));
  EXPECT_FALSE(cycle.is_ready(milliseconds(159)));
  EXPECT_TRUE(cycle.is_ready(milliseconds(160)));
  EXPECT_EQ(cycle.number(milliseconds(900)), 1);
  EXPECT_TRUE(cycle.start(2, false, milliseconds(160)));
}

TEST(PsdCycle, ARunningCycleTakesMoreSensorsIn) {
  PsdCycle cycle;
  EXPECT_TRUE(cycle.start(1, true, milliseconds(0)));
  EXPECT_TRUE(cycle.start(6, true, milliseconds(30)));
  EXPECT_EQ(cycle.mask(), 7);
  EXPECT_EQ(cycle.number(milliseconds(200)), 3);
  EXPECT_EQ(cycle.began(milliseconds(200)), milliseconds(120));
  cycle.stop();
  EXPECT_EQ(cycle.mask(), 0);
  EXPECT_EQ(cycle.began(milliseconds(200)), milliseconds(200));
}

std::vector<std::uint8_t> bytes(std::initializer_list<int> values) {
  return {values.begin(), values.end()};
}

TEST(Sample, AnAuFileBecomesAWavFile) {
  auto au = bytes({'.', 's', 'n', 'd', 0, 0, 0, 28, 0, 0, 0, 2,   0,
                   0,   0,   2,   0,   0, 0x1F, 0x40, 0, 0, 0, 1, 0, 0, 0, 0, 0x00, 0x7F});
  const auto sample = read_sample(au);
  ASSERT_TRUE(sample) << sample.error().what;
  EXPECT_EQ(sample->frequency, 8000);
  ASSERT_EQ(sample->wav.size(), 46U);
  EXPECT_EQ(sample->wav.at(44), 128);
  EXPECT_EQ(sample->wav.at(45), 255);
  const auto again = read_sample(sample->wav);
  ASSERT_TRUE(again) << again.error().what;
  EXPECT_EQ(again->frequency, 8000);
  au.pop_back();
  EXPECT_FALSE(read_sample(au));
}

TEST(Sample, WhatIsNoSampleIsAnError) {
  EXPECT_FALSE(sample_size(bytes({'R', 'I', 'F', 'F'})));
  EXPECT_FALSE(read_sample(std::vector<std::uint8_t>(100, 0)));
  // Two channels.
  EXPECT_THAT(read_sample(bytes({'.', 's', 'n', 'd', 0, 0, 0, 24, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0,
                                 0x1F, 0x40, 0, 0, 0, 2}))
                  .error()
                  .what,
              HasSubstr("2 channels"));
  // Bigger than any robot's memory.
  EXPECT_FALSE(sample_size(bytes({'.', 's', 'n', 'd', 0, 0, 0, 24, 255, 255, 255, 255, 0, 0, 0, 2,
                                  0, 0, 0x1F, 0x40, 0, 0, 0, 1})));
}

}  // namespace
}  // namespace eyebridge::robios::classic
