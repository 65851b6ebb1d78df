#pragma once

#include <sys/types.h>

#include "run_program.hpp"

namespace eyebridge::testing {

/// Starts a program with an empty standard input that writes to `out` and `err`; -1 when it cannot
/// be started. Any thread.
pid_t start_program(const ProgramStart& start, int out, int err);

}  // namespace eyebridge::testing
