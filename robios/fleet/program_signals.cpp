#include "program_signals.hpp"

#include <algorithm>

#include "crash_handler.hpp"

namespace eyebridge::robios {
namespace {

constexpr std::array kOfRobot = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGINT, SIGTERM, SIGHUP};
constexpr std::array kHarmless = {SIGCHLD, SIGCONT, SIGURG,  SIGWINCH,
                                  SIGSTOP, SIGTSTP, SIGTTIN, SIGTTOU};

template <class Signals>
bool is_one_of(const Signals& signals, int signal) {
  return std::ranges::find(signals, signal) != signals.end();
}

void call(const struct sigaction& action, int signal, siginfo_t* info, void* context) {
  if ((action.sa_flags & SA_SIGINFO) != 0) {
    action.sa_sigaction(signal, info, context);
  } else {
    action.sa_handler(signal);
  }
}

bool has_function(const struct sigaction& action) {
  return action.sa_handler != SIG_DFL && action.sa_handler != SIG_IGN;
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
  if (has_function(mine)) let_program_handle(signal);
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

bool ProgramSignals::handle(int signal, siginfo_t* info, void* context) {
  const struct sigaction action = take(signal);
  if (!has_function(action)) return false;
  call(action, signal, info, context);
  return true;
}

}  // namespace eyebridge::robios
