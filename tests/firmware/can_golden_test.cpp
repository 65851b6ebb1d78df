#include <algorithm>
#include <string>

#include <gmock/gmock.h>

#include "board_fixture.hpp"
#include "golden.hpp"
#include "opcodes.h"

namespace eyebridge::firmware {
namespace {

using bridges::test::golden_lines;

/// The numbers of a golden line, as they are on the wire: without the decimal point.
std::vector<std::int32_t> numbers_of(const std::vector<std::string>& words) {
  std::vector<std::int32_t> numbers;
  for (std::size_t i = 2; i < words.size(); ++i) {
    std::string digits = words[i].substr(words[i].find('=') + 1);
    std::erase(digits, '.');
    numbers.push_back(static_cast<std::int32_t>(std::stol(digits)));
  }
  return numbers;
}

TEST(FirmwareCanGolden, EveryFrameIsReadAsInTheFile) {
  for (const auto& words : golden_lines("can.hex")) {
    const eb_can_frame frame = frame_of(words[0]);
    std::int32_t values[EB_MAX_SIGNALS] = {};
    ASSERT_EQ(eb_can_unpack(&frame, values), EB_CAN_GOOD) << words[0];
    const auto expected = numbers_of(words);
    const eb_message* message = eb_find_message(frame.id >> 4, frame.fd);
    ASSERT_EQ(message->count, expected.size()) << words[0];
    EXPECT_TRUE(std::ranges::equal(expected, std::span(values, expected.size()))) << words[0];
  }
}

TEST(FirmwareCanGolden, EveryFrameIsWrittenAsInTheFile) {
  for (const auto& words : golden_lines("can.hex")) {
    const eb_can_frame expected = frame_of(words[0]);
    eb_can_frame frame;
    ASSERT_TRUE(eb_can_pack(&frame, expected.id >> 4, expected.fd, expected.id & 0xF,
                            numbers_of(words).data()))
        << words[0];
    EXPECT_EQ(text_of(frame), words[0]);
  }
}

TEST(FirmwareCanGolden, EveryWrongFrameIsRefused) {
  for (const auto& words : golden_lines("can_refused.hex")) {
    const eb_can_frame frame = frame_of(words[0]);
    std::int32_t values[EB_MAX_SIGNALS];
    EXPECT_NE(eb_can_unpack(&frame, values), EB_CAN_GOOD) << words[0];
  }
}

TEST(FirmwareCanGolden, BytesAfterTheLastNumberAreIgnored) {
  const eb_can_frame frame = frame_of("000#0103FFFF");
  std::int32_t values[EB_MAX_SIGNALS];
  ASSERT_EQ(eb_can_unpack(&frame, values), EB_CAN_GOOD);
  EXPECT_EQ(values[1], 3);
}

TEST(FirmwareCanGolden, AValueOutsideItsRangeIsNotWritten) {
  eb_can_frame frame;
  const std::int32_t psd[] = {10000, 0, 0, 0};
  EXPECT_FALSE(eb_can_pack(&frame, EYECAN_S_PSD_A, false, 1, psd));
  const std::int32_t good[] = {9999, 0, 0, 65535};
  EXPECT_TRUE(eb_can_pack(&frame, EYECAN_S_PSD_A, false, 1, good));
  EXPECT_FALSE(eb_can_pack(&frame, EYECAN_S_PSD_A, false, 15, good));
}

}  // namespace
}  // namespace eyebridge::firmware
