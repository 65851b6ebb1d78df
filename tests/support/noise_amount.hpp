#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>

namespace eyebridge::testing {

/// How many random bytes or frames a test may take: `usual`, or what EYEBRIDGE_TEST_NOISE says, as
/// ./test parity does for the project's measure. Throws when that is no number.
inline std::uint64_t noise_amount(std::uint64_t usual) {
  const char* const wanted = std::getenv("EYEBRIDGE_TEST_NOISE");
  return wanted == nullptr ? usual : std::stoull(wanted);
}

}  // namespace eyebridge::testing
