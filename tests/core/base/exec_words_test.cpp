#include "eyebridge/base/exec_words.hpp"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eyebridge {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Not;
using ::testing::StartsWith;

TEST(ExecWords, ChangesReplaceAndAddVariables) {
  setenv("EYEBRIDGE_TEST_KEPT", "1", 1);
  setenv("EYEBRIDGE_TEST_REPLACED", "old", 1);
  const auto words =
      environment_with({{"EYEBRIDGE_TEST_REPLACED", "new=2"}, {"EYEBRIDGE_TEST_ADDED", ""}});
  EXPECT_THAT(words, Contains("EYEBRIDGE_TEST_KEPT=1"));
  EXPECT_THAT(words, Contains("EYEBRIDGE_TEST_REPLACED=new=2"));
  EXPECT_THAT(words, Not(Contains(StartsWith("EYEBRIDGE_TEST_REPLACED=old"))));
  EXPECT_THAT(words, Contains("EYEBRIDGE_TEST_ADDED="));
}

TEST(ExecWords, PointersEndWithNull) {
  const std::vector<std::string> words = {"one", ""};
  const std::vector<char*> pointers = pointers_to(words);
  EXPECT_THAT(pointers, ElementsAre(words[0].data(), words[1].data(), nullptr));
}

}  // namespace
}  // namespace eyebridge
