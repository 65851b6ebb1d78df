#pragma once

#include <string>

#include "eyebridge/base/result.hpp"

namespace eyebridge::hal {

/// How long a sound file (WAV or MP3, at most 256 MB) plays, seconds. OutOfRange when it cannot be
/// read, Unsupported for another format. Any thread.
Result<double> sound_length(const std::string& path);

}  // namespace eyebridge::hal
