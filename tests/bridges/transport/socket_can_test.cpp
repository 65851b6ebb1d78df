#include "eyebridge/bridges/socket_can.hpp"

#include <cerrno>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/can.h>
#include <sys/socket.h>
#include <unistd.h>

#include "eyebridge/bridges/memory.hpp"
#include "frames.hpp"
#include "rigs.hpp"

namespace eyebridge::bridges::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

bool kernel_has_can() {
  return UniqueFd(::socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC, CAN_RAW)).valid();
}

TEST(SocketCan, OpeningWhatIsNotThereIsOneClearError) {
  MonotonicClock clock;
  const auto opened = open_socket_can({"can_none", false}, clock);
  ASSERT_FALSE(opened);
  if (kernel_has_can()) {
    EXPECT_EQ(opened.error().code, Errc::Disconnected);
    EXPECT_EQ(opened.error().what, "can_none: no such CAN interface: No such device");
  } else {
    EXPECT_EQ(opened.error().code, Errc::Unsupported);
    EXPECT_THAT(opened.error().what,
                AllOf(HasSubstr("can_none: this kernel has no CAN"), HasSubstr("97")));
  }
}

TEST(SocketCan, RefusesANameThatNoInterfaceHas) {
  MonotonicClock clock;
  for (const char* const name : {"", "sixteen_letters_"}) {
    const auto opened = open_socket_can({name, false}, clock);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().code, Errc::OutOfRange);
  }
}

TEST(SocketCan, WhatIsNoFrameIsCorrupt) {
  MonotonicClock clock;
  auto [near, far] = socket_pair(SOCK_SEQPACKET);
  const auto bus = make_socket_can({std::move(near), false}, "can0", clock);
  can_frame too_long{};
  too_long.len = 9;
  const char junk[100] = {};
  ASSERT_EQ(::write(far.get(), junk, 5), 5);
  ASSERT_EQ(::write(far.get(), junk, sizeof junk), 100);
  ASSERT_EQ(::write(far.get(), &too_long, sizeof too_long), 16);
  for (int i = 0; i < 3; ++i) {
    const auto got = bus->receive(clock.now() + kSoon);
    ASSERT_FALSE(got);
    EXPECT_EQ(got.error().code, Errc::Corrupt) << what(got);
  }
}

TEST(SocketCan, ReadsAndWritesTheKernelsLayout) {
  MonotonicClock clock;
  auto [near, far] = socket_pair(SOCK_SEQPACKET);
  const auto bus = make_socket_can({std::move(near), true}, "can0", clock);
  CanFrame frame = standard(0x12345, {0xAA, 0xBB});
  frame.extended = true;
  ASSERT_TRUE(bus->send(frame, clock.now() + kSoon));
  can_frame wire{};
  ASSERT_EQ(::read(far.get(), &wire, sizeof wire), static_cast<ssize_t>(CAN_MTU));
  EXPECT_EQ(wire.can_id, 0x12345U | CAN_EFF_FLAG);
  EXPECT_EQ(wire.len, 2);
  EXPECT_EQ(wire.data[1], 0xBB);

  canfd_frame fd{};
  fd.can_id = 0x123;
  fd.len = 64;
  fd.flags = CANFD_BRS;
  fd.data[63] = 7;
  ASSERT_EQ(::write(far.get(), &fd, sizeof fd), static_cast<ssize_t>(CANFD_MTU));
  const auto got = bus->receive(clock.now() + kSoon);
  ASSERT_TRUE(got) << what(got);
  EXPECT_TRUE(got->fd && got->bit_rate_switch && !got->error_state_indicator && !got->extended);
  EXPECT_EQ(got->length, 64);
  EXPECT_EQ(got->data[63], 7);
}

TEST(SocketCan, AClassicBusRefusesFdFrames) {
  MonotonicClock clock;
  auto [near, far] = socket_pair(SOCK_SEQPACKET);
  MemoryCan memory(clock, 8, false);
  const auto socket = make_socket_can({std::move(near), false}, "can0", clock);
  const auto node = memory.connect("node");
  CanFrame frame = standard(1, {});
  frame.fd = true;
  for (CanBus* const bus : {socket.get(), node.get()}) {
    const auto sent = bus->send(frame, kPast);
    ASSERT_FALSE(sent);
    EXPECT_EQ(sent.error().code, Errc::Unsupported);
  }
}

TEST(SocketCan, RefusesMoreFiltersThanTheKernelTakes) {
  MonotonicClock clock;
  auto [near, far] = socket_pair(SOCK_SEQPACKET);
  const auto bus = make_socket_can({std::move(near), false}, "can0", clock);
  const auto set = bus->set_filters(std::vector<CanFilter>(513));
  ASSERT_FALSE(set);
  EXPECT_EQ(set.error().code, Errc::OutOfRange);
}

TEST(SocketCan, ALossIsFinalWithoutAWayToReopen) {
  MonotonicClock clock;
  auto [near, far] = socket_pair(SOCK_SEQPACKET);
  const auto bus = make_socket_can({std::move(near), false}, "can0", clock);
  far.reset();
  for (int i = 0; i < 3; ++i) {
    const auto got = bus->receive(clock.now() + kSoon);
    ASSERT_FALSE(got);
    EXPECT_EQ(got.error().code, Errc::Disconnected);
  }
}

TEST(SocketCan, CountsReconnects) {
  MonotonicClock clock;
  auto [near, far] = socket_pair(SOCK_SEQPACKET);
  auto pair = socket_pair(SOCK_SEQPACKET);
  const auto bus =
      make_socket_can({std::move(near), false}, "can0", clock, [&pair](Time) -> Result<CanSocket> {
        return CanSocket{std::move(pair.first), true};
      });
  far.reset();
  EXPECT_FALSE(bus->receive(clock.now() + kSoon));
  CanFrame fd = standard(1, {});
  fd.fd = true;
  EXPECT_FALSE(bus->send(fd, kPast)) << "still what it was before: classic";
  ASSERT_TRUE(bus->send(standard(1, {}), kPast));
  EXPECT_TRUE(bus->send(fd, kPast)) << "the new socket takes CAN FD";
  EXPECT_EQ(bus->statistics().reconnects, 1u);
}

TEST(MemoryCan, ReachesAllOtherNodes) {
  MonotonicClock clock;
  MemoryCan memory(clock);
  const auto a = memory.connect("a");
  const auto b = memory.connect("b");
  const auto c = memory.connect("c");
  ASSERT_TRUE(a->send(standard(1, {7}), kPast));
  EXPECT_EQ(*b->receive(kPast), standard(1, {7}));
  EXPECT_EQ(*c->receive(kPast), standard(1, {7}));
  EXPECT_FALSE(a->receive(kPast));
}

TEST(MemoryCan, ALoneNodeWaitsForCompany) {
  MonotonicClock clock;
  MemoryCan memory(clock);
  const auto a = memory.connect("a");
  EXPECT_EQ(a->receive(kPast).error().code, Errc::Timeout);
  EXPECT_EQ(a->send(standard(1, {}), kPast).error().code, Errc::Timeout);
  {
    const auto b = memory.connect("b");
    EXPECT_TRUE(a->send(standard(1, {}), kPast));
  }
  EXPECT_EQ(a->send(standard(1, {}), kPast).error().code, Errc::Disconnected);
}

}  // namespace
}  // namespace eyebridge::bridges::testing
