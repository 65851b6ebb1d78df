#include "crash_handler.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <ctime>

#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "flow.hpp"
#include "robot.hpp"

namespace eyebridge::robios {
namespace {

constexpr std::array kCrashes = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

std::atomic<Robot*> broken = nullptr;

void tell(const Robot& robot, int signal, const void* address) {
  std::array<char, 40> where{};
  if (signal == SIGSEGV || signal == SIGBUS) {
    std::snprintf(where.data(), where.size(), " at address 0x%zx",
                  reinterpret_cast<std::uintptr_t>(address));
  }
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(),
                "eyebridge: robot %zu: error: the program crashed%s: %s%s; all robots end (with "
                "--isolate only this one would)\n",
                robot.index() + 1, flow.calls > 0 ? " inside a RoBIOS call" : "",
                sigdescr_np(signal), where.data());
  // A message that cannot be written is lost.
  [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), std::strlen(text.data()));
}

/// Waits here while another thread ends the run and the process.
[[noreturn]] void await_end(int code) {
  timespec left{8, 0};  // the other has less
  // Not sleep() and its kin: those are the robots', who would go on.
  while (syscall(SYS_nanosleep, &left, &left) != 0) {
  }
  syscall(SYS_exit_group, code);
  __builtin_unreachable();
}

thread_local constinit bool has_crashed = false;

// Nothing here takes memory or streams: the program may have locked them for ever.
void on_crash(int signal, siginfo_t* info, void* context) {
  Robot* const robot = Robot::current();
  if (robot == nullptr || has_crashed) {  // ours, or one while we tell of another
    ::signal(signal, SIG_DFL);
    raise(signal);
    return;
  }
  if (flow.calls == 0 && robot->signals().handle(signal, info, context)) return;
  has_crashed = true;
  const int code = 128 + signal;
  Robot* none = nullptr;
  if (broken.compare_exchange_strong(none, robot)) {
    robot->break_off(code);
    tell(*robot, signal, info->si_addr);
  }
  await_end(code);
}

void catch_crash(int signal, int flags) {
  struct sigaction action {};
  action.sa_sigaction = on_crash;
  // A program's handler may wait, or never return: others run, and crash, meanwhile.
  action.sa_flags = SA_SIGINFO | SA_NODEFER | flags;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

void handle_crashes() {
  for (const int signal : kCrashes) catch_crash(signal, SA_ONSTACK);
}

Robot* broken_robot() { return broken; }

void let_program_handle(int signal) {
  if (std::ranges::find(kCrashes, signal) != kCrashes.end()) catch_crash(signal, 0);
}

CrashStack::CrashStack() : room_(std::make_unique<std::array<char, kSize>>()) {
  const stack_t stack{room_->data(), 0, kSize};
  sigaltstack(&stack, nullptr);
}

CrashStack::~CrashStack() {
  stack_t none{};
  none.ss_flags = SS_DISABLE;
  sigaltstack(&none, nullptr);
}

}  // namespace eyebridge::robios
