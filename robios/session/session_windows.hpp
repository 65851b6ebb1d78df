#pragma once

#include "windows/open_windows.hpp"

namespace eyebridge::robios {

/// open_windows() for a process whose robots' programs this library runs: closing them ends
/// the process as Ctrl-C does.
Windows* open_session_windows(const hal::Config& config, LogSink& log);

}  // namespace eyebridge::robios
