// A robot that is driven by its own messages: what is sent, what is kept, when it is lost.
#include "eyebridge/bridges/client/dbc_client.hpp"

#include <cmath>

#include "can_bench.hpp"
#include "eyebridge/bridges/dbc/read_dbc.hpp"
#include "eyebridge/bridges/dbc/signal.hpp"

namespace eyebridge::bridges::testing {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view kFile =
    "BO_ 16 Go: 4 Host\n"
    " SG_ Crc : 0|8@1+ (1,0) [0|0] \"\" R\n SG_ Count : 8|4@1+ (1,0) [0|0] \"\" R\n"
    " SG_ On : 12|1@1+ (1,0) [0|0] \"\" R\n SG_ L : 16|8@1- (1,0) [0|0] \"rpm\" R\n"
    " SG_ R : 24|8@1- (1,0) [0|0] \"rpm\" R\n"
    "BO_ 32 Beat: 1 R\n SG_ Moves : 0|1@1+ (1,0) [0|0] \"\" Host\n"
    "BO_ 33 Count: 3 R\n SG_ Which M : 0|8@1+ (1,0) [0|0] \"\" Host\n"
    " SG_ A m0 : 15|16@0- (0.5,0) [0|0] \"\" Host\n SG_ B m1 : 15|16@0+ (1,0) [0|0] \"\" Host\n"
    "BA_ \"GenMsgCycleTime\" BO_ 33 20;\n";

DbcPlan plan_of(const dbc::Database& file) {
  DbcPlan plan;
  plan.robot = "robot";
  DbcCommand go{*file.find("Go"), 20ms, {0, 0x10, 0, 0}, {}, {}};
  go.counter = DbcCounter{1, dbc::kProfile1LastCounter};
  go.checksum = DbcChecksum{0, DbcChecksum::Kind::AutosarProfile1, 0x1234, dbc::DataIdMode::Both};
  plan.commands = {go};
  plan.wheels = {{0, 3}, {0, 4}};
  plan.statuses = {*file.find("Beat"), *file.find("Count")};
  plan.readings = {{0, 0, {}}, {1, 1, {}}, {1, 2, 0xFFFF}};
  plan.heartbeat_limit = 100ms;
  plan.stopped = 0;
  return plan;
}

class DbcClientTest : public ::testing::Test {
 protected:
  DbcClientTest() {
    clock.live = [this] { robot_lives(); };
  }

  void robot_lives() {
    while (const auto frame = node->receive(Time{0})) got.push_back(*frame);
    if (silent || clock.now() < due) return;
    due = clock.now() + 20ms;
    tell(32, {moves ? std::uint8_t{1} : std::uint8_t{0}});
    tell(33, {0, 0xFF, 0xFE});
    tell(33, {1, static_cast<std::uint8_t>(b >> 8), static_cast<std::uint8_t>(b)});
  }
  void tell(std::uint32_t id, const std::vector<std::uint8_t>& data) {
    CanFrame frame{.id = id, .length = static_cast<std::uint8_t>(data.size())};
    std::ranges::copy(data, frame.data.begin());
    ASSERT_TRUE(node->send(frame, Time{0}));
  }
  void live(Time span) { client.pump(clock.now() + span); }
  /// Of the last command.
  std::vector<int> wheels() const {
    return {static_cast<std::int8_t>(got.back().data[2]),
            static_cast<std::int8_t>(got.back().data[3])};
  }

