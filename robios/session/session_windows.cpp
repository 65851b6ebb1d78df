#include "session_windows.hpp"

#include <signal.h>
#include <unistd.h>

#include "host.hpp"

namespace eyebridge::robios {

Windows* open_session_windows(const hal::Config& config, LogSink& log) {
  // Motors stop, results are written.
  const auto quit = [] { kill(getpid(), SIGTERM); };
  return open_windows(config, log, {quit, program_file().filename().string()});
}

}  // namespace eyebridge::robios
