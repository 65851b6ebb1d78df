// A robot program's devices on a robot with messages of its own: units, counters that wrap, a pose.
#include "board/dbc_link.hpp"

#include <array>
#include <cstring>
#include <limits>

#include "../bridges/client/can_bench.hpp"
#include "board/board_backend.hpp"
#include "borrowed_clock.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/bridges/dbc/read_dbc.hpp"

namespace eyebridge::hal::testing {
namespace {

using namespace std::chrono_literals;
using bridges::testing::KeptLog;
using bridges::testing::LivingClock;
using ::testing::HasSubstr;

constexpr std::string_view kMessages =
    "BO_ 16 Go: 4 Host\n SG_ L : 0|16@1- (1,0) [0|0] \"mm/s\" R\n"
    " SG_ R : 16|16@1- (1,0) [0|0] \"mm/s\" R\n"
    "BO_ 32 Say: 8 R\n SG_ L : 0|8@1+ (1,0) [0|0] \"mm\" Host\n SG_ R : 8|8@1+ (1,0) [0|0] \"mm\" "
    "Host\n"
    " SG_ X : 16|16@1- (1,0) [0|0] \"mm\" Host\n SG_ Y : 32|16@1- (1,0) [0|0] \"mm\" Host\n"
    " SG_ H : 48|16@1- (0.1,0) [0|0] \"deg\" Host\n"
    "BO_ 33 Far: 5 R\n SG_ F : 0|32@1- (1,0) [0|0] \"m\" Host\n"
    "SIG_VALTYPE_ 33 F : 1;\n";

constexpr std::string_view kMeaning =
    "[robot]\nname = \"thing\"\nwheel_base = 0.1\nmax_speed = 0.5\nticks_per_metre = 4000.0\n"
    "[wheels]\nleft = { signal = \"Go.L\" }\nright = { signal = \"Go.R\" }\n"
    "[[command]]\nmessage = \"Go\"\nperiod = \"20ms\"\n"
    "[[encoder]]\nid = 1\nsignal = \"Say.L\"\n[[encoder]]\nid = 2\nsignal = \"Say.R\"\n"
    "[[range]]\nid = 7\nsignal = \"Far.F\"\nscale = 2.0\n"
    "[heartbeat]\nmessage = \"Say\"\ntimeout = \"100ms\"\n"
    "[pose]\nx = { signal = \"Say.X\" }\ny = { signal = \"Say.Y\" }\ntheta = { signal = \"Say.H\" "
    "}\n";

/// The robot is where the test says, whatever its wheels do.
class DbcLinkTest : public ::testing::Test {
 protected:
  DbcLinkTest() {
    clock.live = [this] { robot_lives(); };
    const auto file = bridges::dbc::read_dbc(kMessages, "x.dbc");
    DbcRobot robot = read_dbc_map(kMeaning, "x.toml", file);
    auto client = std::make_unique<bridges::DbcClient>(bus.connect("can0"), robot.plan, clock, log);
    EXPECT_TRUE(client->wait_ready(1s)) << log.text();
    const BoardTables tables = robot.tables;
    auto made = std::make_unique<DbcLink>(std::move(client), std::move(robot), clock);
    link = made.get();
    backend = std::make_unique<BoardBackend>(std::make_unique<BorrowedClock>(clock),
                                             std::move(made), tables);
  }

  void robot_lives() {
    while (const auto frame = node->receive(Time{0})) {
      left = static_cast<std::int16_t>(frame->data[0] | frame->data[1] << 8);
      right = static_cast<std::int16_t>(frame->data[2] | frame->data[3] << 8);
    }
    if (silent || clock.now() < due) return;
    due = clock.now() + 20ms;
    bridges::CanFrame say{.id = 32, .length = 8};
    const auto put = [&](std::size_t at, int value) {
      say.data[at] = static_cast<std::uint8_t>(value);
      say.data[at + 1] = static_cast<std::uint8_t>(static_cast<unsigned>(value) >> 8U);
    };
    say.data[0] = static_cast<std::uint8_t>(counts[0]);
    say.data[1] = static_cast<std::uint8_t>(counts[1]);
    put(2, pose[0]);
    put(4, pose[1]);
    put(6, pose[2]);
    ASSERT_TRUE(node->send(say, Time{0}));
    bridges::CanFrame distance{.id = 33, .length = 5};
    std::memcpy(distance.data.data(), &metres, sizeof metres);
    ASSERT_TRUE(node->send(distance, Time{0}));
  }
  /// `span` passes, as both threads would live it.
  void pass(Time span) {
    for (const Time end = clock.now() + span; clock.now() < end;) {
      link->client().pump(clock.now() + 10ms);
      backend->step();
    }
  }
  Pose odometry() { return backend->drive()->odometry().value(); }

