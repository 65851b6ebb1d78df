#include "thread_state.hpp"

#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

namespace eyebridge::robios {
namespace {

using Kind = ThreadState::Kind;

ThreadState read(const std::string& name, char state) {
  return read_thread_state(
      ("71 (" + name + ") " + state + " 1 71 70 0 -1 4194560 123 0 0 0 250 50 0 0 20 0 1 0 990 99")
          .c_str());
}

TEST(ThreadState, IsWhatTheKernelSays) {
  EXPECT_EQ(read("prog", 'R').kind, Kind::Computes);
  EXPECT_EQ(read("prog", 'D').kind,
            Kind::Computes);  // it waits for the disk, which comes by itself
  EXPECT_EQ(read("prog", 'S').kind, Kind::Sleeps);
  EXPECT_EQ(read("prog", 'Z').kind, Kind::Gone);
  EXPECT_EQ(read("prog", 'X').kind, Kind::Gone);
}

TEST(ThreadState, DoesNotMindNames) {
  EXPECT_EQ(read("a) R (b", 'S').kind, Kind::Sleeps);
  EXPECT_EQ(read("", 'S').kind, Kind::Sleeps);
}

TEST(ThreadState, HasTheProcessorTimeOfUserAndKernel) {
  EXPECT_DOUBLE_EQ(read("prog", 'R').processor_s,
                   300.0 / static_cast<double>(sysconf(_SC_CLK_TCK)));
}

TEST(ThreadState, TakesNoTextForNoThread) {
  for (const char* text :
       {"", ")", "71 (prog", "71 (prog) ", "71 (prog) S 1 2 3", "71 (prog) S x"}) {
    EXPECT_EQ(read_thread_state(text).kind, Kind::Gone) << text;
  }
}

TEST(ThreadState, IsSeenOfThreadsThatAreThere) {
  EXPECT_EQ(look_at_thread(gettid()).kind, Kind::Computes);
  int tid = 0;
  std::thread([&] { tid = gettid(); }).join();
  while (look_at_thread(tid).kind != Kind::Gone)
    std::this_thread::yield();  // the kernel's last steps
}

}  // namespace
}  // namespace eyebridge::robios
