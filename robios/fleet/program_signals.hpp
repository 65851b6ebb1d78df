#pragma once

#include <array>
#include <atomic>

#include <signal.h>

namespace eyebridge::robios {

/// The signal handlers that one robot's program has set. Any thread.
///
/// What ends the run (Ctrl-C) never gets past here. For other signals from outside the process, the
/// handler that was set last is called, whichever robot set it.
class ProgramSignals {
 public:
  /// As sigaction(): true when the signal is the robot's alone.
  bool set(int signal, const struct sigaction* action, struct sigaction* before);
  /// raise() in the program: calls its handler. False when it has none: then the program ends, but
  /// where is_harmless().
  bool raise(int signal);
  /// True when a signal without a handler ends no program.
  static bool is_harmless(int signal);

  /// In the handler of a crash: calls the program's. False when it has none.
  bool handle(int signal, siginfo_t* info, void* context);

 private:
  using Table = std::array<struct sigaction, NSIG>;
  /// The program's handler of a signal; SIG_DFL at first. A handler that is for one time is gone
  /// then.
  struct sigaction take(int signal);

  std::atomic<Table*> table_ = nullptr;  ///< Of those few that set one; never destroyed.
};

}  // namespace eyebridge::robios