  LivingClock clock;
  KeptLog log;
  bridges::MemoryCan bus{clock};
  std::unique_ptr<bridges::CanBus> node = bus.connect("robot");
  std::array<int, 2> counts{250, 3};
  std::array<int, 3> pose{1000, 500, 900};  // mm, mm, 0.1 degrees
  float metres = 0.25F;
  bool silent = false;
  int left = 0;
  int right = 0;
  Time due{0};
  DbcLink* link = nullptr;
  std::unique_ptr<BoardBackend> backend;
};

TEST_F(DbcLinkTest, SpeedsAreInTheRobotsUnits) {
  ASSERT_TRUE(backend->motor(1)->set_duty(0.5));
  ASSERT_TRUE(backend->motor(2)->set_speed(-400));
  pass(50ms);
  EXPECT_EQ(left, 250) << "half of 0.5 m/s";
  EXPECT_EQ(right, -100) << "400 ticks of 4000 a metre";
  EXPECT_TRUE(backend->stop());
  EXPECT_EQ(left, 0);
  EXPECT_EQ(right, 0);
}

TEST_F(DbcLinkTest, CountersWrapAndGoOn) {
  EXPECT_EQ(backend->encoder(1)->read().value(), 0);
  counts = {4, 250};  // 10 mm on, 9 mm back
  pass(50ms);
  EXPECT_EQ(backend->encoder(1)->read().value(), 40);
  EXPECT_EQ(backend->encoder(2)->read().value(), -36);
}

TEST_F(DbcLinkTest, DistancesAreScaledAndNeverInvented) {
  EXPECT_NEAR(backend->range_sensor(7)->read().value(), 0.5, 1e-9);
  metres = 1e30F;
  pass(50ms);
  EXPECT_NEAR(backend->range_sensor(7)->read().value(), kBoardOutOfRange, 1e-9);
  metres = std::numeric_limits<float>::quiet_NaN();
  pass(50ms);
  EXPECT_EQ(backend->range_sensor(7)->read().error().code, Errc::Corrupt);
}

TEST_F(DbcLinkTest, TheRobotsPoseIsTheOdometry) {
  EXPECT_NEAR(odometry().x, 0, 1e-9) << "a program begins at 0";
  EXPECT_NEAR(odometry().theta, 0, 1e-9);
  pose = {1000, 700, 1800};  // 0.2 m forward, since it looked along y; then a quarter to the left
  pass(50ms);
  EXPECT_NEAR(odometry().x, 0.2, 1e-9);
  EXPECT_NEAR(odometry().y, 0, 1e-9);
  EXPECT_NEAR(odometry().theta, kPi / 2, 1e-9);
  ASSERT_TRUE(backend->drive()->set_odometry({3, 4, 0}));
  pose = {900, 700, 1800};
  pass(50ms);
  EXPECT_NEAR(odometry().x, 3.1, 1e-9);
  EXPECT_NEAR(odometry().y, 4, 1e-9);
}

TEST_F(DbcLinkTest, OdometryGoesOnAfterALoss) {
  pose = {1000, 700, 900};
  pass(50ms);
  EXPECT_NEAR(odometry().x, 0.2, 1e-9);
  silent = true;
  pass(300ms);
  EXPECT_EQ(backend->drive()->odometry().error().code, Errc::Disconnected);
  pose = {0, 0, 0};  // it was switched off
  counts = {100, 100};
  silent = false;
  pass(100ms);
  EXPECT_NEAR(odometry().x, 0.2, 1e-9);
  EXPECT_EQ(backend->encoder(1)->read().value(), 0) << "how far it went meanwhile nobody knows";
  pose = {100, 0, 0};
  pass(50ms);
  EXPECT_NEAR(odometry().x, 0.3, 1e-9);
}

TEST_F(DbcLinkTest, WhatTheFileDoesNotSayIsNotThere) {
  EXPECT_EQ(backend->digital(), nullptr);
  EXPECT_EQ(backend->analog(), nullptr);
  EXPECT_EQ(backend->servo(1), nullptr);
  EXPECT_EQ(backend->motor(3), nullptr);
  EXPECT_EQ(backend->range_sensor(1), nullptr);
  EXPECT_THAT(backend->motor(1)->set_pid(1, 1, 1).error().what,
              HasSubstr("thing: its mapping file does not say anything about gains"));
}

}  // namespace
}  // namespace eyebridge::hal::testing
