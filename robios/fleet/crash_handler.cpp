#include "crash_handler.hpp"

#include <cstdint>
#include <cstring>

#include <fmt/format.h>
#include <pthread.h>
#include <signal.h>
#include <sys/ucontext.h>
#include <unistd.h>

#include "flow.hpp"
#include "robot.hpp"

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/asan_interface.h>
#endif

namespace eyebridge::robios {
namespace {

constexpr std::array kCrashes = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
constexpr int kHang = SIGURG;  // ignored by default: harmless where it comes late

// What the thread's last signal was about: read when the handler has returned.
thread_local int last_signal = 0;
thread_local const void* last_address = nullptr;

/// Where a robot's flow goes on after the handler, at the top of its stack.
[[noreturn]] void give_up() {
  Robot& robot = *Robot::current();
  if (last_signal == kHang) {
    robot.fail("the program has made no call for too long and is ended; the others go on", 124);
  }
  std::string where;
  if (last_signal == SIGSEGV || last_signal == SIGBUS) {
    where = fmt::format(" at address {}", last_address);
  }
  robot.fail(fmt::format("the program crashed: {}{}; it ends, the others go on",
                         strsignal(last_signal), where),
             128 + last_signal);
}

/// Lets the interrupted flow go on in give_up(), with the stack from `top` down.
bool redirect(ucontext_t& context, void* top) {
  // 256 bytes below where the program's first function had its frame: nothing there is needed.
  const auto stack = (reinterpret_cast<std::uintptr_t>(top) - 256) & ~std::uintptr_t{15};
#if defined(__SANITIZE_ADDRESS__)
  // The functions that are given up left their marks on what is used again.
  constexpr std::size_t kUsedAgain = 256 * 1024;
  __asan_unpoison_memory_region(static_cast<char*>(top) - kUsedAgain, kUsedAgain);
#endif
#if defined(__x86_64__)
  context.uc_mcontext.gregs[REG_RIP] = reinterpret_cast<greg_t>(&give_up);
  context.uc_mcontext.gregs[REG_RSP] = static_cast<greg_t>(stack - 8);  // as after a call
  context.uc_mcontext.gregs[REG_RBP] = 0;
  return true;
#elif defined(__aarch64__)
  context.uc_mcontext.pc = reinterpret_cast<std::uintptr_t>(&give_up);
  context.uc_mcontext.sp = stack;
  return true;
#else
  return false;
#endif
}

void say(const char* text) {
  // Nothing else is safe here; a message that cannot be written is lost.
  [[maybe_unused]] const auto written = write(STDERR_FILENO, text, std::strlen(text));
}

void on_crash(int signal, siginfo_t* info, void* context) {
  Robot* const robot = Robot::current();
  if (signal == kHang && flow.calls > 0) return;  // a call that takes long
  const bool is_safe = robot != nullptr && flow.stack_mark != nullptr && !robot->has_ended() &&
                       robot->may_be_stopped();
  if (is_safe && redirect(*static_cast<ucontext_t*>(context), flow.stack_mark)) {
    last_signal = signal;
    last_address = info->si_addr;
    return;
  }
  if (signal == kHang) return;
  if (robot != nullptr) {
    say("eyebridge: error: a robot's program crashed while it had the world: all robots end\n");
  }
  ::signal(signal, SIG_DFL);
  raise(signal);
}

}  // namespace

void handle_crashes() {
  struct sigaction action {};
  action.sa_sigaction = on_crash;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigemptyset(&action.sa_mask);
  for (const int signal : kCrashes) sigaction(signal, &action, nullptr);
  sigaction(kHang, &action, nullptr);
}

void interrupt_robot(unsigned long thread) { pthread_kill(thread, kHang); }

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
