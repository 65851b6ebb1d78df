#pragma once

namespace eyebridge::robios {

/// Calls `stop(signal)` from a thread of its own when SIGINT, SIGTERM or SIGHUP arrives, then lets
/// the signal end the process as it would have. Signals that the program handles itself are left to
/// it. The same thread ends the process when only_library_threads_left(). Called once.
void watch_signals(void (*stop)(int signal));

}  // namespace eyebridge::robios
