// The thread of a robot with its own messages, on the computer's clock.
#include <thread>

#include "can_bench.hpp"
#include "eyebridge/bridges/client/dbc_client.hpp"
#include "eyebridge/bridges/dbc/read_dbc.hpp"
#include "eyebridge/bridges/monotonic_clock.hpp"

namespace eyebridge::bridges::testing {
namespace {

TEST(DbcClientThread, ManyThreadsMayAskAndTheLastCommandIsToStand) {
  MonotonicClock clock;
  KeptLog log;
  MemoryCan bus(clock);
  const auto node = bus.connect("robot");
  const dbc::Database file = dbc::read_dbc(
      "BO_ 16 Go: 1 H\n SG_ V : 0|8@1- (1,0) [0|0] \"\" R\n"
      "BO_ 32 Beat: 1 R\n SG_ N : 0|8@1+ (1,0) [0|0] \"\" H\n",
      "x.dbc");
  DbcPlan plan;
  plan.robot = "robot";
  plan.commands = {DbcCommand{file.messages[0], 1ms, {0}, {}, {}}};
  plan.wheels = {{0, 0}};
  plan.statuses = {file.messages[1]};
  plan.readings = {{0, 0, {}}};
  plan.heartbeat_limit = 60s;
  int last = -1;  // the robot's, until it is joined
  std::jthread robot([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      // Fails once the client has left the bus.
      if (!node->send({.id = 32, .length = 1}, clock.now() + 10s)) break;
      if (const auto frame = node->receive(clock.now() + 1ms)) last = frame->data[0];
    }
  });
  {
    DbcClient client(bus.connect("can0"), plan, clock, log);
    client.start();
    ASSERT_TRUE(client.wait_ready(30s));
    std::vector<std::jthread> threads;
    for (int i = 0; i < 3; ++i) {
      threads.emplace_back([&client] {
        for (int n = 1; n < 100; ++n) {
          EXPECT_TRUE(client.wheel(0, n));
          EXPECT_TRUE(client.latest(0));
          EXPECT_EQ(client.generation(), 0u);
        }
      });
    }
    threads.clear();
    EXPECT_TRUE(client.wheel(0, 100));
  }
  robot.request_stop();
  robot.join();
  while (const auto frame = node->receive(Time{0})) last = frame->data[0];
  EXPECT_EQ(last, 0);
}

}  // namespace
}  // namespace eyebridge::bridges::testing
