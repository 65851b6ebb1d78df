#include "eyebridge/bridges/can/dbc.hpp"

#include <fstream>
#include <sstream>
#include <string>

#include <gmock/gmock.h>

namespace eyebridge::bridges::can {
namespace {

std::string committed(const std::string& name) {
  std::ifstream file(EYEBRIDGE_SOURCE_DIR "/bridges/protocol/" + name, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

constexpr const char* kHowTo = "out of date: cmake --build --preset dev --target update_dbc";

TEST(Dbc, TheCommittedFilesAreWhatTheTableGives) {
  EXPECT_EQ(committed("eyebridge.dbc"), write_dbc({})) << kHowTo;
  EXPECT_EQ(committed("eyebridge_fd.dbc"), write_dbc({.fd = true})) << kHowTo;
}

TEST(Dbc, SignalsAreWrittenAsTheFormatWantsThem) {
  EXPECT_THAT(
      write_dbc({}),
      testing::AllOf(
          testing::HasSubstr("BO_ 385 S_Pose: 8 Robot\n"),
          testing::HasSubstr(" SG_ Phi : 48|16@1- (0.01,0) [-327.68|327.67] \"deg\" Host\n"),
          testing::HasSubstr(" SG_ Bank M : 0|8@1+ (1,0) [0|1] \"\" Robot\n"),
          testing::HasSubstr(" SG_ Servo14 m1 : 56|8@1+ (1,0) [0|255] \"\" Robot\n"),
          testing::HasSubstr("BA_ \"GenMsgCycleTime\" BO_ 385 20;\n")));
}

TEST(Dbc, ManyRobotsHaveTheirOwnNamesAndTheHostItsHeartbeat) {
  const std::string text = write_dbc({.robots = 14});
  EXPECT_THAT(text, testing::AllOf(testing::HasSubstr("BO_ 398 R14_S_Pose: 8 Robot14\n"),
                                   testing::HasSubstr("BO_ 385 R1_S_Pose: 8 Robot1\n"),
                                   testing::HasSubstr("BO_ 1807 Host_Heartbeat: 1 Host\n"),
                                   testing::HasSubstr("BO_ 16 C_EStop: 2 Host\n")));
  EXPECT_EQ(text.find("R15_"), std::string::npos);
}

}  // namespace
}  // namespace eyebridge::bridges::can
