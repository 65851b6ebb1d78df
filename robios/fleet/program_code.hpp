#pragma once

namespace eyebridge::robios {

/// Where the code of robots' programs lies: in what was loaded after this process's own libraries.
///
/// A program that is ended in a function of the C library leaves locked what that has locked. So it
/// is ended in its own code: where it is elsewhere, the right to execute that is taken away, and it
/// faults when it comes back.
namespace program_code {

/// What is loaded now is this process's own. Before the first program.
void begin();
/// False where `address` is in a program, or in a library that came with one. For signal handlers,
/// too.
[[nodiscard]] bool is_own(const void* address);
/// Finds what programs have loaded: what bar() bars. One thread, in no handler.
void survey();
/// Nothing of it can be executed until unbar(). For signal handlers.
void bar();
void unbar();
/// True when code there was barred by bar(). Any thread.
[[nodiscard]] bool is_barred(const void* address);
[[nodiscard]] bool is_barred();

}  // namespace program_code
}  // namespace eyebridge::robios
