#pragma once

namespace eyebridge::robios {

// The modes of the process's terminal while a program runs: keys without Enter and without echo,
// mouse reports, the panel. Process-wide, because a terminal's modes are, and because signal
// handlers have to reach them. Whatever was switched is switched back: at exit() keys by
// themselves, the panel by release_terminal(); by SIGINT, SIGTERM, SIGHUP, SIGQUIT and the signals
// of crashes unless the process handles these itself; when the process is stopped (SIGTSTP); and,
// for what no process can catch (kill -9, _exit()), by a process of its own that waits for this
// one's end.

/// Takes keys without Enter and without echo from now on, and, with `mouse`, reports of clicks.
/// Does nothing if it is so already, or after release_terminal().
void switch_to_keys(int descriptor, bool mouse);

/// Takes back what switch_to_keys() did.
void restore_keys() noexcept;

/// Announces that the panel is about to be shown. False after release_terminal(): nothing must be
/// written any more.
bool switch_to_panel(int descriptor);

/// How often the modes were taken back because the process was stopped; whoever showed something
/// has to begin anew when this has changed.
int terminal_interruptions();

/// Puts the terminal back as it was found, below the panel; nothing if it is. Async-signal-safe:
/// for signal handlers. Children of a fork() leave it alone.
void restore_terminal() noexcept;

/// As restore_terminal(), for good: nothing is switched any more, even when a thread of the program
/// still waits for a key while the process ends. Any thread.
void release_terminal() noexcept;

/// Touching one's terminal from the background would stop the process, or disturb whoever has it.
bool in_background(int descriptor);

}  // namespace eyebridge::robios
