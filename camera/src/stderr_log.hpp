#pragma once

#include "eyebridge/base/log.hpp"

namespace eyebridge::camera {

/// `log`, or one that writes to standard error when it is null: a warning is never lost.
LogSink& log_or_stderr(LogSink* log);

}  // namespace eyebridge::camera
