#pragma once

namespace eyebridge::bridges {

/// All that the guard does. Its descriptors: 0 the program's words, 1 the program (a pidfd), 2
/// standard error. Uses system calls only.
[[noreturn]] void run_guard(const void* unused);

}  // namespace eyebridge::bridges
