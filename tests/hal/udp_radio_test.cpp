// Radio among processes: two of them in one test, over the loopback's multicast.
#include "radio/udp_radio.hpp"

#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "eyebridge/bridges/monotonic_clock.hpp"
#include "rigs.hpp"

namespace eyebridge::hal {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class UdpRadioTest : public ::testing::Test {
 protected:
  UdpRadioTest() {
    setting_.medium = RadioSetting::Medium::Udp;
    setting_.group = "239.192.7.7";
    // Tests that run at the same time must not hear each other.
    setting_.port = static_cast<std::uint16_t>(20000 + ::getpid() % 40000);
  }
  std::unique_ptr<Radio> radio(int id, const RadioErrors& errors = {}) {
    return make_udp_radio(setting_, id, errors, clock_, log_);
  }
  /// The next message, however long it takes: the test's time limit is the limit.
  static RadioMessage next(Radio& radio) {
    for (;;) {
      auto message = must(radio.receive());
      if (message) return *message;
      std::this_thread::yield();
    }
  }

  RadioSetting setting_;
  bridges::MonotonicClock clock_;
  KeepingLog log_;
};

TEST_F(UdpRadioTest, RobotsFindAndReachEachOther) {
  const auto one = radio(1);
  const auto two = radio(2);
  ASSERT_TRUE(one->start());
  ASSERT_TRUE(two->start());
  while (must(one->robots()).size() < 2 || must(two->robots()).size() < 2) {
    std::this_thread::yield();
  }
  EXPECT_THAT(must(one->robots()), ElementsAre(1, 2));
  ASSERT_TRUE(one->send(2, "ping"));
  EXPECT_EQ(next(*two), (RadioMessage{1, "ping"}));
  ASSERT_TRUE(two->send(Radio::kEveryone, std::string("p\0ng", 4)));
  EXPECT_EQ(next(*one), (RadioMessage{2, std::string("p\0ng", 4)}));
  ASSERT_TRUE(one->send(1, "self"));
  EXPECT_EQ(next(*one), (RadioMessage{1, "self"}));
  EXPECT_FALSE(must(two->receive()));
}

TEST_F(UdpRadioTest, ARobotThatSwitchesOffIsGone) {
  const auto one = radio(1);
  const auto two = radio(2);
  ASSERT_TRUE(one->start());
  ASSERT_TRUE(two->start());
  while (must(one->robots()).size() < 2) std::this_thread::yield();
  ASSERT_TRUE(two->stop());
  while (must(one->robots()).size() > 1) std::this_thread::yield();
  EXPECT_EQ(two->send(1, "x").error().code, Errc::Unsupported);
  EXPECT_EQ(two->receive().error().code, Errc::Unsupported);
  ASSERT_TRUE(two->start());
  ASSERT_TRUE(one->send(2, "again"));
  EXPECT_EQ(next(*two).text, "again");
}

TEST_F(UdpRadioTest, TwoRobotsWithOneNumberAreWarnedOf) {
  const auto one = radio(4);
  const auto other = radio(4);
  ASSERT_TRUE(one->start());
  ASSERT_TRUE(other->start());
  while (log_.messages(Severity::Warning).empty()) std::this_thread::yield();
  EXPECT_THAT(log_.messages(Severity::Warning).front(),
              HasSubstr("another robot has the number 4"));
}

TEST_F(UdpRadioTest, AllMessagesAreLostWhereTheErrorsSaySo) {
  const auto one = radio(1);
  const auto deaf = radio(2, {1.0, Time{0}, 1});
  ASSERT_TRUE(one->start());
  ASSERT_TRUE(deaf->start());
  ASSERT_TRUE(one->send(2, "x"));
  ASSERT_TRUE(deaf->send(1, "after"));
  EXPECT_EQ(next(*one).text, "after");
  EXPECT_FALSE(must(deaf->receive()));
}

TEST_F(UdpRadioTest, ANetworkThatIsNotThereIsAnError) {
  setting_.interface = "203.0.113.77";  // TEST-NET-3: nobody's
  const auto one = radio(1);
  const auto started = one->start();
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().code, Errc::Disconnected);
  EXPECT_THAT(started.error().what, HasSubstr("radio udp:239.192.7.7"));
}

}  // namespace
}  // namespace eyebridge::hal
