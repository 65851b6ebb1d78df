// A line that is known to spoil bytes: what is asked twice, what is told again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "agreement.hpp"
#include "io7_bench.hpp"
#include "line_quality.hpp"
#include "opcodes.h"
#include "standing_orders.hpp"

namespace eyebridge::bridges::testing {
namespace {

using ::testing::HasSubstr;

io7::Reply reply(char letter, int value) {
  io7::Reply made{.letter = letter};
  made.values[0] = value;
  made.count = 1;
  return made;
}

class Io7NoiseTest : public ::testing::Test, protected Io7Bench {
 protected:
  void SetUp() override { ASSERT_TRUE(client.connect()); }
  int psd() {
    const auto answer = client.exchange(io7::psd(1));
    EXPECT_TRUE(answer) << answer.error().what;
    return answer ? answer->values[0] : -1;
  }
  void spoil_one() {
    damage = [](ScriptedLine& to, const std::string& answer) { to.arrive(answer.substr(1), 1ms); };
    EXPECT_EQ(psd(), 512);
  }
  void make_noisy() {
    spoil_one();
    spoil_one();
  }
};

TEST_F(Io7NoiseTest, OneSpoiledReplyDoesNotMakeALineNoisy) {
  spoil_one();
  EXPECT_EQ(sent_by([&] { psd(); }), "p 1\r");
  EXPECT_EQ(sent_by([&] { EXPECT_TRUE(client.exchange(io7::motor(1, 50))); }), "m 1 50\r");
}

TEST_F(Io7NoiseTest, ANoisyLineIsAskedTwiceUntilItWasCleanForFiveSeconds) {
  make_noisy();
  EXPECT_EQ(sent_by([&] { psd(); }), "p 1\rp 1\r");
  clock.spend(LineQuality::kMemory);
  EXPECT_EQ(sent_by([&] { psd(); }), "p 1\r");
}

TEST_F(Io7NoiseTest, AReadingThatTwoOthersDenyIsNotBelieved) {
  make_noisy();
  damage = [](ScriptedLine& to, std::string answer) {
    answer[0] = static_cast<char>(answer[0] ^ 0x04);  // 512 becomes 1536
    to.arrive(answer, 1ms);
  };
  EXPECT_EQ(psd(), 512);
  EXPECT_EQ(client.statistics().disagreements, 1U);
}

TEST_F(Io7NoiseTest, ReadingsThatNeverAgreeAreAnErrorAndNoReading) {
  make_noisy();
  int value = 0;
  line->on_write = [&](ScriptedLine& to, const std::string&) {
    value = (value + 3) % 16;
    to.arrive(std::string{static_cast<char>(value), '\0'}, 1ms);
  };
  const auto answer = client.exchange(io7::psd(1));
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().code, Errc::Corrupt);
  EXPECT_THAT(answer.error().what, HasSubstr("no two readings agree"));
}

TEST_F(Io7NoiseTest, ACommandIsSentTwiceAndThenOnceInAPeriod) {
  make_noisy();
  EXPECT_EQ(sent_by([&] { EXPECT_TRUE(client.exchange(io7::motor(1, 50))); }), "m 1 50\rm 1 50\r");
  EXPECT_TRUE(client.exchange(io7::motor(2, 0)));
  EXPECT_EQ(sent_by([&] { client.look_after(); }), "");
  clock.spend(10ms);
  EXPECT_EQ(sent_by([&] { client.look_after(); }), "m 1 50\rm 2 0\r");
  clock.spend(10ms);
  EXPECT_EQ(sent_by([&] { psd(); }), "m 1 50\rm 2 0\rp 1\rp 1\r");
  EXPECT_GT(client.statistics().repeated, 4U);
}

TEST_F(Io7NoiseTest, ABoardThatAnswersLateIsWaitedForLonger) {
  for (int i = 0; i < 50; ++i) psd();  // of replies that take 1 ms
  const auto late = [](ScriptedLine& to, const std::string& answer) { to.arrive(answer, 30ms); };
  for (int i = 0; i < 2; ++i) {
    damage = late;
    EXPECT_EQ(psd(), 512);
  }
  const auto timeouts = client.statistics().timeouts;
  damage = late;
  EXPECT_EQ(psd(), 512);
  EXPECT_EQ(client.statistics().timeouts, timeouts);
}

// Replies that come after the longest wait are no faults of the line once it is known how late they
// are.
TEST_F(Io7NoiseTest, ABoardThatAnswersVeryLateAtTimesIsWaitedForAsLongAsItTakes) {
  for (int i = 0; i < 50; ++i) psd();  // of replies that take 1 ms
  const auto late = [](ScriptedLine& to, const std::string& answer) { to.arrive(answer, 90ms); };
  damage = late;
  EXPECT_EQ(psd(), 512);
  const auto timeouts = client.statistics().timeouts;
  EXPECT_EQ(timeouts, 1U);
  for (int i = 0; i < 20; ++i) {
    damage = late;
    EXPECT_EQ(psd(), 512);
    clock.spend(1s);
  }
  EXPECT_EQ(client.statistics().timeouts, timeouts);
}

TEST_F(Io7NoiseTest, ABoardIsToldToStandUntilItsWheelsDo) {
  // No answer says that it has heard, and a bit that flips makes a 1 of the last 0: one of 120
  // programs that ended on such a line left its motors running.
  const auto stops = [&] {
    const std::string sent = sent_by([&] { EXPECT_TRUE(client.confirm_stop()); });
    int count = 0;
    for (std::size_t at = sent.find("m 1 0\r"); at != std::string::npos;
         at = sent.find("m 1 0\r", at + 1)) {
      ++count;
    }
    return count;
  };
  EXPECT_EQ(stops(), 2);
  make_noisy();
  EXPECT_EQ(stops(), 20) << "it has no encoders that would tell: ten times, each twice";
}

TEST_F(Io7NoiseTest, ACleanLineRepeatsNothing) {
  EXPECT_TRUE(client.exchange(io7::motor(1, 50)));
  clock.spend(50ms);
  EXPECT_EQ(sent_by([&] { client.look_after(); }), "");
  EXPECT_EQ(client.statistics().repeated, 0U);
}

TEST_F(Io7NoiseTest, MotorsAreToldAgainWhileAReplyIsWaitedFor) {
  make_noisy();
  EXPECT_TRUE(client.exchange(io7::motor(1, 50)));
  for (int i = 0; i < 50; ++i) psd();  // replies that take 1 ms are waited for 10 ms
  damage = [](ScriptedLine&, const std::string&) {};
  const std::string sent = sent_by([&] { EXPECT_EQ(psd(), 512); });
  EXPECT_THAT(sent.substr(sent.find("p 1")), ::testing::StartsWith("p 1\rm 1 50\r"));
}

TEST_F(Io7NoiseTest, ABoardThatIsSilentIsToldNothingSoThatItStops) {
  make_noisy();
  EXPECT_TRUE(client.exchange(io7::motor(1, 50)));
  Time told = clock.now();
  const Time silent = told;
  line->on_write = [&](ScriptedLine&, const std::string& sent) {
    if (sent == "m 1 50\r") told = clock.now();
  };
  EXPECT_EQ(client.exchange(io7::psd(1)).error().code, Errc::Disconnected);
  EXPECT_GT(told, silent);
  EXPECT_LE(told, silent + 2 * settings.idle);
  EXPECT_GT(clock.now(), silent + 500ms);
}

TEST_F(Io7NoiseTest, ASpoiledByteThatMadeRepliesTextIsUndoneWithoutALoss) {
  make_noisy();
  board.verbose = true;
  EXPECT_EQ(psd(), 512);
  EXPECT_FALSE(board.verbose);
  EXPECT_EQ(client.statistics().losses, 0U);
}

TEST(Io7Agreement, AllowsWhatASensorCanHaveChangedMeanwhile) {
  EXPECT_TRUE(agree(reply(IO7_PSD, 1000), reply(IO7_PSD, 1060), 1ms));
  EXPECT_FALSE(agree(reply(IO7_PSD, 1000), reply(IO7_PSD, 1128), 1ms));
  EXPECT_TRUE(agree(reply(IO7_ENCODER, 65530), reply(IO7_ENCODER, 20), 2ms)) << "over its end";
  EXPECT_FALSE(agree(reply(IO7_ENCODER, 100), reply(IO7_ENCODER, 132), 1ms));
  EXPECT_TRUE(agree(reply(IO7_ENCODER, 100), reply(IO7_ENCODER, 132), 2ms));
  EXPECT_FALSE(agree(reply(IO7_ENCODER, 100), reply(IO7_ENCODER, 612), 100ms));
  EXPECT_FALSE(agree(reply(IO7_DIGITAL_IN_ALL, 4), reply(IO7_DIGITAL_IN_ALL, 5), 1ms));
  EXPECT_FALSE(agree(reply(IO7_VW_DONE, 0), reply(IO7_VW_DONE, 1), 1ms));
}

/// What is due at `now`, by letter and first argument.
std::string due(StandingOrders& orders, Time now) {
  std::string all;
  while (const io7::Request* order = orders.due(now)) {
    all += order->letter + std::to_string(order->arguments[0]) + " ";
  }
  return all;
}

TEST(StandingOrdersTest, TheLastOrderOfEachMotorStands) {
  StandingOrders orders;
  orders.note(io7::motor(1, 50), 0ms);
  orders.note(io7::motor_speed(1, 20), 1ms);
  orders.note(io7::servo(2, 100), 1ms);
  EXPECT_EQ(orders.next_motor(), Time(11ms));
  EXPECT_EQ(due(orders, 10ms), "");
  EXPECT_EQ(due(orders, 11ms), "M1 ");
  EXPECT_EQ(due(orders, 12ms), "");
  EXPECT_EQ(due(orders, 201ms), "M1 s2 ");
}

TEST(StandingOrdersTest, WhoeverHasTheWheelsEndsWhatOthersWereTold) {
  StandingOrders orders;
  orders.note(io7::motor(1, 50), 0ms);
  orders.note(io7::request(IO7_VW_SET_SPEED, 100, 0), 0ms);
  EXPECT_EQ(due(orders, 10ms), "x100 ");
  orders.note(io7::request(IO7_VW_STRAIGHT, 100, 300), 10ms);
  EXPECT_EQ(due(orders, 20ms), "") << "a movement is not repeated, nor what it replaced";
  orders.note(io7::motor_speed(2, 5), 20ms);
  EXPECT_EQ(due(orders, 30ms), "M2 ");
}

}  // namespace
}  // namespace eyebridge::bridges::testing
