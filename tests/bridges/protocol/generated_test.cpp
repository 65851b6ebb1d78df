#include "eyebridge/bridges/can/generated.hpp"

#include <fstream>
#include <sstream>
#include <string>

#include <gmock/gmock.h>

#include "eyebridge/bridges/can/table.hpp"

namespace eyebridge::bridges::can {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string committed(const std::string& name) {
  std::ifstream file(EYEBRIDGE_SOURCE_DIR "/bridges/protocol/" + name, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

constexpr const char* kHowTo = "out of date: cmake --build --preset dev --target update_protocol";

TEST(Generated, TheCommittedFilesAreWhatTheTableGives) {
  EXPECT_EQ(committed("eyebridge.dbc"), write_dbc({})) << kHowTo;
  EXPECT_EQ(committed("eyebridge_fd.dbc"), write_dbc({.fd = true})) << kHowTo;
  EXPECT_EQ(committed("opcodes.h"), update_opcodes(committed("opcodes.h"))) << kHowTo;
  EXPECT_EQ(committed("SPECIFICATION.md"), update_specification(committed("SPECIFICATION.md")))
      << kHowTo;
}

TEST(Generated, WhatIsEditedByHandIsFoundBetweenTheMarkersOnly) {
  const std::string good = committed("opcodes.h");
  const auto edited = [&](const std::string& what, const std::string& by) {
    std::string text = good;
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
  };
  EXPECT_EQ(update_opcodes(edited("EYECAN_NMT_STOP 0x02", "EYECAN_NMT_STOP 0x03")), good);
  const std::string other = edited("IO7_HELP 'h'", "IO7_HELP 'H'");
  EXPECT_EQ(update_opcodes(other), other);
}

TEST(Generated, WithoutMarkersNothingIsWritten) {
  for (const auto& text : {update_opcodes("#endif\n"), update_specification("# Text\n")}) {
    ASSERT_FALSE(text);
    EXPECT_EQ(text.error().code, Errc::Corrupt);
    EXPECT_THAT(text.error().what, HasSubstr("make_protocol"));
  }
}

TEST(Generated, SignalsAreWrittenAsTheDbcFormatWantsThem) {
  EXPECT_THAT(
      write_dbc({}),
      AllOf(HasSubstr("BO_ 385 R1_S_Pose: 8 Robot1\n"),
            HasSubstr("BO_ 398 R14_S_Pose: 8 Robot14\n"),
            HasSubstr("BO_ 1807 Host_Heartbeat: 1 Host\n"), HasSubstr("BO_ 16 C_EStop: 2 Host\n"),
            HasSubstr(" SG_ Phi : 48|16@1- (0.01,0) [-327.68|327.67] \"deg\" Host\n"),
            HasSubstr(" SG_ Bank M : 0|8@1+ (1,0) [0|1] \"\" Robot1\n"),
            HasSubstr(" SG_ Servo14 m1 : 56|8@1+ (1,0) [0|255] \"\" Robot1\n"),
            HasSubstr("BA_ \"GenMsgCycleTime\" BO_ 385 20;\n"), Not(HasSubstr("R15_"))));
}

TEST(Generated, ADbcFileForToolsThatMaskTheNodeHasOneRobot) {
  EXPECT_THAT(write_dbc({.robots = 0}),
              AllOf(HasSubstr("BU_: Host Robot\n"), HasSubstr("BO_ 385 S_Pose: 8 Robot\n"),
                    HasSubstr("BO_ 17 C_EStop: 2 Host\n"), Not(HasSubstr("R1_"))));
}

TEST(Generated, EveryNumberThatASignalMayHaveIsNamedWhereOthersAreRefused) {
  int closed = 0;
  for (const MessageSpec& spec : messages()) {
    for (const Signal& signal : spec.signals) {
      if (signal.names == nullptr) continue;
      for (const Name& name : signal.names->names) {
        EXPECT_TRUE(signal.accepts(name.number)) << spec.name << "." << signal.name;
        EXPECT_FALSE(name.meaning.empty()) << spec.name << "." << signal.name << " " << name.name;
      }
      if (!signal.names->is_closed || spec.consistent != nullptr) continue;
      EXPECT_EQ(signal.last - signal.first + 1,
                static_cast<std::int64_t>(signal.names->names.size()))
          << spec.name << "." << signal.name;
      ++closed;
    }
  }
  EXPECT_EQ(closed, 4);
}

}  // namespace
}  // namespace eyebridge::bridges::can
