#include "eyebridge/base/config_error.hpp"

#include <gtest/gtest.h>

namespace eyebridge {
namespace {

TEST(ConfigError, SaysFileLineAndColumn) {
  const ConfigError error({"maze.maz", 14, 7}, "wall ends outside the map");
  EXPECT_STREQ(error.what(), "maze.maz:14:7: wall ends outside the map");
  EXPECT_EQ(error.text(), "wall ends outside the map");
}

TEST(ConfigError, LeavesOutWhatIsNotKnown) {
  EXPECT_STREQ(ConfigError({"--hal", 0, 0}, "no backend 'simm'").what(),
               "--hal: no backend 'simm'");
  EXPECT_STREQ(ConfigError({"a.wld", 3, 0}, "x").what(), "a.wld:3: x");
  EXPECT_STREQ(ConfigError({}, "x").what(), "x");
}

TEST(Warning, NamesItself) {
  EXPECT_EQ((Warning{{"a.maz", 2, 4}, "'|' off the grid"}).str(),
            "a.maz:2:4: warning: '|' off the grid");
}

}  // namespace
}  // namespace eyebridge
