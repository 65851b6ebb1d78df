#pragma once

#include <cstdint>
#include <span>

namespace eyebridge::bridges::dbc {

/// Bytes combined by exclusive or, from `start`.
std::uint8_t xor_of(std::span<const std::uint8_t> bytes, std::uint8_t start = 0);

/// CRC-8 SAE J1850: polynomial 0x1D, start 0xFF, inverted at the end. 0x4B for "123456789".
std::uint8_t sae_j1850(std::span<const std::uint8_t> bytes);

/// Which bytes of its data identifier an AUTOSAR E2E profile 1 message has in its CRC.
enum class DataIdMode {
  Both,         ///< The low byte, then the high one.
  Alternating,  ///< The low one with an even counter, the high one with an odd counter.
  Low,          ///< The low one.
  Nibble,       ///< The low one, then 0: a nibble of the high one is sent in the frame.
};

/// The counter of AUTOSAR E2E profile 1 runs from 0 to here and starts again; 15 means invalid.
inline constexpr std::uint8_t kProfile1LastCounter = 14;

/// CRC of AUTOSAR E2E profile 1: polynomial 0x1D, start 0, not inverted, over the data identifier
/// and all of `bytes` but that at `crc_at`, which is less than bytes.size().
std::uint8_t autosar_profile1(std::uint16_t data_id, DataIdMode mode, std::uint8_t counter,
                              std::span<const std::uint8_t> bytes, std::size_t crc_at);

}  // namespace eyebridge::bridges::dbc
