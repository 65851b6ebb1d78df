#include "eyebridge/camera/prepare_process.hpp"

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

namespace eyebridge::camera::testing {
namespace {

TEST(PrepareProcess, SetsWhatMesaReadsOnceAndLeavesItAloneThen) {
  prepare_process();
  const char* set = std::getenv("LP_NUM_THREADS");
  ASSERT_NE(set, nullptr);
  const std::string before = set;
  setenv("LP_NUM_THREADS", "3", /*overwrite=*/1);
  prepare_process();
  EXPECT_STREQ(std::getenv("LP_NUM_THREADS"), "3");
  unsetenv("LP_NUM_THREADS");
  prepare_process();
  EXPECT_EQ(std::getenv("LP_NUM_THREADS"), nullptr);
  setenv("LP_NUM_THREADS", before.c_str(), /*overwrite=*/1);
}

}  // namespace
}  // namespace eyebridge::camera::testing