  LivingClock clock;
  KeptLog log;
  MemoryCan bus{clock};
  std::unique_ptr<CanBus> node = bus.connect("robot");
  dbc::Database file = dbc::read_dbc(kFile, "x.dbc");
  DbcClient client{bus.connect("can0"), plan_of(file), clock, log};
  std::vector<CanFrame> got;
  bool silent = false;
  bool moves = false;
  unsigned b = 300;
  Time due{0};
};

TEST_F(DbcClientTest, NothingIsSentToARobotThatWasNeverHeard) {
  silent = true;
  live(500ms);
  EXPECT_TRUE(got.empty());
  EXPECT_EQ(client.wait_ready(10ms).error().what, "can0: robot not heard yet; expected Beat");
  EXPECT_EQ(client.wheel(0, 1).error().code, Errc::Disconnected);
  EXPECT_TRUE(client.stop());
}

TEST_F(DbcClientTest, CommandsComeAtTheirPeriodWithCounterAndChecksum) {
  ASSERT_TRUE(client.wait_ready(1s));
  got.clear();
  ASSERT_TRUE(client.wheel(0, 10));
  ASSERT_TRUE(client.wheel(1, -10));
  live(1s);
  ASSERT_NEAR(static_cast<double>(got.size()), 50, 2);
  for (std::size_t i = 0; i < got.size(); ++i) {
    const CanFrame& frame = got[i];
    EXPECT_EQ(frame.id, 16u);
    const std::uint8_t counter = frame.data[1] & 0xFU;
    EXPECT_LE(counter, 14);
    if (i > 0) {
      EXPECT_EQ(counter, ((got[i - 1].data[1] & 0xFU) + 1) % 15);
    }
    EXPECT_EQ(frame.data[1] & 0xF0U, 0x10U) << "the constant";
    EXPECT_EQ(frame.data[0],
              dbc::autosar_profile1(0x1234, dbc::DataIdMode::Both, counter, frame.bytes(), 0));
  }
  EXPECT_EQ(wheels(), (std::vector{10, -10}));
  EXPECT_EQ(client.wheel(0, 1000).error().code, Errc::OutOfRange);
  EXPECT_EQ(client.wheel(0, std::nan("")).error().code, Errc::OutOfRange);
}

TEST_F(DbcClientTest, ReadingsAreKeptByWhatTheirMultiplexerSelects) {
  ASSERT_TRUE(client.wait_ready(1s));
  EXPECT_EQ(client.latest(1)->value, -1.0);
  EXPECT_EQ(client.latest(1)->whole, -2);
  EXPECT_EQ(client.latest(2)->whole, 300);
  b = 0xFFFF;
  live(100ms);
  EXPECT_EQ(client.latest(2).error().code, Errc::Unsupported);
}

TEST_F(DbcClientTest, WhatDoesNotComeIsMissed) {
  ASSERT_TRUE(client.wait_ready(1s));
  silent = true;
  for (int i = 0; i < 10; ++i) {
    tell(32, {0});
    live(50ms);
  }
  EXPECT_EQ(client.latest(2).error().what, "can0: robot sends no Count.B");
  EXPECT_EQ(client.latest(2).error().code, Errc::Timeout);
}

TEST_F(DbcClientTest, ALostRobotIsToldToStandAndItsCommandsAreForgotten) {
  ASSERT_TRUE(client.wait_ready(1s));
  ASSERT_TRUE(client.wheel(0, 50));
  live(100ms);
  silent = true;
  live(200ms);
  EXPECT_EQ(client.generation(), 1u);
  EXPECT_EQ(wheels(), (std::vector{0, 0}));
  EXPECT_EQ(client.wheel(0, 50).error().what, "can0: robot has not sent Beat for 100 ms");
  EXPECT_EQ(client.latest(1).error().code, Errc::Disconnected);
  EXPECT_EQ(client.stop().error().code, Errc::Disconnected);
  EXPECT_THAT(log.text(), HasSubstr("can0: robot has not sent Beat for 100 ms\n"));
  silent = false;
  live(200ms);
  EXPECT_EQ(wheels(), (std::vector{0, 0}));
  EXPECT_TRUE(client.wheel(0, 50));
}

TEST_F(DbcClientTest, StoppingIsConfirmedByTheRobot) {
  ASSERT_TRUE(client.wait_ready(1s));
  ASSERT_TRUE(client.wheel(0, 50));
  moves = true;
  live(100ms);
  const auto stopped = client.stop();
  EXPECT_EQ(stopped.error().what, "can0: robot was told to stop, and does not show that it stands");
  EXPECT_EQ(wheels(), (std::vector{0, 0}));
  moves = false;
  live(100ms);
  EXPECT_TRUE(client.stop());
}

TEST_F(DbcClientTest, OtherFramesAreNobodysBusiness) {
  ASSERT_TRUE(client.wait_ready(1s));
  tell(32, {});
  CanFrame extended{.id = 33, .length = 3};
  extended.extended = true;
  extended.data = {1, 9, 9};
  ASSERT_TRUE(node->send(extended, Time{0}));
  live(10ms);
  EXPECT_EQ(client.latest(2)->whole, 300);
}

TEST(DbcFrame, ChecksumsCoverAllOtherBytes) {
  const dbc::Database file = dbc::read_dbc(kFile, "x.dbc");
  DbcCommand command{*file.find("Go"), 20ms, {0, 0x10, 7, 9}, {}, {}};
  EXPECT_EQ(dbc_frame(command, command.resting, 3).data[0], 0);
  command.checksum = DbcChecksum{0, DbcChecksum::Kind::Xor, 0, {}};
  EXPECT_EQ(dbc_frame(command, command.resting, 3).data[0], 0x10 ^ 7 ^ 9);
  command.counter = DbcCounter{1, 15};
  command.checksum->kind = DbcChecksum::Kind::SaeJ1850;
  const CanFrame frame = dbc_frame(command, command.resting, 3);
  EXPECT_EQ(frame.data[0], dbc::sae_j1850(std::vector<std::uint8_t>{0x13, 7, 9}));
  EXPECT_EQ(next_counter(command, 15), 0u);
  EXPECT_EQ(next_counter(command, 14), 15u);
}

}  // namespace
}  // namespace eyebridge::bridges::testing
