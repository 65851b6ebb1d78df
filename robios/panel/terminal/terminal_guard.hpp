#pragma once

#include <termios.h>

namespace eyebridge::robios {

/// No more reports of the mouse (XTerm Control Sequences, modes 1000 and 1006).
inline constexpr char kMouseOff[] = "\x1b[?1006l\x1b[?1000l";

/// What leaves the panel on the screen and the cursor in the line below it: attributes reset, the
/// scrolling region gone (ECMA-48 SGR, DECSTBM, CUP).
inline constexpr char kLeavePanel[] = "\x1b[0m\x1b[r\x1b[999;1H\r\n";

/// Starts a process that puts the terminal back when this one ends without having done so itself:
/// kill -9, _exit(). It is no child that wait() would find, and in no process group of the shell's.
/// The first call counts, later ones do nothing. `before` is the mode to go back to; null: the
/// present one. Where no process can be had there is no guard.
void guard_terminal(int descriptor, const termios* before) noexcept;

/// Tells it whether there is anything to put back. Async-signal-safe.
void tell_guard(bool switched) noexcept;

}  // namespace eyebridge::robios
