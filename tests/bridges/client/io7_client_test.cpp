// A board that behaves, and lines that do not: every failure is found, counted and survived.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io7_bench.hpp"
#include "opcodes.h"

namespace eyebridge::bridges::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class Io7ClientTest : public ::testing::Test, protected Io7Bench {
 protected:
  void connect() {
    const auto done = client.connect();
    ASSERT_TRUE(done) << done.error().what;
  }
  int psd() {
    const auto reply = client.exchange(io7::psd(1));
    EXPECT_TRUE(reply) << reply.error().what;
    return reply ? reply->values[0] : -1;
  }
};

TEST_F(Io7ClientTest, ProbesTheBoardAndStopsItsMotorsBeforeAnythingElse) {
  connect();
  EXPECT_TRUE(line->sent.ends_with("m 1 0\rm 2 0\rm 3 0\rm 4 0\r")) << line->sent;
  EXPECT_THAT(board.asked, Not(HasSubstr("E")));
  EXPECT_EQ(client.report()->version, "1.04");
  EXPECT_EQ(client.generation(), 1u);
  EXPECT_THAT(log.text(), HasSubstr("IO7 board, version 1.04, supply 7.40 V"));
}

TEST_F(Io7ClientTest, ExchangesExactlyTheDocumentedBytes) {
  connect();
  EXPECT_EQ(sent_by([&] { EXPECT_EQ(psd(), 512); }), "p 1\r");
  EXPECT_EQ(sent_by([&] { EXPECT_TRUE(client.exchange(io7::motor(1, 50))); }), "m 1 50\r");
  const Io7Statistics counts = client.statistics();
  EXPECT_EQ(counts.retries + counts.resyncs + counts.timeouts + counts.corrupt, 0u);
  EXPECT_EQ(counts.latency_min, Time(1ms));
  EXPECT_EQ(counts.latency_max, Time(1ms));
  EXPECT_EQ(counts.latency_mean(), Time(1ms));
}

// Nothing but settings and what is common to both forms.
constexpr const char* kNoReadings = "h help\r\nO output\r\nm motor\r\nv version\r\nV volt\r\n";

TEST_F(Io7ClientTest, AsksTheUserWhetherRequestsAreTextWhereTheBoardCannotTell) {
  board.list = kNoReadings;
  const auto found = client.connect();
  ASSERT_FALSE(found);
  EXPECT_THAT(found.error().what, HasSubstr("expected requests=text or requests=bytes"));
  EXPECT_THAT(line->sent, Not(HasSubstr("m 1"))) << "nothing is sent that could be another order";
}

TEST_F(Io7ClientTest, BelievesTheUserInWhatTheBoardCannotTell) {
  board.list = kNoReadings;
  settings.said_requests = io7::RequestForm::Ascii;
  settings.said_byte_order = io7::ByteOrder::LsbFirst;
  Io7Client other(opener(), clock, log, settings);
  ASSERT_TRUE(other.connect());
  EXPECT_EQ(other.report()->profile.request_form, io7::RequestForm::Ascii);
  EXPECT_EQ(other.report()->profile.byte_order, io7::ByteOrder::LsbFirst);
}

TEST_F(Io7ClientTest, NamesTheOptionForReadingsThatCanBeReadBothWaysRound) {
  board.battery_cv = 0x0505;
  board.analog_0 = 0x0303;
  connect();
  EXPECT_THAT(log.text(), HasSubstr("order=msb or order=lsb"));
}

TEST_F(Io7ClientTest, WaitsAsLongAsTheUserSays) {
  settings.said_timeout = 400ms;
  Io7Client other(opener(), clock, log, settings);
  ASSERT_TRUE(other.connect());
  damage = [](ScriptedLine& its_line, const std::string& answer) {
    its_line.arrive(answer, 390ms);
  };
  EXPECT_TRUE(other.exchange(io7::psd(1)));
  EXPECT_EQ(other.statistics().timeouts, 0U);
}

TEST_F(Io7ClientTest, SendsNothingThatTheBoardDoesNotList) {
  connect();
  const std::string sent = sent_by([&] {
    EXPECT_EQ(client.exchange(io7::encoder(1)).error().code, Errc::Unsupported);
    EXPECT_EQ(client.exchange(io7::request(IO7_DEMO)).error().code, Errc::Unsupported);
    EXPECT_EQ(client.exchange(io7::request(IO7_VW_SET_SPEED, 100, 0)).error().code,
              Errc::Unsupported);
    EXPECT_EQ(client.exchange(io7::motor(1, 101)).error().code, Errc::OutOfRange);
  });
  EXPECT_EQ(sent, "");
  EXPECT_TRUE(client.has('p'));
  EXPECT_FALSE(client.has('e'));
}

TEST_F(Io7ClientTest, ALateAnswerIsNotTakenForTheNextOne) {
  connect();
  damage = [](ScriptedLine& to, const std::string&) { to.arrive("\x01\x23", 60ms); };
  EXPECT_EQ(psd(), 512);
  EXPECT_EQ(psd(), 512);
  const Io7Statistics counts = client.statistics();
  EXPECT_EQ(counts.timeouts, 1u);
  EXPECT_EQ(counts.retries, 1u);
  EXPECT_GE(counts.resyncs, 1u);
}

