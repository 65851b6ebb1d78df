// Radio among the robots of one world; what is sent over a network; what the setting says.
#include "radio/radio_medium.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clock/lockstep_clock.hpp"
#include "radio/radio_datagram.hpp"
#include "radio/radio_setting.hpp"

namespace eyebridge::hal {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Robots 1, 2 and 3 on one clock.
class RadioMediumTest : public ::testing::Test {
 protected:
  explicit RadioMediumTest(const RadioErrors& errors = {}) : errors_(errors) {
    for (const int id : {1, 2, 3})
      radios_.push_back(make_medium_radio(medium_, id, errors_, clock_));
  }
  Radio& robot(int id) { return *radios_[static_cast<std::size_t>(id) - 1]; }
  void all_on() {
    for (const auto& radio : radios_) ASSERT_TRUE(radio->start());
  }
  /// Everything that has come, "2:hello".
  std::vector<std::string> received(int id) {
    std::vector<std::string> out;
    while (const auto message = robot(id).receive().value()) {
      out.push_back(std::to_string(message->sender) + ":" + message->text);
    }
    return out;
  }

  LockstepClock clock_{10ms, [] {}};
  const RadioErrors errors_;
  std::shared_ptr<RadioMedium> medium_ = std::make_shared<RadioMedium>();
  std::vector<std::unique_ptr<Radio>> radios_;
};

TEST_F(RadioMediumTest, AMessageComesToItsReceiverOnly) {
  all_on();
  ASSERT_TRUE(robot(1).send(2, "hello"));
  ASSERT_TRUE(robot(1).send(1, "self"));
  EXPECT_THAT(received(2), ElementsAre("1:hello"));
  EXPECT_THAT(received(1), ElementsAre("1:self"));
  EXPECT_THAT(received(3), IsEmpty());
}

TEST_F(RadioMediumTest, EveryoneIsAllOthers) {
  all_on();
  ASSERT_TRUE(robot(2).send(Radio::kEveryone, std::string("a\0b", 3)));
  EXPECT_THAT(received(1), ElementsAre(std::string("2:a\0b", 5)));
  EXPECT_THAT(received(2), IsEmpty());
  EXPECT_THAT(received(3), ElementsAre(std::string("2:a\0b", 5)));
}

TEST_F(RadioMediumTest, KnowsWhoIsOn) {
  EXPECT_EQ(robot(1).robots().error().code, Errc::Unsupported);
  EXPECT_EQ(robot(1).receive().error().code, Errc::Unsupported);
  EXPECT_EQ(robot(1).send(2, "").error().code, Errc::Unsupported);
  ASSERT_TRUE(robot(3).start());
  ASSERT_TRUE(robot(1).start());
  ASSERT_TRUE(robot(1).start());
  EXPECT_THAT(robot(1).robots().value(), ElementsAre(1, 3));
  ASSERT_TRUE(robot(1).send(2, "lost"));
  ASSERT_TRUE(robot(2).start());
  EXPECT_THAT(received(2), IsEmpty());
  ASSERT_TRUE(robot(3).stop());
  ASSERT_TRUE(robot(3).stop());
  EXPECT_THAT(robot(1).robots().value(), ElementsAre(1, 2));
}

TEST_F(RadioMediumTest, WhatNoRobotCanSendIsOutOfRange) {
  all_on();
  EXPECT_EQ(robot(1).send(0, "x").error().code, Errc::OutOfRange);
  EXPECT_EQ(robot(1).send(256, "x").error().code, Errc::OutOfRange);
  EXPECT_EQ(robot(1).send(2, std::string(1025, 'x')).error().code, Errc::OutOfRange);
  EXPECT_TRUE(robot(1).send(2, std::string(1024, 'x')));
}

TEST_F(RadioMediumTest, TheOrderFollowsFromTheSendersNotFromWhoWasFirst) {
  all_on();
  ASSERT_TRUE(robot(3).send(1, "a"));
  ASSERT_TRUE(robot(2).send(1, "b"));
  ASSERT_TRUE(robot(3).send(1, "c"));
  clock_.spend(1ms);
  ASSERT_TRUE(robot(2).send(1, "d"));
  EXPECT_THAT(received(1), ElementsAre("2:b", "3:a", "3:c", "2:d"));
}

class SlowRadio : public RadioMediumTest {
 protected:
  SlowRadio() : RadioMediumTest({0.0, 50ms, 1}) {}
};

TEST_F(SlowRadio, AMessageTakesItsTime) {
  all_on();
  ASSERT_TRUE(robot(1).send(2, "x"));
  clock_.spend(49ms);
  EXPECT_THAT(received(2), IsEmpty());
  clock_.spend(1ms);
  EXPECT_THAT(received(2), ElementsAre("1:x"));
}

/// Which of 200 messages from 1 to 2 arrive.
std::vector<std::string> arrivals(std::uint64_t seed, bool with_another_sender) {
  LockstepClock clock(10ms, [] {});
  const RadioErrors errors{0.3, Time{0}, seed};
  const auto medium = std::make_shared<RadioMedium>();
  const auto one = make_medium_radio(medium, 1, errors, clock);
  const auto two = make_medium_radio(medium, 2, errors, clock);
  const auto three = make_medium_radio(medium, 3, errors, clock);
  for (const auto* radio : {&one, &two, &three}) EXPECT_TRUE((*radio)->start());
  for (int i = 0; i < 200; ++i) {
    EXPECT_TRUE(one->send(2, std::to_string(i)));
    if (with_another_sender) {
      EXPECT_TRUE(three->send(2, "noise"));
    }
  }
  std::vector<std::string> out;
  while (const auto message = two->receive().value()) {
    if (message->sender == 1) out.push_back(message->text);
  }
  return out;
}

TEST(RadioLoss, IsTheShareAskedForAndFollowsFromTheSeed) {
  const auto some = arrivals(1, false);
  EXPECT_NEAR(static_cast<double>(some.size()), 140, 25);
  EXPECT_EQ(arrivals(1, false), some);
  EXPECT_NE(arrivals(2, false), some);
  EXPECT_EQ(arrivals(1, true), some) << "what others send changes nothing between two robots";
}

TEST(RadioDatagrams, HaveTheBytesThatTheHeaderSays) {
  const RadioDatagram message{RadioDatagram::Kind::Message, 7, 9, 0x0102030405060708U, "hi"};
  const std::vector<std::uint8_t> bytes = encode(message);
  EXPECT_THAT(bytes, ElementsAre('E', 'B', 'R', '1', 1, 7, 9, 0, 1, 2, 3, 4, 5, 6, 7, 8, 'h', 'i'));
  EXPECT_EQ(decode_radio(bytes), message);
}

TEST(RadioDatagrams, AnythingElseIsNone) {
  const std::vector<std::uint8_t> good = encode({RadioDatagram::Kind::Here, 1, 0, 5, ""});
  ASSERT_TRUE(decode_radio(good));
  EXPECT_FALSE(decode_radio(std::span(good).first(15)));
  for (const auto& [at, value] :
       {std::pair{0U, 'X'}, {4U, '\0'}, {4U, '\5'}, {5U, '\0'}, {7U, '\1'}}) {
    std::vector<std::uint8_t> bad = good;
    bad[at] = static_cast<std::uint8_t>(value);
    EXPECT_FALSE(decode_radio(bad)) << at;
  }
  std::vector<std::uint8_t> longer = good;
  longer.push_back('x');
  EXPECT_FALSE(decode_radio(longer)) << "only a message has a text";
}

TEST(RadioSettings, SayWhoIsReached) {
  EXPECT_EQ(parse_radio("world", {}), RadioSetting{});
  EXPECT_EQ(parse_radio("none", {}).medium, RadioSetting::Medium::None);
  const RadioSetting udp =
      parse_radio("udp:239.192.7.1:7007?id=2&loss=12.5%&delay=20ms&interface=10.0.0.1", {});
  EXPECT_EQ(udp.medium, RadioSetting::Medium::Udp);
  EXPECT_EQ(udp.group, "239.192.7.1");
  EXPECT_EQ(udp.port, 7007);
  EXPECT_EQ(udp.interface, "10.0.0.1");
  EXPECT_EQ(udp.id, 2);
  EXPECT_EQ(udp.loss, 0.125);
  EXPECT_EQ(udp.delay, Time(20ms));
  const RadioSetting bad = parse_radio("world?jitter=5ms&corrupt=1%&range=4.5m", {});
  EXPECT_EQ(bad.jitter, Time(5ms));
  EXPECT_EQ(bad.corrupt, 0.01);
  EXPECT_EQ(bad.range, 4.5);
}

TEST(RadioSettings, MistakesAreNamed) {
  const std::vector<std::pair<std::string, std::string>> bad = {
      {"wifi", "found 'wifi', expected world, none or udp:GROUP:PORT"},
      {"world:2", "expected world, none"},
      {"none?id=2", "expected none without options"},
      {"udp:239.192.7.1", "expected udp:GROUP:PORT"},
      {"udp:192.168.7.1:7007", "a multicast group"},
      {"udp:239.192.7.1:0", "expected udp:GROUP:PORT"},
      {"udp:239.192.7.1:70000", "expected udp:GROUP:PORT"},
      {"world?id=0", "the number of a robot, 1 … 255"},
      {"world?id=two", "the number of a robot, 1 … 255"},
      {"world?loss=0.1", "a share of the messages"},
      {"world?loss=101%", "a share of the messages"},
      {"world?loss=1%%", "a share of the messages"},
      {"world?loss=%", "a share of the messages"},
      {"world?delay=2h", "at most an hour for 'delay'"},
      {"world?jitter=2h", "at most an hour for 'jitter'"},
      {"world?corrupt=2", "a share of the messages"},
      {"world?range=-1m", "metres, 0 (no limit) to 1e6"},
      {"udp:239.192.7.1:7007?range=1m", "of world: range"},
      {"world?interface=127.0.0.1", "one of the options"},
      {"udp:239.192.7.1:7007?interface=lo", "an IPv4 address"},
      {"world?speed=9", "one of the options"}};
  for (const auto& [text, message] : bad) {
    try {
      parse_radio(text, {"--radio"});
      ADD_FAILURE() << text;
    } catch (const ConfigError& error) {
      EXPECT_THAT(error.what(), HasSubstr(message)) << text;
      EXPECT_THAT(error.what(), HasSubstr("--radio")) << text;
    }
  }
}

}  // namespace
}  // namespace eyebridge::hal
