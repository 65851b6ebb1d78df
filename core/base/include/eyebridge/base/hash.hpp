#pragma once

#include <bit>
#include <cstdint>

namespace eyebridge {

/// A running 64-bit hash (FNV-1a, http://www.isthe.com/chongo/tech/comp/fnv) of a simulation's
/// state or a picture: pins determinism in tests and runs.
class StateHash {
 public:
  void add_byte(std::uint8_t byte) { hash_ = (hash_ ^ byte) * kPrime; }
  void add(std::uint64_t value) {
    for (int byte = 0; byte < 8; ++byte) add_byte(static_cast<std::uint8_t>(value >> (8 * byte)));
  }
  /// Adds the bits of `value`; 0.0 and -0.0 count as equal, and all NaNs.
  void add(double value) { add(bits_of(value)); }

  /// Bits of `value` that are the same on every CPU: 0.0 for -0.0, and one NaN for all of them
  /// (what x86-64 makes of 0.0 / 0.0 has its sign set, what arm64 makes has not).
  static std::uint64_t bits_of(double value) {
    if (value != value) return 0x7FF8000000000000U;
    return std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value);
  }

  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  static constexpr std::uint64_t kPrime = 0x100000001B3U;
  std::uint64_t hash_ = 0xCBF29CE484222325U;
};

}  // namespace eyebridge
