#include <gmock/gmock.h>

#include "board_fixture.hpp"

namespace eyebridge::firmware {
namespace {

eb_config with_all_letters() {
  return config_with([](eb_config& config) { config.io7.letters = EB_LETTERS_ALL; });
}

TEST(Watchdog, StopsTheMotorsAfterExactlyTheSilenceAllowed) {
  for (const char* command : {"m 1 50\r", "M 1 20\r", "x 200 0\r", "y 200 1000\r"}) {
    BoardUnderTest host(with_all_letters());
    host.ask(command);
    host.wait_us(299'999);
    EXPECT_NE(host.board.pins.duty[0], 0) << command;
    host.wait_us(1);
    EXPECT_EQ(host.board.pins.duty[0], 0) << command;
    EXPECT_EQ(host.board.watchdogs, 1U);
    host.wait_ms(500);
    EXPECT_EQ(host.board.pins.duty[0], 0) << "and it stays so";
  }
}

TEST(Watchdog, AnyGoodRequestKeepsThemRunning) {
  BoardUnderTest host;
  host.ask("m 1 50\r");
  for (int i = 0; i < 20; ++i) {
    host.wait_us(299'999);
    host.ask("v\r");
  }
  EXPECT_EQ(host.board.pins.duty[0], 5000);
}

TEST(Watchdog, NoiseDoesNotKeepThemRunning) {
  BoardUnderTest host;
  host.ask("m 1 50\r");
  for (int i = 0; i < 30; ++i) {
    host.wait_ms(10);
    host.ask("?\r\r");
  }
  EXPECT_EQ(host.board.pins.duty[0], 0);
}

TEST(Watchdog, ItsTimeCanBeSetAndSwitchedOff) {
  BoardUnderTest quick(config_with([](eb_config& config) { config.silence_us = 50'000; }));
  quick.ask("m 1 50\r");
  quick.wait_us(49'999);
  EXPECT_EQ(quick.board.pins.duty[0], 5000);
  quick.wait_us(1);
  EXPECT_EQ(quick.board.pins.duty[0], 0);
  BoardUnderTest never(config_with([](eb_config& config) { config.silence_us = 0; }));
  never.ask("m 1 50\r");
  never.wait_ms(60'000);
  EXPECT_EQ(never.board.pins.duty[0], 5000);
}

TEST(Watchdog, ALostLinkStopsAtOnceAndForgetsWhatWasHalfSaid) {
  BoardUnderTest host(with_all_letters());
  host.ask("y 200 1000\r");
  host.wait_ms(100);
  const std::uint8_t half[] = {'m', ' ', '1'};
  eb_board_receive(&host.board, half, sizeof half);
  eb_board_link_lost(&host.board);
  EXPECT_EQ(host.board.pins.duty[0], 0);
  EXPECT_EQ(host.ask(" 50\rv\r"), "1.04");
  host.wait_ms(100);
  EXPECT_EQ(host.board.pins.duty[0], 0) << "the move does not go on";
  host.ask("m 1 20\r");
  EXPECT_EQ(host.board.pins.duty[0], 2000) << "a new command is obeyed";
}

TEST(Watchdog, TheDemoEndsWithTheLink) {
  BoardUnderTest host;
  host.ask("E\r");
  host.wait_ms(500);
  EXPECT_NE(host.board.pins.duty[0], 0) << "silence does not end it, as on the real board";
  eb_board_link_lost(&host.board);
  host.wait_ms(2000);
  EXPECT_EQ(host.board.pins.duty[0], 0);
}

TEST(Watchdog, ASilentSerialHostDoesNotStopTheBus) {
  BoardUnderTest host(config_with([](eb_config& config) { config.node = 1; }));
  host.enable();
  for (int i = 0; i < 20; ++i) {
    host.send("70F#05");
    host.send("231#3200000001000000");
    host.wait_ms(100);
  }
  EXPECT_EQ(host.board.pins.duty[0], 5000);
}

}  // namespace
}  // namespace eyebridge::firmware
