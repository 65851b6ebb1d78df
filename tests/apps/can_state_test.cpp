#include "can_state.hpp"

#include <cerrno>

#include <gmock/gmock.h>

namespace eyebridge::apps {
namespace {

using testing::HasSubstr;

TEST(CanState, AKernelWithoutCanIsSentToTheLab) {
  const auto findings = judge_can({EAFNOSUPPORT, EAFNOSUPPORT, {}});
  ASSERT_EQ(findings.size(), 1u) << "nothing else can be there";
  EXPECT_FALSE(findings[0].found);
  EXPECT_THAT(findings[0].detail, HasSubstr("no CAN"));
  EXPECT_THAT(findings[0].detail, HasSubstr("errno 97"));
  EXPECT_THAT(findings[0].remedy, HasSubstr("eyebridge lab -- PROGRAM"));
}

TEST(CanState, CanWithoutIsoTpIsToldFromNoCan) {
  const auto findings = judge_can({0, EPROTONOSUPPORT, {{"can0", true}}});
  ASSERT_EQ(findings.size(), 3u);
  EXPECT_TRUE(findings[0].found);
  EXPECT_FALSE(findings[1].found);
  EXPECT_THAT(findings[1].detail, HasSubstr("no ISO-TP: Protocol not supported (errno 93)"));
  EXPECT_THAT(findings[1].remedy, HasSubstr("modprobe can_isotp"));
  EXPECT_TRUE(findings[2].found);
}

TEST(CanState, NoInterfaceIsToldFromBoth) {
  const auto findings = judge_can({0, 0, {}});
  ASSERT_EQ(findings.size(), 3u);
  EXPECT_TRUE(findings[0].found && findings[1].found);
  EXPECT_FALSE(findings[2].found);
  EXPECT_THAT(findings[2].detail, HasSubstr("errno 19"));
  EXPECT_THAT(findings[2].remedy, HasSubstr("ip link add vcan0 type vcan"));
}

TEST(CanState, AnInterfaceThatIsDownIsToldHowToComeUp) {
  const Finding real = judge_can({0, 0, {{"can0", false}}})[2];
  EXPECT_FALSE(real.found);
  EXPECT_EQ(real.detail, "can0 (down)");
  EXPECT_EQ(real.remedy, "as root: ip link set can0 up type can bitrate 500000");
  EXPECT_EQ(judge_can({0, 0, {{"vcan0", false}}})[2].remedy, "as root: ip link set vcan0 up");
  const Finding one_of_two = judge_can({0, 0, {{"can0", true}, {"can1", false}}})[2];
  EXPECT_TRUE(one_of_two.found);
  EXPECT_EQ(one_of_two.detail, "can0 can1 (down)");
}

TEST(CanState, WhatAContainerForbidsIsNoMissingKernelPart) {
  const Finding finding = judge_can({EPERM, EPERM, {}})[0];
  EXPECT_THAT(finding.detail, HasSubstr("errno 1"));
  EXPECT_THAT(finding.remedy, HasSubstr("container"));
}

TEST(CanState, LookingAtThisMachineAgreesWithItself) {
  const CanState state = look_at_can();
  if (state.raw_error == EAFNOSUPPORT) {
    EXPECT_EQ(state.isotp_error, EAFNOSUPPORT);
  }
  EXPECT_EQ(judge_can(state)[0].found, state.raw_error == 0);
}

}  // namespace
}  // namespace eyebridge::apps
