#include "eyebridge/base/hash.hpp"

#include <bit>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

namespace eyebridge {
namespace {

std::uint64_t hash_of(double value) {
  StateHash hash;
  hash.add(value);
  return hash.value();
}

// Hidden from the compiler, which would compute 0 / 0 in its own way.
volatile double zero = 0.0;

TEST(StateHash, CountsEveryNaNAsTheSame) {
  constexpr double kQuiet = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(hash_of(zero / zero), hash_of(kQuiet)) << "the sign of 0 / 0 is the processor's choice";
  EXPECT_EQ(hash_of(-kQuiet), hash_of(kQuiet));
  EXPECT_EQ(hash_of(std::bit_cast<double>(std::uint64_t{0xFFF8000000000123U})), hash_of(kQuiet))
      << "so is what a NaN carries along";
  EXPECT_NE(hash_of(kQuiet), hash_of(std::numeric_limits<double>::infinity()));
}

TEST(StateHash, CountsBothZerosAsTheSame) {
  EXPECT_EQ(hash_of(-0.0), hash_of(0.0));
  EXPECT_NE(hash_of(std::numeric_limits<double>::denorm_min()), hash_of(0.0));
}

}  // namespace
}  // namespace eyebridge
