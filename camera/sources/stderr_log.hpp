#pragma once

#include "eyebridge/base/log.hpp"

namespace eyebridge::camera {

/// `log`, or one that writes warnings and errors to standard error when it is null: none is
/// ever lost.
LogSink& log_or_stderr(LogSink* log);

}  // namespace eyebridge::camera
