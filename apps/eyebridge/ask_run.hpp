#pragma once

#include <sys/types.h>

#include "control_socket.hpp"

namespace eyebridge::apps {

/// Tells the run of process `wanted`, or this user's only run of several robots where that is 0,
/// what `command` wants, in `words`; prints the number it answers with, or why it will not. The
/// exit code. Throws ConfigError where there is no such run, or the words are too many.
int ask_run(const char* command, pid_t wanted, const robios::Words& words);

}  // namespace eyebridge::apps
