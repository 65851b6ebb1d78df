// same_bits.c as a program of this computer and as one of the Cortex-M3.
#include <gmock/gmock.h>

#include "run_program.hpp"

namespace eyebridge::mps2 {
namespace {

TEST(CortexSameBits, MovesAndOdometryAreThoseOfThisProcessorToTheBit) {
  const auto here = testing::run_program({{EYEBRIDGE_SAME_BITS}, {}, {}});
  ASSERT_EQ(here.exit_code, 0) << here.err;
  EXPECT_THAT(here.out, ::testing::HasSubstr("seed 5\t54fe94773e8f914b\n"));
  const auto there = testing::run_program(
      {{"qemu-system-arm", "-machine", "mps2-an385", "-kernel", EYEBRIDGE_SAME_BITS_ELF,
        "-no-user-config", "-nodefaults", "-display", "none", "-monitor", "none", "-nic",
        "user,restrict=on", "-semihosting-config", "enable=on,target=native"},
       {},
       {}});
  // What a program prints by semihosting goes to the emulator's standard error.
  EXPECT_EQ(there.out + there.err, here.out);
}

}  // namespace
}  // namespace eyebridge::mps2
