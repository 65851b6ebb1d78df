#include "eyebridge/bridges/faulty_bus.hpp"

#include <gmock/gmock.h>

#include "eyebridge/bridges/memory.hpp"
#include "fake_clock.hpp"
#include "frames.hpp"
#include "rigs.hpp"

namespace eyebridge::bridges::testing {
namespace {

using std::chrono::milliseconds;

class FaultyCan : public ::testing::Test {
 protected:
  /// A bus whose node `near_` is damaged by these faults.
  void plug(const LineFaults& incoming, const LineFaults& outgoing = {}, std::uint64_t seed = 1) {
    memory_ = std::make_unique<MemoryCan>(clock_, 20'000);
    near_ = std::make_unique<FaultyBus>(memory_->connect("near"),
                                        FaultPlan{seed, incoming, outgoing}, clock_);
    far_ = memory_->connect("far");
  }
  static std::vector<CanFrame> receive_all(CanBus& bus) {
    std::vector<CanFrame> frames;
    for (auto got = bus.receive(kPast); got; got = bus.receive(kPast)) frames.push_back(*got);
    return frames;
  }

  FakeClock clock_;
  std::unique_ptr<MemoryCan> memory_;
  std::unique_ptr<FaultyBus> near_;
  std::unique_ptr<CanBus> far_;
};

TEST_F(FaultyCan, TheScriptDamagesTheFramesThatItNames) {
  LineFaults faults;
  faults.script = {
      {3, FaultKind::Repeat}, {0, FaultKind::Drop}, {1, FaultKind::Flip, 15}, {2, FaultKind::Flip}};
  plug(faults, faults);
  const std::vector<CanFrame> sent{standard(1, {0, 0}), standard(2, {0, 0}), standard(3, {}),
                                   standard(4, {4})};
  const std::vector<CanFrame> expected{standard(2, {0, 0x80}), standard(3, {}), standard(4, {4}),
                                       standard(4, {4})};
  for (const CanFrame& frame : sent) ASSERT_TRUE(near_->send(frame, kPast));
  EXPECT_EQ(receive_all(*far_), expected);
  for (const CanFrame& frame : sent) ASSERT_TRUE(far_->send(frame, kPast));
  EXPECT_EQ(receive_all(*near_), expected);
  EXPECT_EQ(near_->counts(), (FaultCounts{.dropped = 2, .flipped = 2, .repeated = 2}))
      << "a frame without data has no bit to flip";
  EXPECT_EQ(near_->statistics(), (CanStatistics{.sent = 4, .received = 4}));
}

TEST_F(FaultyCan, ALateFrameHoldsUpWhatIsBehindIt) {
  LineFaults late;
  late.script = {{0, FaultKind::Delay}};
  late.delay_by = milliseconds(30);
  plug(late);
  ASSERT_TRUE(far_->send(standard(1, {}), kPast));
  ASSERT_TRUE(far_->send(standard(2, {}), kPast));
  EXPECT_EQ(near_->receive(milliseconds(29)).error().code, Errc::Timeout);
  EXPECT_EQ(near_->receive(milliseconds(99))->id, 1u);
  EXPECT_EQ(clock_.now(), milliseconds(30));
  EXPECT_EQ(near_->receive(kPast)->id, 2u);
  EXPECT_EQ(near_->counts(), (FaultCounts{.delayed = 1}));
}

TEST_F(FaultyCan, ALateFrameHoldsItsSenderUp) {
  LineFaults late;
  late.delay = 1.0;
  late.delay_by = milliseconds(5);
  plug({}, late);
  ASSERT_TRUE(near_->send(standard(1, {}), kPast));
  EXPECT_EQ(clock_.now(), milliseconds(5));
  EXPECT_TRUE(far_->receive(kPast));
}

TEST_F(FaultyCan, UnpluggingIsForGood) {
  LineFaults cut;
  cut.script = {{1, FaultKind::Unplug}};
  for (const bool incoming : {true, false}) {
    plug(incoming ? cut : LineFaults{}, incoming ? LineFaults{} : cut);
    CanBus& sender = incoming ? *far_ : *near_;
    CanBus& receiver = incoming ? static_cast<CanBus&>(*near_) : *far_;
    ASSERT_TRUE(sender.send(standard(1, {}), kPast));
    EXPECT_EQ(sender.send(standard(2, {}), kPast).has_value(), incoming);
    EXPECT_EQ(receiver.receive(kPast)->id, 1u);
    EXPECT_FALSE(receiver.receive(kPast));
    for (int i = 0; i < 2; ++i) {
      const auto got = near_->receive(kPast);
      EXPECT_EQ(got.error().what, "near: unplugged by the fault script");
      EXPECT_EQ(near_->send(standard(3, {}), kPast).error().code, Errc::Disconnected);
    }
  }
}

TEST_F(FaultyCan, TheSameSeedDamagesTheSameFrames) {
  LineFaults some;
  some.drop = some.flip = some.repeat = 0.05;
  const auto arrived = [&](std::uint64_t seed) {
    plug({}, some, seed);
    for (std::uint32_t i = 0; i < 1000; ++i) EXPECT_TRUE(near_->send(numbered(i), kPast));
    return receive_all(*far_);
  };
  const std::vector<CanFrame> first = arrived(7);
  EXPECT_EQ(arrived(7), first);
  EXPECT_NE(arrived(8), first);
}

TEST_F(FaultyCan, ChanceHitsAsOftenAsAskedAndCountsIt) {
  LineFaults some;
  some.drop = some.flip = 0.1;
  plug(some);
  constexpr std::uint32_t kSent = 10'000;
  for (std::uint32_t i = 0; i < kSent; ++i) ASSERT_TRUE(far_->send(numbered(i), kPast));
  const std::size_t arrived = receive_all(*near_).size();
  const FaultCounts counts = near_->counts();
  // Six standard deviations of 1000 hits are 180.
  EXPECT_NEAR(static_cast<double>(counts.dropped), 1000, 180);
  EXPECT_NEAR(static_cast<double>(counts.flipped), 900, 180);
  EXPECT_EQ(arrived, kSent - counts.dropped);
}

}  // namespace
}  // namespace eyebridge::bridges::testing
