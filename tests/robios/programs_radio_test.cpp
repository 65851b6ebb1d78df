// RADIO: a robot that is alone, and two programs that play ping-pong.
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "named_program.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::ProgramRun;
using testing::run_named;

TEST(ProgramsRadio, ARobotThatIsAloneHearsItselfAndDoesNotWaitForEver) {
  const ProgramRun r = run_named("alone");
  EXPECT_EQ(r.exit_code, 1);
  EXPECT_THAT(r.out, HasSubstr("off 1 -1 0\ninit 0 id 1 check 0\nstatus 1 1\n"));
  EXPECT_THAT(r.out, HasSubstr("send 0 0 1 1\ncheck 1 1 1\nreceived 7 from 1: hello, , check 0\n"));
  EXPECT_THAT(r.out, HasSubstr("bad -1 -1\nwithout sender 5 again\n"));
  EXPECT_THAT(r.out, HasSubstr("release 0 init 0 check 0 status 0\n"));
  EXPECT_THAT(r.out, Not(HasSubstr("never")));
  EXPECT_THAT(r.err, HasSubstr("waits for a radio message that can never come"));
}

TEST(ProgramsRadio, LossAndDelayArePartOfTheWorld) {
  const ProgramRun lost = run_named("alone", {{"EYEBRIDGE_RADIO", "world?loss=100%"}});
  EXPECT_THAT(lost.out, HasSubstr("send 0 0 1 1\ncheck 0 0 0\n"));
  EXPECT_THAT(lost.err, HasSubstr("can never come"));
  const ProgramRun late = run_named("alone", {{"EYEBRIDGE_RADIO", "world?delay=2s&id=1"}});
  EXPECT_THAT(late.out, HasSubstr("check 0 0 0\nreceived 7 from 1: hello, , check 0\n"));
}

TEST(ProgramsRadio, TwoProgramsReachEachOtherOverTheNetwork) {
  const std::string group =
      "udp:239.192.7.8:" + std::to_string(20000 + ::getpid() % 40000) + "?id=";
  const auto play = [&](int id) {
    return run_named(
        "pingpong", {{"EYEBRIDGE_FAST", "false"}, {"EYEBRIDGE_RADIO", group + std::to_string(id)}});
  };
  ProgramRun one;
  std::thread other([&] { one = play(1); });
  const ProgramRun two = play(2);
  other.join();
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(two.exit_code, 0) << two.err;
  std::string pongs;
  std::string pings;
  for (int i = 1; i <= 10; ++i) {
    pongs += "2: pong " + std::to_string(i) + "\n";
    pings += "1: ping " + std::to_string(i) + "\n";
  }
  EXPECT_EQ(one.out, pongs);
  EXPECT_EQ(two.out, pings);
}

}  // namespace
}  // namespace eyebridge
