#include <random>
#include <string>
#include <string_view>

#include <gmock/gmock.h>

#include "eyebridge/bridges/io7/reply_parser.hpp"
#include "golden.hpp"

namespace eyebridge::bridges::io7 {
namespace {

using State = ReplyParser::State;
using test::profile_of;

State feed(ReplyParser& parser, std::string_view bytes) {
  for (const char byte : bytes) parser.push(static_cast<std::uint8_t>(byte));
  return parser.state();
}

TEST(Io7Reply, ARequestWithoutReplyIsCompleteAtOnce) {
  ReplyParser parser;
  parser.start(motor(1, 50), profile_of("raw-msb"));
  EXPECT_EQ(parser.state(), State::Complete);
}

TEST(Io7Reply, APromptIsWaitedForEvenWithoutReply) {
  ReplyParser parser;
  parser.start(motor(1, 50), profile_of("text-prompt"));
  EXPECT_EQ(feed(parser, "\r\n"), State::Waiting);
  EXPECT_EQ(feed(parser, ">"), State::Complete);
}

TEST(Io7Reply, AnEchoIsSkipped) {
  Profile profile = profile_of("text-prompt");
  profile.echo = true;
  ReplyParser parser;
  parser.start(psd(2), profile);
  EXPECT_EQ(feed(parser, "p 2\r\n1234\r\n>"), State::Complete);
  EXPECT_EQ(parser.reply()->values[0], 1234);
}

TEST(Io7Reply, AWrongEchoIsCorrupt) {
  Profile profile = profile_of("raw-msb");
  profile.echo = true;
  ReplyParser parser;
  parser.start(psd(2), profile);
  EXPECT_EQ(feed(parser, "p 3\r\x01\x02"), State::Corrupt);
}

TEST(Io7Reply, ARawEchoIsSkippedToItsLastByte) {
  Profile profile = profile_of("raw-msb");
  profile.echo = true;
  ReplyParser parser;
  parser.start(psd(2), profile);
  EXPECT_EQ(feed(parser, std::string_view("p 2\r\x00\x0D", 6)), State::Complete);
  EXPECT_EQ(parser.reply()->values[0], 13);
}

TEST(Io7Reply, ALostByteIsShortOnceTheLineIsQuiet) {
  ReplyParser parser;
  parser.start(encoder(1), profile_of("raw-msb"));
  EXPECT_EQ(feed(parser, "\x12"), State::Waiting);
  EXPECT_EQ(parser.quiet(), State::Corrupt);
  EXPECT_EQ(parser.reply().error().what, "IO7 'e': the reply is too short, found \"\\x12\"");
}

TEST(Io7Reply, SilenceIsATimeoutNotCorruption) {
  ReplyParser parser;
  parser.start(encoder(1), profile_of("raw-msb"));
  EXPECT_EQ(parser.quiet(), State::Waiting);
  EXPECT_EQ(parser.reply().error().code, Errc::Timeout);
}

TEST(Io7Reply, AnExtraByteIsStrayAndDoesNotShiftTheNextReply) {
  ReplyParser parser;
  const Profile profile = profile_of("raw-msb");
  parser.start(encoder(1), profile);
  EXPECT_EQ(feed(parser, "\x01\x02\x03"), State::Complete);
  EXPECT_EQ(parser.stray(), 1U);
  parser.start(encoder(1), profile);
  EXPECT_EQ(feed(parser, "\x04\x05"), State::Complete);
  EXPECT_EQ(parser.reply()->values[0], 0x0405);
  EXPECT_EQ(parser.stray(), 1U);
}

TEST(Io7Reply, TheReplyAfterACorruptOneIsRead) {
  ReplyParser parser;
  const Profile profile = profile_of("raw-msb");
  parser.start(psd(1), profile);
  EXPECT_EQ(feed(parser, "\xFF\x02"), State::Corrupt);
  EXPECT_EQ(feed(parser, "rest"), State::Corrupt);  // until the line is quiet
  EXPECT_EQ(parser.stray(), 4U);
  parser.start(request(IO7_VERSION), profile);
  EXPECT_EQ(feed(parser, "1.04"), State::Complete);
}

TEST(Io7Reply, WhatComesUnaskedIsStray) {
  ReplyParser parser;
  EXPECT_EQ(feed(parser, "AT\r"), State::Idle);
  EXPECT_EQ(parser.stray(), 3U);
}

TEST(Io7Reply, AListEndsAtThePrompt) {
  ReplyParser parser;
  parser.start(request(IO7_HELP), profile_of("text-prompt"));
  EXPECT_EQ(feed(parser, "h help\r\nv version > 1\r\n"), State::Waiting);
  EXPECT_EQ(feed(parser, ">"), State::Complete);
  EXPECT_EQ(parser.text(), "h help\r\nv version > 1\r\n");
}

TEST(Io7Reply, AListWithoutPromptEndsWhenTheLineIsQuiet) {
  ReplyParser parser;
  parser.start(request(IO7_HELP), profile_of("raw-msb"));
  EXPECT_EQ(feed(parser, "h help\r\nv vers"), State::Waiting);
  ReplyParser cut = parser;
  EXPECT_EQ(cut.quiet(), State::Corrupt);
  feed(parser, "ion\r\n");
  EXPECT_EQ(parser.quiet(), State::Complete);
}

TEST(Io7Reply, ATextThatDoesNotEndIsRefused) {
  ReplyParser parser;
  parser.start(request(IO7_HELP), profile_of("text-prompt"));
  for (std::size_t i = 0; i < kMaxReplyText; ++i) {
    ASSERT_EQ(parser.push('x'), State::Waiting);
  }
  EXPECT_EQ(parser.push('x'), State::Corrupt);
}

TEST(Io7Reply, ALetterThatIsNoneExpectsNothing) {
  ReplyParser parser;
  parser.start(Request{.letter = 'E'}, profile_of("raw-msb"));
  EXPECT_EQ(parser.state(), State::Idle);
}

TEST(Io7Reply, AnyBytesGiveAValueInRangeOrAnError) {
  std::mt19937 random(7);
  const std::string common = "0123456789-:= \r\n>v";
  int complete = 0;
  int corrupt = 0;
  ReplyParser parser;
  for (int round = 0; round < 60000; ++round) {
    const char* const forms[] = {"raw-msb", "raw-lsb", "raw-prompt", "text", "text-prompt"};
    Profile profile = profile_of(forms[random() % std::size(forms)]);
    profile.echo = random() % 8 == 0;
    const Command& command = commands()[random() % commands().size()];
    parser.start(Request{.letter = command.letter}, profile);
    for (auto length = random() % 12; length > 0; --length) {
      parser.push(static_cast<std::uint8_t>(
          random() % 3 == 0 ? random() & 0xFFU
                            : static_cast<std::uint8_t>(common[random() % common.size()])));
    }
    parser.quiet();
    const auto reply = parser.reply();
    if (!reply) {
      corrupt += reply.error().code == Errc::Corrupt;
      continue;
    }
    ++complete;
    ASSERT_EQ(reply->count, command.value_count);
    for (std::size_t i = 0; i < reply->count; ++i) {
      ASSERT_GE(reply->values[i], command.value_fields[i].first);
      ASSERT_LE(reply->values[i], command.value_fields[i].last);
    }
  }
  EXPECT_GT(complete, 5000);
  EXPECT_GT(corrupt, 5000);
}

}  // namespace
}  // namespace eyebridge::bridges::io7
