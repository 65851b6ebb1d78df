#pragma once

namespace eyebridge::camera {

/// Sets what the renderer's libraries read from the environment of the process (LP_NUM_THREADS,
/// unless it is set already: Mesa shall draw in the thread that asks).
///
/// To be called before the process has other threads: setenv() may move the environment while they
/// are in getenv(). Every call but the first does nothing. Who opens a renderer without having
/// called it gets it done then, which is safe only as long as no other thread asks for variables.
void prepare_process();

}  // namespace eyebridge::camera
