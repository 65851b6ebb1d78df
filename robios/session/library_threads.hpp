#pragma once

namespace eyebridge::robios {

/// True when main() has left by pthread_exit() and every thread of the program has ended since:
/// only threads of the library are left, and nobody but them keeps the process alive.
///
/// Programs end that way while workers go on; threads of ours must not make them immortal. Threads
/// of ours are told by their names, which begin with kLibraryThread; those of libraries below
/// (Mesa) by names of their own and by blocking every signal, which no thread of a program does.
bool only_library_threads_left();

/// True when main() has left by pthread_exit().
bool main_thread_has_left();

/// How the name of every thread of the library begins (pthread_setname_np).
inline constexpr char kLibraryThread[] = "eb:";

}  // namespace eyebridge::robios
