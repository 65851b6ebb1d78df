#include "crash_handler.hpp"

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <ctime>

#include <fmt/format.h>
#include <pthread.h>
#include <signal.h>
#include <sys/syscall.h>
#include <sys/ucontext.h>
#include <unistd.h>

#include "flow.hpp"
#include "library_locks.hpp"
#include "program_code.hpp"
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

bool robots_are_threads = false;
std::atomic<Robot*> broken = nullptr;
std::atomic<const Robot*> hanging = nullptr;  // for whom code is barred

void say(const char* text) {
  // Nothing else is safe here; a message that cannot be written is lost.
  [[maybe_unused]] const auto written = write(STDERR_FILENO, text, std::strlen(text));
}

// Nothing that takes memory: the calling thread's is locked for ever.
[[noreturn]] void end_run(Robot& robot, int code) {
  std::fflush(stdout);
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(),
                "eyebridge: robot %zu: error: the program crashed: %s, inside the C library; the "
                "others need what it had locked there: all robots end\n",
                robot.index() + 1, sigdescr_np(last_signal));
  say(text.data());
  robot.break_off(code);
  broken = &robot;
  constexpr unsigned kPatience_s = 8;  // whoever ends the run has less
  for (unsigned left = kPatience_s; left > 0;) left = sleep(left);
  _exit(code);
}

/// Where a robot's flow goes on after the handler, at the top of its stack.
[[noreturn]] void give_up() {
  Robot& robot = *Robot::current();
  const int code = last_signal == kHang ? 124 : 128 + last_signal;
  {
    const InCall in_call;  // what the C library has for us does not wait for turns
    library_locks::release_streams();
    if (!library_locks::are_free(robots_are_threads)) end_run(robot, code);
  }
  if (last_signal == kHang) {
    robot.fail("the program has made no call for too long and is ended; the others go on", code);
  }
  robot.crash(last_signal, last_address);
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

const void* program_counter(const ucontext_t& context) {
#if defined(__x86_64__)
  return reinterpret_cast<const void*>(context.uc_mcontext.gregs[REG_RIP]);
#elif defined(__aarch64__)
  return reinterpret_cast<const void*>(context.uc_mcontext.pc);
#else
  return nullptr;
#endif
}

/// The flow has come to code that is barred. True where it is that of the robot that is to end.
bool returns_to_end(const Robot* robot) {
  if (robot == nullptr) {  // a thread of a library that came with a program
    const timespec pause{0, 1'000'000};
    syscall(SYS_nanosleep, &pause, nullptr);
    return false;
  }
  program_code::unbar();  // whoever goes on was to end, or has let another one run
  return robot == hanging;
}

/// False where the flow goes on, to be interrupted again.
bool takes_interrupt(const Robot* robot, const ucontext_t& context) {
  if (flow.calls > 0) return false;  // a call that takes long
  if (robot == nullptr || !program_code::is_own(program_counter(context))) return true;
  hanging = robot;
  program_code::bar();
  return false;
}

void on_crash(int signal, siginfo_t* info, void* given) {
  const int error = errno;
  auto& context = *static_cast<ucontext_t*>(given);
  Robot* const robot = Robot::current();
  bool goes_on = false;
  if (signal == SIGSEGV && program_code::is_barred(program_counter(context))) {
    goes_on = !returns_to_end(robot);
    signal = kHang;
  } else if (signal == kHang) {
    goes_on = !takes_interrupt(robot, context);
  }
  errno = error;
  if (goes_on) return;
  const bool is_safe = robot != nullptr && flow.stack_mark != nullptr && !robot->has_ended() &&
                       robot->may_be_stopped();
  if (is_safe && flow.calls == 0 && signal != kHang &&
      robot->signals().divert(signal, *info, context)) {
    return;
  }
  if (is_safe && redirect(context, flow.stack_mark)) {
    last_signal = signal;
    last_address = info->si_addr;
    return;
  }
  if (signal == kHang) return;
  library_locks::end_trial();
  if (robot != nullptr) {
    say("eyebridge: error: a robot's program crashed while it had the world: all robots end\n");
  }
  ::signal(signal, SIG_DFL);
  raise(signal);
}

}  // namespace

void handle_crashes(bool are_threads) {
  robots_are_threads = are_threads;
  program_code::begin();
  library_locks::begin();
  struct sigaction action {};
  action.sa_sigaction = on_crash;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigemptyset(&action.sa_mask);
  for (const int signal : kCrashes) sigaction(signal, &action, nullptr);
  sigaction(kHang, &action, nullptr);
}

Robot* broken_robot() { return broken; }

void interrupt_robot(unsigned long thread) {
  program_code::survey();
  pthread_kill(thread, kHang);
}

bool is_outside_program() { return program_code::is_barred(); }

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
