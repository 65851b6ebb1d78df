#pragma once

#include <filesystem>

namespace eyebridge::robios {

// The interpreter that runs the robot program, if one does: eyebridge_host.h. Any thread.

/// The file of the robot program: what the interpreter said, else this process's executable.
std::filesystem::path program_file();

/// True when the interpreter is to be asked about Ctrl-C.
bool host_takes_interrupts();
/// Asks it: true when its own handler shall have the signal.
bool host_interrupted();
/// Tells it that the run ends.
void host_ending();

}  // namespace eyebridge::robios
