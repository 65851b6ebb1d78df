#include "program_signals.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>

#include <ucontext.h>

#include "robot.hpp"

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/asan_interface.h>
#endif

namespace eyebridge::robios {
namespace {

constexpr std::array kOfRobot = {SIGSEGV, SIGBUS,  SIGFPE, SIGILL, SIGABRT,
                                 SIGINT,  SIGTERM, SIGHUP, SIGURG};
constexpr std::array kHarmless = {SIGCHLD, SIGCONT, SIGURG,  SIGWINCH,
                                  SIGSTOP, SIGTSTP, SIGTTIN, SIGTTOU};

template <class Signals>
bool is_one_of(const Signals& signals, int signal) {
  return std::ranges::find(signals, signal) != signals.end();
}

/// What a handler is called with; it lies on the program's stack.
struct Delivery {
  struct sigaction action;
  int signal;
  siginfo_t info;
  ucontext_t context;
};

void call(const struct sigaction& action, int signal, siginfo_t* info, void* context) {
  if ((action.sa_flags & SA_SIGINFO) != 0) {
    action.sa_sigaction(signal, info, context);
  } else {
    action.sa_handler(signal);
  }
}

/// Where the program goes on.
[[noreturn]] void deliver(Delivery* given) {
  call(given->action, given->signal, &given->info, &given->context);
  // It would do the same again, and again.
  Robot::current()->crash(given->signal, given->info.si_addr);
}

bool has_function(const struct sigaction& action) {
  return action.sa_handler != SIG_DFL && action.sa_handler != SIG_IGN;
}

/// Room below what the program uses of its stack; null when it has no more.
Delivery* room_below(std::uintptr_t stack, int signal, const void* address) {
  constexpr std::uintptr_t kRedZone = 128;  // System V ABI of x86-64: used without a word
  constexpr std::uintptr_t kNear = 1U << 20U;
  // It crashed because there is no more.
  const auto where = reinterpret_cast<std::uintptr_t>(address);
  if (signal == SIGSEGV && where > stack - kNear && where < stack + kNear) return nullptr;
  return reinterpret_cast<Delivery*>((stack - kRedZone - sizeof(Delivery)) & ~std::uintptr_t{63});
}

}  // namespace

bool ProgramSignals::set(int signal, const struct sigaction* action, struct sigaction* before) {
  Table* table = table_;
  if (table == nullptr) {
    auto* const made = new Table{};
    if (table_.compare_exchange_strong(table, made)) {
      table = made;
    } else {
      delete made;
    }
  }
  struct sigaction& mine = (*table)[static_cast<std::size_t>(signal)];
  const struct sigaction old = mine;
  if (action != nullptr) mine = *action;
  if (before != nullptr) *before = old;
  return is_one_of(kOfRobot, signal);
}

struct sigaction ProgramSignals::take(int signal) {
  Table* const table = table_;
  if (table == nullptr) return {};
  struct sigaction& mine = (*table)[static_cast<std::size_t>(signal)];
  const struct sigaction taken = mine;
  if ((taken.sa_flags & static_cast<int>(SA_RESETHAND)) != 0) mine = {};
  return taken;
}

bool ProgramSignals::raise(int signal) {
  const struct sigaction action = take(signal);
  if (action.sa_handler == SIG_IGN) return true;
  if (!has_function(action)) return false;
  siginfo_t info{};
  info.si_signo = signal;
  info.si_code = SI_TKILL;
  ucontext_t context{};
  call(action, signal, &info, &context);
  return true;
}

bool ProgramSignals::is_harmless(int signal) { return is_one_of(kHarmless, signal); }

bool ProgramSignals::divert(int signal, const siginfo_t& info, ucontext_t& context) {
  if (!is_one_of(kOfRobot, signal) || signal == SIGURG) return false;
#if defined(__x86_64__)
  const auto stack = static_cast<std::uintptr_t>(context.uc_mcontext.gregs[REG_RSP]);
#elif defined(__aarch64__)
  const auto stack = static_cast<std::uintptr_t>(context.uc_mcontext.sp);
#else
  const std::uintptr_t stack = 0;
  return false;
#endif
  Delivery* const room = room_below(stack, signal, info.si_addr);
  if (room == nullptr) return false;
  const struct sigaction action = take(signal);
  if (!has_function(action)) return false;
#if defined(__SANITIZE_ADDRESS__)
  constexpr std::size_t kUsedNext = 64 * 1024;
  __asan_unpoison_memory_region(reinterpret_cast<char*>(stack) - kUsedNext, kUsedNext);
#endif
  new (room) Delivery{action, signal, info, context};
#if defined(__x86_64__)
  context.uc_mcontext.gregs[REG_RIP] = reinterpret_cast<greg_t>(&deliver);
  context.uc_mcontext.gregs[REG_RDI] = reinterpret_cast<greg_t>(room);
  context.uc_mcontext.gregs[REG_RSP] = reinterpret_cast<greg_t>(room) - 8;  // as after a call
  context.uc_mcontext.gregs[REG_RBP] = 0;
#elif defined(__aarch64__)
  context.uc_mcontext.pc = reinterpret_cast<std::uintptr_t>(&deliver);
  context.uc_mcontext.regs[0] = reinterpret_cast<std::uintptr_t>(room);
  context.uc_mcontext.sp = reinterpret_cast<std::uintptr_t>(room);
#endif
  return true;
}

}  // namespace eyebridge::robios
