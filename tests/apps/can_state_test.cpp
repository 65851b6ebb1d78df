#include "machine/can_state.hpp"

#include <cerrno>

#include <gmock/gmock.h>

#include "fake_machine.hpp"

namespace eyebridge::apps {
namespace {

using eyebridge::testing::FakeMachine;
using ::testing::HasSubstr;

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

TEST(CanState, InterfacesAreThoseOfTypeCanBelowARoot) {
  const FakeMachine machine;
  machine.add_can("can0", true, 10, 16);
  machine.add_can("can1", false, 1000, 72);
  machine.file("/sys/class/net/eth0/type", "1\n");
  CanLink link;
  link.name = "can1";
  link.bit_rate = 250'000;
  const auto interfaces = can_interfaces(machine.root(), {link});
  ASSERT_EQ(interfaces.size(), 2u);
  EXPECT_TRUE(interfaces[0].up);
  EXPECT_EQ(interfaces[0].queue, 10);
  EXPECT_FALSE(interfaces[0].takes_fd);
  EXPECT_FALSE(interfaces[0].link);
  EXPECT_FALSE(interfaces[1].up);
  EXPECT_TRUE(interfaces[1].takes_fd);
  ASSERT_TRUE(interfaces[1].link);
  EXPECT_EQ(interfaces[1].link->bit_rate, 250'000u);
}

/// An adapter that is up, with a driver that tells `link`.
Finding judged(CanLink link, long queue = 1000) {
  link.name = "can0";
  link.kind = "can";
  return judge_can({0, 0, {{"can0", true, queue, false, link}}}).back();
}

TEST(CanState, AHealthyAdapterGetsNoAdvice) {
  CanLink link;
  link.state = BusState::ErrorActive;
  link.bit_rate = 500'000;
  link.restart_ms = 100;
  const Finding finding = judged(link);
  EXPECT_TRUE(finding.found);
  EXPECT_EQ(finding.detail, "500 kbit/s, error-active, classic CAN, queue of 1000");
  EXPECT_THAT(finding.advice, ::testing::IsEmpty());
}

TEST(CanState, AnErrorPassiveBusGetsHintsAboutRateAndTermination) {
  CanLink link;
  link.state = BusState::ErrorPassive;
  link.send_errors = 128;
  link.receive_errors = 0;
  const Finding finding = judged(link);
  EXPECT_TRUE(finding.found);
  EXPECT_THAT(finding.detail, HasSubstr("error-passive, error counters 128 out, 0 in"));
  EXPECT_THAT(finding.advice,
              ::testing::Contains(::testing::AllOf(HasSubstr("bit rate"), HasSubstr("120 ohm"))));
}

TEST(CanState, BusOffIsNoWorkingInterface) {
  CanLink link;
  link.state = BusState::BusOff;
  link.restart_ms = 0;
  const Finding finding = judged(link);
  EXPECT_FALSE(finding.found);
  EXPECT_THAT(finding.remedy, HasSubstr("ip link set can0 type can restart"));
  EXPECT_THAT(finding.advice, ::testing::Contains(HasSubstr("restart-ms 100")));
}

TEST(CanState, AShortQueueAndAnOpenEndAndListeningOnlyAreToldWithWhatToDo) {
  CanLink link;
  link.listen_only = true;
  link.termination_ohm = 0;
  const Finding finding = judged(link, 10);
  EXPECT_THAT(finding.advice, ::testing::Contains(HasSubstr("ip link set can0 txqueuelen 1000")));
  EXPECT_THAT(finding.advice, ::testing::Contains(HasSubstr("listen-only off")));
  EXPECT_THAT(finding.advice, ::testing::Contains(HasSubstr("termination is off")));
}

TEST(CanState, AVirtualInterfaceNeedsNoBitRateAndNoQueue) {
  CanLink link;
  link.name = "vcan0";
  link.kind = "vcan";
  const Finding finding = judge_can({0, 0, {{"vcan0", true, 10, true, link}}}).back();
  EXPECT_EQ(finding.detail, "virtual, no wire, CAN FD, queue of 10");
  EXPECT_THAT(finding.advice, ::testing::IsEmpty());
}

TEST(CanState, WhatStandsInTheWayOfAnInterfaceIsToldApart) {
  EXPECT_THAT(why_no_can({EAFNOSUPPORT, EAFNOSUPPORT, {}}, "can0"), HasSubstr("errno 97"));
  EXPECT_THAT(why_no_can({EPROTONOSUPPORT, 0, {}}, "can0"), HasSubstr("errno 93"));
  EXPECT_THAT(why_no_can({0, 0, {}}, "can0"), HasSubstr("errno 19"));
  const CanState others{0, 0, {{"can1", true}, {"can2", false}}};
  EXPECT_THAT(why_no_can(others, "can0"), HasSubstr("expected one of can1, can2"));
  EXPECT_THAT(why_no_can(others, "can2"),
              HasSubstr("down; as root: ip link set can2 up type can bitrate 500000"));
  EXPECT_EQ(why_no_can(others, "can1"), "");
}

}  // namespace
}  // namespace eyebridge::apps
