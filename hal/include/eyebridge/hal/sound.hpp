#pragma once

#include <string>

#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/device.hpp"

namespace eyebridge::hal {

/// The loudspeaker of a robot. In virtual time nothing is heard: a sound takes its length on the
/// robot's clock.
///
/// The backend owns it; any thread. A new sound begins beside the one that still plays.
class Sound : public Device {
 public:
  /// Plays `frequency` hertz, 20 … 20000, for `duration` seconds, more than 0, at most 60; returns
  /// at once. Unsupported where there is no player.
  virtual Result<void> tone(double frequency, double duration) = 0;
  /// Plays a sound file (WAV or MP3); returns at once. OutOfRange when there is no such file;
  /// Unsupported when nothing here can play it.
  virtual Result<void> play(const std::string& path) = 0;
  /// Whether the last sound has not ended yet.
  virtual Result<bool> is_playing() = 0;
};

}  // namespace eyebridge::hal
