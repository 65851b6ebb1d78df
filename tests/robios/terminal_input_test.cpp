#include <cstdlib>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "terminal/input_decoder.hpp"

namespace eyebridge::robios {
namespace {

using Events = std::vector<TerminalEvent>;

Events decode(std::string_view bytes) {
  InputDecoder decoder;
  Events events;
  for (const char byte : bytes) {
    if (const auto event = decoder.push(static_cast<std::uint8_t>(byte))) events.push_back(*event);
  }
  return events;
}

Events keys(const std::vector<int>& masks) {
  Events events;
  for (const int mask : masks) {
    const int digit = mask == 8 ? '4' : mask == 4 ? '3' : '0' + mask;
    events.push_back({mask, 0, 0, digit});
  }
  return events;
}

TEST(TerminalInput, TakesTheDigitsOneToFour) {
  EXPECT_EQ(decode("1x2 34\xC3\xA4"), keys({1, 2, 4, 8}));
}

TEST(TerminalInput, TakesTheKeysOfARemoteControl) {
  // Codes of eyebot.h, IRTV_0 to IRTV_POWER.
  std::string codes;
  for (const TerminalEvent& event :
       decode("0q59rGyB.Pp\r\n\x1b[A\x1b[B\x1b[C\x1b[D\x1bOA\x1bOB\x1bOC\x1bOD")) {
    EXPECT_EQ(event.key, 0);
    codes += static_cast<char>(event.remote);
  }
  EXPECT_EQ(codes, "059RGYBPPOOUD>LUD>L");
  EXPECT_EQ(decode("\x1b[1A\x1b[E\x1bOE"), Events{}) << "arrows with Shift, other keys";
}

TEST(TerminalInput, TakesClicksOfTheFirstButton) {
  EXPECT_EQ(decode("\x1b[<0;1;1M"), (Events{{0, 0, 0}}));
  EXPECT_EQ(decode("\x1b[<0;120;40M\x1b[<0;120;40m"), (Events{{0, 119, 39}}));
  EXPECT_EQ(decode("\x1b[<16;3;4M"), (Events{{0, 2, 3}})) << "with Ctrl held";
}

TEST(TerminalInput, TakesNoOtherReports) {
  for (const char* report : {"\x1b[<1;2;3M", "\x1b[<2;2;3M", "\x1b[<64;2;3M", "\x1b[<32;2;3M",
                             "\x1b[<0;0;3M", "\x1b[<0;2M", "\x1b[<0;2;3;4M", "\x1b[<0;2;3x",
                             "\x1b[<0;999999;3M", "\x1b[<-1;2;3M", "\x1b[0;2;3M"}) {
    EXPECT_EQ(decode(report), Events{}) << report + 1;
  }
}

TEST(TerminalInput, TakesClicksOfTerminalsThatKnowOnlyTheOldForm) {
  EXPECT_EQ(decode("\x1b[M !#1"), (Events{{0, 0, 2}, {1, 0, 0, '1'}}));
  EXPECT_EQ(decode("\x1b[M#!#"), Events{}) << "a release";
  EXPECT_EQ(decode("\x1b[M 12"), (Events{{0, 16, 17}})) << "digits that are a place";
  EXPECT_EQ(decode("\x1b[M \x1b\x1b"), Events{}) << "columns beyond what the form can say";
}

TEST(TerminalInput, TakesNoByteOfOtherKeysForAKey) {
  EXPECT_EQ(decode("\x1b[1;2A\x1b[3~\x1b[15~\x1bOP\x1bO1\x1b[24;5~\x1b[?1;2c"), Events{});
  EXPECT_EQ(decode("\x1b[200~"), Events{});
}

TEST(TerminalInput, TakesWhatFollowsALoneEscape) {
  EXPECT_EQ(decode("\x1b\x31\x1b\x1b\x32"), keys({1, 2}));
  EXPECT_EQ(decode("\x1b[<0;1\x1b[<0;5;6M"), (Events{{0, 4, 5}})) << "a report begun twice";
  EXPECT_EQ(decode("\x1b[<0;1\x03"
                   "4"),
            keys({8}))
      << "broken off";
}

TEST(TerminalInput, FindsADigitAfterAnyNoise) {
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) {
    InputDecoder decoder;
    for (int n = 0; n < 40; ++n) decoder.push(static_cast<std::uint8_t>(random()));
    // No sequence outlives a control character and three bytes.
    for (int n = 0; n < 4; ++n) decoder.push('\n');
    EXPECT_EQ(decoder.push('4'), (TerminalEvent{8, 0, 0, '4'}));
  }
}

}  // namespace
}  // namespace eyebridge::robios
