// The client's own thread, on the computer's clock.
#include <cstring>
#include <fstream>
#include <thread>

#include <dirent.h>

#include "can_bench.hpp"
#include "eyebridge/bridges/monotonic_clock.hpp"

namespace eyebridge::bridges::testing {
namespace {

/// Names of this process's threads.
std::vector<std::string> thread_names() {
  std::vector<std::string> names;
  DIR* tasks = opendir("/proc/self/task");
  while (const dirent* task = readdir(tasks)) {
    std::ifstream file(std::string("/proc/self/task/") + task->d_name + "/comm");
    std::string name;
    if (std::getline(file, name)) names.push_back(name);
  }
  closedir(tasks);
  return names;
}

/// Waits until the kernel lists the client's thread, or no longer does. It shows the name when the
/// thread runs, and removes the thread shortly after the join.
bool wait_until_listed(bool listed, Clock& clock) {
  const Time deadline = clock.now() + 10s;
  while (::testing::Matches(::testing::Contains("eb:can"))(thread_names()) != listed) {
    if (clock.now() > deadline) return false;
    std::this_thread::yield();
  }
  return true;
}

TEST(CanClientThread, LivesByItselfAndEndsWithTheClient) {
  MonotonicClock clock;
  KeptLog log;
  MemoryCan bus(clock);
  const auto robot = bus.connect("robot");
  {
    CanClient client(bus.connect("can0"), 3, clock, log);
    client.start();
    EXPECT_TRUE(wait_until_listed(true, clock));
    const auto beat = robot->receive(clock.now() + 10s);
    ASSERT_TRUE(beat) << beat.error().what;
    EXPECT_EQ(text_of(*beat), "70F#05");
    // Calls of other threads meanwhile.
    std::vector<std::jthread> threads;
    for (int i = 0; i < 3; ++i) {
      threads.emplace_back([&client] {
        for (int n = 0; n < 200; ++n) {
          EXPECT_FALSE(client.drive(1, 1));
          EXPECT_FALSE(client.latest<can::PoseStatus>());
          (void)client.statistics();
        }
      });
    }
  }
  EXPECT_TRUE(wait_until_listed(false, clock));
}

TEST(CanClientThread, WakesWhoeverWaitsForTheRobot) {
  MonotonicClock clock;
  KeptLog log;
  MemoryCan bus(clock);
  const auto robot = bus.connect("robot");
  CanClient client(bus.connect("can0"), 1, clock, log);
  client.start();
  std::jthread living([&](const std::stop_token& stop) {
    int state = 0;
    while (!stop.stop_requested()) {
      const auto heard = robot->receive(clock.now() + 20ms);
      if (heard && heard->id == 0) state = 5;
      for (const std::uint32_t function :
           {0x18U, 0x19U, 0x1AU, 0x1BU, 0x1CU, 0x1DU, 0x1EU, 0x1FU, 0x28U, 0x29U, 0x2AU}) {
        (void)robot->send(raw_frame(function << 4U | 1U, {0, 0, 0, 0, 0, 0, 0, 0}), Time{0});
      }
      (void)robot->send(raw_frame(0x481, {1, '1', '.', '0', '4', 1, 1, 0}), Time{0});
      (void)robot->send(raw_frame(0x701, {state}), Time{0});
    }
  });
  const auto ready = client.wait_ready(30s);
  EXPECT_TRUE(ready) << ready.error().what;
  EXPECT_TRUE(client.drive(100, 0));
}

}  // namespace
}  // namespace eyebridge::bridges::testing
