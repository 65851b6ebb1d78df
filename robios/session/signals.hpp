#pragma once

namespace eyebridge::robios {

/// Calls `stop(signal)` from a thread of its own when SIGINT, SIGTERM or SIGHUP arrives, then lets
/// the signal end the process as it would have. Signals that the program handles itself are left to
/// it; an interpreter's handler of SIGINT is put in front of, and the interpreter asked each time
/// (host.hpp). The same thread calls `look` ten times a second. Called once.
void watch_signals(void (*stop)(int signal), void (*look)());

/// For the child of a fork(), where nobody waits for them: signals do again what they did before.
void leave_signals_alone();

}  // namespace eyebridge::robios
