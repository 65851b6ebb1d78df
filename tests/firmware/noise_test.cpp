#include <random>

#include <gmock/gmock.h>

#include "board_fixture.hpp"
#include "noise_amount.hpp"

namespace eyebridge::firmware {
namespace {

// std::mt19937's numbers are the same everywhere; distributions are not.
std::uint8_t byte_of(std::mt19937& random) { return static_cast<std::uint8_t>(random() >> 13); }

void expect_sane(const eb_board& board) {
  for (const std::int16_t duty : board.pins.duty) {
    ASSERT_LE(duty, EB_DUTY_FULL);
    ASSERT_GE(duty, -EB_DUTY_FULL);
  }
  for (const std::uint16_t pulse : board.pins.servo_us) ASSERT_LE(pulse, 2550);
  ASSERT_EQ(board.pins.digital_out & ~board.pins.digital_outputs, 0);
  ASSERT_LE(board.io7.reply_count, EB_REPLY);
}

class Noise : public ::testing::TestWithParam<bool> {};

TEST_P(Noise, AnyBytesLeaveTheBoardSane) {
  std::mt19937 random(GetParam() ? 7 : 8);
  BoardUnderTest host(config_with([](eb_config& config) {
    config.io7.binary = GetParam();
    config.io7.letters = EB_LETTERS_ALL;
  }));
  // Mostly bytes of which requests are made: pure noise would never be one.
  const std::string likely = "hOmMdsSpevViIocaxXqQyYCzZ 0123456789-\r\r\r\r";
  std::uint8_t out[256];
  const std::uint64_t bytes = eyebridge::testing::noise_amount(1'000'000);
  for (std::uint64_t i = 0; i < bytes; ++i) {
    std::uint8_t byte = byte_of(random);
    if (!GetParam() && byte_of(random) < 240) {
      byte = static_cast<std::uint8_t>(likely[byte % likely.size()]);
    }
    eb_board_receive(&host.board, &byte, 1);
    if (i % 64 == 0) {
      host.board.pins.encoder[byte & 3] = static_cast<std::uint16_t>(random());
      eb_board_process(&host.board, byte * 400U);
      eb_board_transmit(&host.board, out, byte);
      expect_sane(host.board);
    }
  }
  EXPECT_GT(host.board.io7.bad_requests, 1000U);
}

INSTANTIATE_TEST_SUITE_P(RequestForms, Noise, ::testing::Bool(),
                         [](const auto& row) { return row.param ? "Binary" : "Ascii"; });

TEST(Noise, AnyFramesLeaveTheBoardSane) {
  std::mt19937 random(9);
  BoardUnderTest host(config_with([](eb_config& config) { config.node = 3; }));
  host.enable();
  const std::uint64_t frames = eyebridge::testing::noise_amount(300'000);
  for (std::uint64_t i = 0; i < frames; ++i) {
    eb_can_frame frame{};
    frame.id = static_cast<std::uint16_t>((random() & 0x7F0) | (byte_of(random) < 200 ? 3 : 0));
    frame.length = byte_of(random) < 200 ? 8 : static_cast<std::uint8_t>(byte_of(random) & 15);
    frame.fd = byte_of(random) == 0;
    frame.remote = byte_of(random) == 0;
    for (std::uint8_t& byte : frame.data) {
      byte = byte_of(random) < 128 ? byte_of(random) & 3 : byte_of(random);
    }
    eb_board_can_receive(&host.board, &frame);
    if (i % 8 == 0) {
      eb_board_process(&host.board, byte_of(random) * 100U);
      host.frames();
      expect_sane(host.board);
    }
    if (i % 50 == 0) host.enable();
  }
}

TEST(Noise, ALineWithoutEndIsDroppedAsAWhole) {
  BoardUnderTest host;
  host.ask(std::string(10'000, '1'));
  EXPECT_EQ(host.ask("m 1 50\r"), "");
  EXPECT_EQ(host.board.pins.duty[0], 0);
  EXPECT_EQ(host.ask("v\r"), "1.04");
}

TEST(Noise, AReplyThatNobodyFetchesIsLeftOutAsAWhole) {
  BoardUnderTest host;
  std::string requests;
  for (int i = 0; i < 1000; ++i) requests += "v\r";
  const std::string answers = host.ask(requests);
  EXPECT_EQ(answers.size(), 2048U);
  EXPECT_TRUE(host.board.io7.reply_lost);
  EXPECT_EQ(host.ask("V\r"), "\x02\xE4");
}

}  // namespace
}  // namespace eyebridge::firmware
