#pragma once

#include <cstdint>
#include <vector>

namespace eyebridge::hal {

/// A sine of `frequency` hertz for `duration` seconds as a WAV file: 44100 samples of 16 bits a
/// second, one channel, at a third of full volume, its ends faded over 5 ms.
std::vector<std::uint8_t> make_tone(double frequency, double duration);

}  // namespace eyebridge::hal
