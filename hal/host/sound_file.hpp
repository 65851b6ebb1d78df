#pragma once

#include <string>

#include "host/sound_length.hpp"

namespace eyebridge::hal {

/// read_sound() of a file of at most 256 MB. OutOfRange when it cannot be read.
Result<SoundFacts> read_sound_file(const std::string& path);

/// OutOfRange for a tone that Sound excludes.
Result<void> check_tone(double frequency, double duration);

}  // namespace eyebridge::hal