TEST_F(Io7ClientTest, AnAnswerThatComesTwiceIsNoticedAtOnce) {
  connect();
  damage = [](ScriptedLine& to, const std::string& answer) { to.arrive(answer + answer, 1ms); };
  EXPECT_EQ(psd(), 512);
  EXPECT_EQ(client.statistics().corrupt, 1u);
  EXPECT_EQ(client.statistics().retries, 1u);
}

TEST_F(Io7ClientTest, AnAnswerThatComesAgainLaterIsNotTakenForTheNextOne) {
  connect();
  damage = [](ScriptedLine& to, const std::string& answer) {
    to.arrive(answer, 1ms);
    to.arrive("\x0B\xB8", 5ms);
  };
  EXPECT_EQ(psd(), 512);
  clock.spend(10ms);
  EXPECT_EQ(psd(), 512);
  EXPECT_EQ(client.statistics().stray, 2u);
  EXPECT_EQ(client.statistics().resyncs, 1u);
}

TEST_F(Io7ClientTest, ALostByteCostsOneRepetition) {
  connect();
  damage = [](ScriptedLine& to, const std::string&) { to.arrive("\x02", 1ms); };
  EXPECT_EQ(psd(), 512);
  EXPECT_EQ(psd(), 512);
  EXPECT_EQ(client.statistics().retries, 1u);
  EXPECT_EQ(client.statistics().corrupt, 1u);
}

TEST_F(Io7ClientTest, AnExtraByteCostsOneRepetition) {
  connect();
  damage = [](ScriptedLine& to, const std::string& answer) { to.arrive("\x02" + answer, 1ms); };
  EXPECT_EQ(psd(), 512);
  EXPECT_EQ(psd(), 512);
  EXPECT_EQ(client.statistics().retries, 1u);
}

TEST_F(Io7ClientTest, AFlippedBitThatLeavesTheRangeIsNoReading) {
  connect();
  damage = [](ScriptedLine& to, const std::string&) { to.arrive(std::string("\x42\x00", 2), 1ms); };
  EXPECT_EQ(psd(), 512);
  EXPECT_EQ(client.statistics().corrupt, 1u);
}

TEST_F(Io7ClientTest, ARequestThatIsSwallowedIsRepeatedOnce) {
  connect();
  damage = [](ScriptedLine&, const std::string&) {};
  EXPECT_EQ(psd(), 512);
  EXPECT_EQ(client.statistics().timeouts, 1u);
}

TEST_F(Io7ClientTest, WhatFailsTwiceIsAnErrorAndTheLineGoesOn) {
  connect();
  line->on_write = [answer = line->on_write](ScriptedLine& to, const std::string& sent) {
    if (sent.starts_with("p")) return;
    answer(to, sent);
  };
  const auto reply = client.exchange(io7::psd(1));
  ASSERT_FALSE(reply);
  EXPECT_EQ(reply.error().code, Errc::Timeout);
  EXPECT_THAT(reply.error().what, HasSubstr("script: IO7 'p': no reply"));
  EXPECT_TRUE(client.exchange(io7::analog(0)));
  EXPECT_EQ(client.statistics().losses, 0u);
}

TEST_F(Io7ClientTest, AnExchangeEndsSoonWhateverTheBoardDoes) {
  connect();
  line->on_write = {};
  const Time start = clock.now();
  EXPECT_EQ(client.exchange(io7::psd(1)).error().code, Errc::Disconnected);
  EXPECT_LE(clock.now() - start, Time(1s));
  const Time later = clock.now();
  EXPECT_THAT(client.exchange(io7::psd(1)).error().what, HasSubstr("does not answer any more"));
  EXPECT_EQ(clock.now(), later);
}

TEST_F(Io7ClientTest, ResynchronisesABinaryBoardWithZerosOnly) {
  board.binary = true;
  board.verbose = false;
  connect();
  ASSERT_EQ(client.report()->profile.request_form, io7::RequestForm::Binary);
  damage = [](ScriptedLine&, const std::string&) {};
  const std::string sent = sent_by([&] { EXPECT_EQ(psd(), 512); });
  EXPECT_EQ(sent, std::string("p\x01\0\0\0\0\0\0vp\x01", 11));
}

TEST_F(Io7ClientTest, RefusesALineThatTalksSomethingElse) {
  line->on_write = [](ScriptedLine& to, const std::string&) {
    to.arrive("$GPGGA,092750.000,5321.6802,N\r\n$GPGSA,A,3,10,07\r\n", 1ms);
  };
  const auto done = client.connect();
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, Errc::Corrupt);
  EXPECT_THAT(done.error().what,
              HasSubstr("script: IO7 probe: expected a list of command letters"));
  EXPECT_EQ(line->sent.find_first_not_of("\r\nh"), std::string::npos) << line->sent;
}

TEST_F(Io7ClientTest, RefusesASilentLineAfterItHadTimeToBoot) {
  board.silent = true;
  const auto done = client.connect();
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, Errc::Timeout);
  EXPECT_GE(clock.now(), Time(3s));
  EXPECT_LE(clock.now(), Time(6s));
}

TEST_F(Io7ClientTest, WaitsForABoardThatOpeningHasReset) {
  line->on_write = [this, answer = line->on_write](ScriptedLine& to, const std::string& sent) {
    if (clock.now() > Time(2s)) answer(to, sent);
  };
  connect();
}

TEST_F(Io7ClientTest, StaleBytesOfAnEarlierSessionAreNoAnswer) {
  line->arrive("\x02\x41 1.03");
  connect();
  EXPECT_EQ(client.report()->version, "1.04");
}

}  // namespace
}  // namespace eyebridge::bridges::testing
