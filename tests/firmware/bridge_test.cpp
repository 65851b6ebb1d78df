#include <gmock/gmock.h>

#include "../bridges/transport/fake_clock.hpp"
#include "board_fixture.hpp"
#include "bridge_lines.hpp"
#include "eyebridge/bridges/can/messages.hpp"
#include "eyebridge/bridges/io7/probe.hpp"
#include "eyebridge/bridges/memory.hpp"

namespace eyebridge::firmware {
namespace {

namespace can = bridges::can;
namespace io7 = bridges::io7;

struct Dialect {
  bool binary, verbose, lsb_first, prompt_after_raw, vw;
  const char* prompt;
};

class ProbeMeetsFirmware : public ::testing::TestWithParam<int> {};

TEST_P(ProbeMeetsFirmware, AndFindsItsDialectWithoutMovingIt) {
  const unsigned bits = static_cast<unsigned>(GetParam());
  const Dialect dialect{(bits & 1) != 0, (bits & 2) != 0,  (bits & 4) != 0,
                        (bits & 8) != 0, (bits & 16) != 0, (bits & 32) != 0 ? ">" : ""};
  BoardUnderTest host(config_with([&](eb_config& config) {
    config.io7.binary = dialect.binary;
    config.io7.verbose = dialect.verbose;
    config.io7.lsb_first = dialect.lsb_first;
    config.io7.prompt_after_raw = dialect.prompt_after_raw;
    config.io7.letters = dialect.vw ? EB_LETTERS_ALL : EB_LETTERS_PAGE;
    std::string(dialect.prompt).copy(config.io7.prompt, 7);
  }));
  host.board.pins.analog[0] = 1515;
  io7::Probe probe;
  while (!probe.done()) {
    const auto sent = probe.step().send;
    const std::string answer = host.ask({reinterpret_cast<const char*>(sent.data()), sent.size()});
    host.wait_ms(30);
    probe.answer({reinterpret_cast<const std::uint8_t*>(answer.data()), answer.size()});
  }
  const auto report = probe.report();
  ASSERT_TRUE(report) << report.error().what;
  const io7::Profile& profile = report->profile;
  EXPECT_EQ(profile.request_form,
            dialect.binary ? io7::RequestForm::Binary : io7::RequestForm::Ascii);
  EXPECT_EQ(report->version, "1.04");
  EXPECT_EQ(report->battery_cv, 740);
  EXPECT_EQ(profile.letters.has('x'), dialect.vw);
  EXPECT_TRUE(profile.letters.has('E')) << "listed, but never to be sent";
  EXPECT_EQ(profile.prompt.view(), dialect.prompt);
  EXPECT_EQ(profile.reply_form, io7::ReplyForm::Raw) << "the safer form";
  EXPECT_EQ(profile.byte_order,
            dialect.lsb_first ? io7::ByteOrder::LsbFirst : io7::ByteOrder::MsbFirst);
  EXPECT_EQ(host.board.demos, 0U);
  for (const std::int16_t duty : host.board.pins.duty) EXPECT_EQ(duty, 0);
}

INSTANTIATE_TEST_SUITE_P(Dialects, ProbeMeetsFirmware, ::testing::Range(0, 64));

TEST(BridgeLines, BytesReachTheBoardAndItsLossStopsIt) {
  bridges::testing::FakeClock clock;
  auto [host, wire] = bridges::make_memory_streams(clock);
  BoardUnderTest board;
  const auto port = port_on(ports::byte_line(board.board), *wire);
  const std::string request = "m 1 50\rv\r";
  ASSERT_TRUE(host->write_all(
      {reinterpret_cast<const std::uint8_t*>(request.data()), request.size()}, Time{}));
  port->pump();
  std::array<std::uint8_t, 16> answer{};
  EXPECT_EQ(host->read_some(answer, Time{}), 4U);
  EXPECT_EQ(board.board.pins.duty[0], 5000);
  host->close();
  port->pump();
  EXPECT_FALSE(port->connected());
  EXPECT_EQ(board.board.pins.duty[0], 0);
}

TEST(BridgeLines, TheBridgeReadsEveryFrameOfTwoBoardsOnOneBus) {
  bridges::testing::FakeClock clock;
  bridges::MemoryCan bus(clock);
  const auto host = bus.connect("host");
  BoardUnderTest first(config_with([](eb_config& config) { config.node = 1; }));
  BoardUnderTest second(config_with([](eb_config& config) { config.node = 2; }));
  const auto one = bus.connect("one");
  const auto two = bus.connect("two");
  const auto port_one = port_on(ports::frame_line(first.board), *one);
  const auto port_two = port_on(ports::frame_line(second.board), *two);
  int seen[3] = {};
  for (int i = 0; i < 100; ++i) {
    for (const int node : {1, 2}) {
      const auto enable =
          can::encode(0, can::NmtCommand{EYECAN_NMT_ENABLE, static_cast<std::uint8_t>(node)});
      ASSERT_TRUE(host->send(*enable, Time{}));
    }
    ASSERT_TRUE(host->send(*can::encode(15, can::Heartbeat{EYECAN_STATE_OPERATIONAL}), Time{}));
    ASSERT_TRUE(host->send(*can::encode(2, can::SpeedCommand{.v_mm_s = 200}), Time{}));
    port_one->pump();
    port_two->pump();
    first.wait_ms(10);
    second.wait_ms(10);
    port_one->pump();
    port_two->pump();
    for (auto frame = host->receive(Time{}); frame; frame = host->receive(Time{})) {
      const auto message = can::decode_any(*frame);
      ASSERT_TRUE(message) << message.error().what;
      ASSERT_TRUE(message->node == 1 || message->node == 2);
      ++seen[message->node];
    }
  }
  EXPECT_GT(seen[1], 250);
  EXPECT_GT(seen[2], 250);
  EXPECT_EQ(first.board.pins.duty[0], 0);
  EXPECT_GT(second.board.pins.duty[0], 0) << "only the one that was meant";
}

}  // namespace
}  // namespace eyebridge::firmware
