#include "thread_wait.hpp"

#include <array>
#include <atomic>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "thread_state.hpp"

namespace eyebridge::robios {
namespace {

/// What the kernel says of a thread that waits in `call` with this first argument.
std::string text_of(long call, const std::string& argument) {
  return std::to_string(call) + " " + argument + " 0x7ffe 0x1 0x0 0x0 0x0 0x7ffe1a874210 0x7f15";
}

bool never(int /*descriptor*/) { return false; }

TEST(ThreadWait, NamesTheCall) {
  EXPECT_EQ(read_thread_wait(text_of(SYS_read, "0x3").c_str(), never).call, "read()");
  EXPECT_EQ(read_thread_wait(text_of(SYS_futex, "0x7f15").c_str(), never).call, "a lock");
}

TEST(ThreadWait, TakesWhatItDoesNotKnowForACallOfTheSystem) {
  for (const char* text : {"", "running\n", "999999 0x0", "-1 0x7ffe 0x7f15"}) {
    EXPECT_EQ(read_thread_wait(text, never).call, "a call of the system") << text;
  }
}

TEST(ThreadWait, AsksWhetherWhatIsReadIsATerminal) {
  const auto seventeen = [](int descriptor) { return descriptor == 17; };
  EXPECT_TRUE(read_thread_wait(text_of(SYS_read, "0x11").c_str(), seventeen).is_at_terminal);
  EXPECT_FALSE(read_thread_wait(text_of(SYS_read, "0x12").c_str(), seventeen).is_at_terminal);
  EXPECT_FALSE(read_thread_wait(text_of(SYS_futex, "0x11").c_str(), seventeen).is_at_terminal);
}

TEST(ThreadWait, OfAThreadIsWhatItDoes) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  std::atomic<int> tid = 0;
  std::thread reader([&] {
    tid = gettid();
    char byte = 0;
    EXPECT_EQ(::read(ends[0], &byte, 1), 1);
  });
  while (tid == 0 || look_at_thread(tid).kind != ThreadState::Kind::Sleeps)
    std::this_thread::yield();
  const ThreadWait wait = look_at_wait(getpid(), tid);
  EXPECT_EQ(wait.call, "read()");
  EXPECT_FALSE(wait.is_at_terminal);
  EXPECT_EQ(write(ends[1], "x", 1), 1);
  reader.join();
  close(ends[0]);
  close(ends[1]);
}

}  // namespace
}  // namespace eyebridge::robios
