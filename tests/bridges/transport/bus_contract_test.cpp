#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/can/error.h>

#include "frames.hpp"
#include "rigs.hpp"

namespace eyebridge::bridges::testing {
namespace {

/// What every kind of CAN bus does.
class BusContract : public ::testing::TestWithParam<BusCase> {
 protected:
  Time soon() const { return rig_.clock->now() + kSoon; }
  void expect_arrives(CanBus& from, CanBus& to, const CanFrame& frame) {
    const auto sent = from.send(frame, soon());
    ASSERT_TRUE(sent) << what(sent);
    const auto got = to.receive(soon());
    ASSERT_TRUE(got) << what(got);
    EXPECT_EQ(*got, frame);
  }

  BusRig rig_ = GetParam().make(GetParam().name);
  CanBus& near_ = *rig_.near;
};

TEST_P(BusContract, CarriesFramesOfAllKindsWhole) {
  for (const CanFrame& frame : frames_of_all_kinds()) {
    expect_arrives(near_, *rig_.far, frame);
    expect_arrives(*rig_.far, near_, frame);
  }
}

TEST_P(BusContract, CarriesAllByteValues) {
  for (unsigned value = 0; value < 256; value += 8) {
    CanFrame frame = standard(0x123, {});
    for (unsigned i = 0; i < 8; ++i) frame.data[i] = static_cast<std::uint8_t>(value + i);
    frame.length = 8;
    expect_arrives(near_, *rig_.far, frame);
  }
}

TEST_P(BusContract, ANodeDoesNotHearItself) {
  ASSERT_TRUE(near_.send(standard(1, {1}), soon()));
  ASSERT_TRUE(rig_.far->receive(soon()));
  const auto got = near_.receive(kPast);
  ASSERT_FALSE(got);
  EXPECT_EQ(got.error().code, Errc::Timeout);
}

TEST_P(BusContract, ReceivingNothingTimesOut) {
  for (const Time wait : {Time{0}, Time(std::chrono::milliseconds(2))}) {
    const Time deadline = rig_.clock->now() + wait;
    const auto got = near_.receive(deadline);
    ASSERT_FALSE(got);
    EXPECT_EQ(got.error().code, Errc::Timeout);
    EXPECT_GE(rig_.clock->now(), deadline);
  }
}

TEST_P(BusContract, RefusesWhatNoControllerCanSend) {
  for (const CanFrame& frame : impossible_frames()) {
    const auto sent = near_.send(frame, soon());
    ASSERT_FALSE(sent) << "id " << frame.id << ", length " << int{frame.length};
    EXPECT_EQ(sent.error().code, Errc::OutOfRange);
  }
  EXPECT_EQ(near_.statistics().sent, 0u);
  EXPECT_FALSE(rig_.far->receive(kPast));
}

TEST_P(BusContract, FiltersLetThroughWhatAgreesInTheMask) {
  const CanFilter filters[] = {{0x180, 0x7F0, false}, {0x00000181, 0x1FFFFFFF, true}};
  ASSERT_TRUE(near_.set_filters(filters));
  CanFrame remote = standard(0x181, {});
  remote.remote = true;
  CanFrame long_id = standard(0x181, {2});
  long_id.extended = true;
  CanFrame other_long_id = long_id;
  other_long_id.id = 0x182;
  for (const CanFrame& frame :
       {standard(0x190, {0}), remote, other_long_id, standard(0x18E, {1}), long_id}) {
    ASSERT_TRUE(rig_.far->send(frame, soon()));
  }
  EXPECT_EQ(near_.receive(soon())->id, 0x18Eu);
  EXPECT_EQ(*near_.receive(soon()), long_id);
  EXPECT_FALSE(near_.receive(kPast));

  ASSERT_TRUE(near_.set_filters({}));
  expect_arrives(*rig_.far, near_, remote);
}

TEST_P(BusContract, CountsWhatPasses) {
  for (int i = 0; i < 3; ++i) expect_arrives(near_, *rig_.far, standard(1, {1}));
  expect_arrives(*rig_.far, near_, standard(2, {}));
  EXPECT_EQ(near_.statistics(), (CanStatistics{.sent = 3, .received = 1}));
}

TEST_P(BusContract, ErrorFramesAreCountedAndNotReceived) {
  rig_.report(report(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_WARNING));
  rig_.report(report(CAN_ERR_ACK, 0));
  rig_.report(report(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_PASSIVE));
  expect_arrives(*rig_.far, near_, standard(1, {1}));
  EXPECT_EQ(
      near_.statistics(),
      (CanStatistics{.received = 1, .error_frames = 3, .no_ack = 1, .state = CanState::Passive}));
  rig_.report(report(CAN_ERR_CRTL, CAN_ERR_CRTL_ACTIVE));
  EXPECT_FALSE(near_.receive(kPast));
  EXPECT_EQ(near_.statistics().state, CanState::Active);
}

TEST_P(BusContract, BusOffIsDisconnectedUntilTheControllerRestarts) {
  rig_.report(report(CAN_ERR_BUSOFF, 0));
  const auto got = near_.receive(soon());
  ASSERT_FALSE(got);
  EXPECT_EQ(got.error().code, Errc::Disconnected);
  EXPECT_THAT(got.error().what, ::testing::HasSubstr("bus off"));
  const auto sent = near_.send(standard(1, {}), soon());
  ASSERT_FALSE(sent);
  EXPECT_EQ(sent.error().code, Errc::Disconnected);
  EXPECT_EQ(near_.statistics().bus_off, 1u);

  rig_.report(report(CAN_ERR_RESTARTED, 0));
  EXPECT_FALSE(near_.receive(kPast));
  // The other node's controller reported as well, where there is one.
  while (rig_.far->receive(kPast) || rig_.far->statistics().state == CanState::BusOff) {
  }
  expect_arrives(near_, *rig_.far, standard(1, {}));
}

TEST_P(BusContract, AFullBusHoldsTheSenderUpOrCountsWhatItDrops) {
  constexpr std::uint32_t kMost = 50'000;
  std::uint32_t sent = 0;
  Result<void> result;
  while (sent < kMost && (result = rig_.far->send(numbered(sent), kPast))) ++sent;
  ASSERT_GT(sent, 0u);
  if (!rig_.drops) {
    ASSERT_FALSE(result) << "50,000 frames and still not full";
    EXPECT_EQ(result.error().code, Errc::Timeout);
  }
  std::uint32_t received = 0;
  for (auto got = near_.receive(kPast); got; got = near_.receive(kPast)) {
    ASSERT_EQ(number_in(*got), received) << "what is dropped is dropped at the end";
    ++received;
  }
  expect_arrives(*rig_.far, near_, standard(0x7FF, {}));  // carries the count of drops
  EXPECT_EQ(received + near_.statistics().dropped, sent);
  EXPECT_EQ(rig_.far->statistics().sent, sent + 1);
}

TEST_P(BusContract, CarriesManyFramesBothWaysAtOnce) {
  // Where nothing holds senders up, only what a receive buffer has room for.
  const std::uint32_t count = rig_.drops ? 1'000 : 5'000;
  const auto send_all = [this, count](CanBus& bus) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto sent = bus.send(numbered(i), soon());
      ASSERT_TRUE(sent) << what(sent);
    }
  };
  const auto receive_all = [this, count](CanBus& bus) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto got = bus.receive(soon());
      ASSERT_TRUE(got) << what(got);
      ASSERT_EQ(number_in(*got), i);
    }
  };
  const std::jthread near_sender([&] { send_all(near_); });
  const std::jthread far_sender([&] { send_all(*rig_.far); });
  const std::jthread near_receiver([&] { receive_all(near_); });
  receive_all(*rig_.far);
}

