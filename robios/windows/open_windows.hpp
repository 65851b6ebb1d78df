#pragma once

#include "eyebridge/base/log.hpp"
#include "eyebridge/hal/config.hpp"
#include "windows/windows.hpp"

namespace eyebridge::robios {

/// The windows of this process, opened with the first call; null where `config` does not ask for
/// them, nor leaves it to us and there is a display, and where there are none and nobody insists,
/// which the log tells as Info. Throws ConfigError where `gui` is on and they cannot be. Later
/// calls give what the first one did.
Windows* open_windows(const hal::Config& config, LogSink& log, WindowsStart start);

/// Opens the window on a world, paused if that wants to begin so; once.
void show_world(Windows& windows, hal::Environment& environment, Crew* crew = nullptr);

/// Where there are no windows: the log says that this world's wish to begin so is ignored.
void tell_of_ignored_pause(const hal::Environment& environment, LogSink& log);

}  // namespace eyebridge::robios
