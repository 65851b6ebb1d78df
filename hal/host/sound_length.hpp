#pragma once

#include <cstdint>
#include <span>

#include "eyebridge/base/result.hpp"

namespace eyebridge::hal {

enum class SoundFormat { Wav, Mp3 };

/// What can be known of a sound without playing it.
struct SoundFacts {
  SoundFormat format{};
  double length = 0.0;  ///< Seconds.
};

/// Reads a WAV file (RIFF, any format of fixed rate: the chunks "fmt " and "data") or an MP3 file
/// (MPEG 1, 2 or 2.5, layer III: the sum of its frames, after an ID3v2 tag; what is damaged
/// between frames is skipped). Fails with Unsupported for anything else.
Result<SoundFacts> read_sound(std::span<const std::uint8_t> bytes);

}  // namespace eyebridge::hal