TEST_P(BusContract, AWaitingReceiverWakesWhenAFrameComes) {
  Result<CanFrame> got = CanFrame{};
  {
    const std::jthread receiver([&] { got = near_.receive(soon()); });
    ASSERT_TRUE(rig_.far->send(standard(0x55, {5}), soon()));
  }
  ASSERT_TRUE(got) << what(got);
  EXPECT_EQ(*got, standard(0x55, {5}));
}

TEST_P(BusContract, AWaitingReceiverWakesWhenTheBusGoes) {
  Result<CanFrame> got = CanFrame{};
  {
    const std::jthread receiver([&] { got = near_.receive(soon()); });
    rig_.unplug(rig_);
  }
  rig_.replug(rig_);
  ASSERT_FALSE(got);
  EXPECT_EQ(got.error().code, Errc::Disconnected) << what(got);
}

TEST_P(BusContract, ALostBusWorksAgainWithItsFiltersWhenItIsBack) {
  const CanFilter filter{0x181, 0x7FF, false};
  ASSERT_TRUE(near_.set_filters(std::span(&filter, 1)));
  rig_.unplug(rig_);
  for (int i = 0; i < 2; ++i) {  // the loss, and that it is still away
    const auto got = near_.receive(rig_.clock->now());
    ASSERT_FALSE(got);
    EXPECT_EQ(got.error().code, Errc::Disconnected) << what(got);
  }
  const auto lost = near_.send(standard(0x181, {}), rig_.clock->now());
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error().code, Errc::Disconnected) << what(lost);

  rig_.replug(rig_);
  const auto nothing = near_.receive(kPast);
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().code, Errc::Timeout) << what(nothing);
  ASSERT_TRUE(rig_.far->send(standard(0x182, {}), soon()));
  expect_arrives(*rig_.far, near_, standard(0x181, {1, 2}));
  expect_arrives(near_, *rig_.far, standard(0x7FF, {3}));
}

INSTANTIATE_TEST_SUITE_P(AllBuses, BusContract, ::testing::ValuesIn(bus_cases()),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace eyebridge::bridges::testing
