#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "eyebridge/base/result.hpp"

namespace eyebridge::robios::classic {

/// A sound in memory, as AUPlaySample() takes it.
struct Sample {
  int frequency = 0;               ///< Values a second.
  std::vector<std::uint8_t> wav;   ///< The same sound as a WAV file.
};

/// Bytes that must be there to tell how long a sample is.
inline constexpr std::size_t kSampleHead = 24;

/// How many bytes a sample has, by its first kSampleHead; at least that many. OutOfRange when they
/// are not those of a WAV, AU or SND file, or it has more than 16 MB. Pure.
Result<std::size_t> sample_size(std::span<const std::uint8_t> head);

/// Reads a sample: a WAV file, or an AU or SND file of one channel with 8 bits a value, linear or
/// mu-law. Fails with OutOfRange, saying what was found and expected. Pure.
Result<Sample> read_sample(std::span<const std::uint8_t> bytes);

}  // namespace eyebridge::robios::classic
