#include "eyebridge/bridges/faulty_stream.hpp"

#include <gmock/gmock.h>
#include <sys/socket.h>

#include "eyebridge/bridges/fd_stream.hpp"
#include "eyebridge/bridges/memory.hpp"
#include "fake_clock.hpp"
#include "rigs.hpp"

namespace eyebridge::bridges::testing {
namespace {

using std::chrono::milliseconds;

class FaultyLine : public ::testing::Test {
 protected:
  /// A line in memory whose near end is damaged by `plan`.
  void plug(const FaultPlan& plan) {
    auto [near, far] = make_memory_streams(clock_);
    near_ = std::make_unique<FaultyStream>(std::move(near), plan, clock_);
    far_ = std::move(far);
  }
  /// The same over sockets that keep chunks apart.
  void plug_keeping_chunks(const FaultPlan& plan) {
    auto [near, far] = socket_pair(SOCK_SEQPACKET);
    near_ = std::make_unique<FaultyStream>(make_fd_stream(std::move(near), "near", clock_), plan,
                                           clock_);
    far_ = make_fd_stream(std::move(far), "far", clock_);
  }
  static Bytes read(ByteStream& stream) {
    Bytes buffer(4096);
    const auto count = stream.read_some(buffer, kPast);
    buffer.resize(count.value_or(0));
    return buffer;
  }
  /// What `sent` becomes when it is written in chunks of `chunk` bytes.
  Bytes through(const FaultPlan& plan, const Bytes& sent, std::size_t chunk) {
    plug(plan);
    Bytes arrived;
    for (std::span<const std::uint8_t> rest(sent); !rest.empty();) {
      const auto part = rest.first(std::min(chunk, rest.size()));
      EXPECT_TRUE(near_->write_all(part, kPast));
      const Bytes got = read_exactly(*far_, 2 * chunk, kPast);
      arrived.insert(arrived.end(), got.begin(), got.end());
      rest = rest.subspan(part.size());
    }
    return arrived;
  }

  FakeClock clock_;
  std::unique_ptr<FaultyStream> near_;
  std::unique_ptr<ByteStream> far_;
};

FaultPlan plan_of(const LineFaults& incoming, const LineFaults& outgoing = {},
                  std::uint64_t seed = 1) {
  return {seed, incoming, outgoing};
}

LineFaults script(std::vector<ScriptedFault> faults) {
  LineFaults line;
  line.script = std::move(faults);
  return line;
}

TEST_F(FaultyLine, TheScriptDamagesTheBytesThatItNames) {
  const LineFaults faults = script({{4, FaultKind::Repeat},
                                    {1, FaultKind::Drop},
                                    {2, FaultKind::Flip, 7},
                                    {3, FaultKind::Flip, 0}});
  plug(plan_of(faults, faults));
  for (const bool incoming : {true, false}) {
    ByteStream& sender = incoming ? *far_ : static_cast<ByteStream&>(*near_);
    ByteStream& receiver = incoming ? static_cast<ByteStream&>(*near_) : *far_;
    ASSERT_TRUE(sender.write_all(Bytes{0, 1, 2}, kPast));
    ASSERT_TRUE(sender.write_all(Bytes{3, 4, 5}, kPast));
    EXPECT_EQ(read_exactly(receiver, 16, kPast), (Bytes{0, 0x82, 2, 4, 4, 5}));
  }
  EXPECT_EQ(near_->counts(), (FaultCounts{.dropped = 2, .flipped = 4, .repeated = 2}));
}

TEST_F(FaultyLine, AChunkThatIsSplitComesInParts) {
  plug(plan_of(script({{0, FaultKind::Split}, {2, FaultKind::Split}, {3, FaultKind::Split}})));
  ASSERT_TRUE(far_->write_all(Bytes{0, 1, 2, 3, 4}, kPast));
  EXPECT_EQ(read(*near_), (Bytes{0, 1}));
  EXPECT_EQ(read(*near_), Bytes{2});
  EXPECT_EQ(read(*near_), (Bytes{3, 4}));
  EXPECT_EQ(near_->counts().split, 2u) << "nothing was before byte 0";
}

TEST_F(FaultyLine, WhatIsSentIsSplitToo) {
  plug_keeping_chunks(plan_of({}, script({{1, FaultKind::Split}})));
  ASSERT_TRUE(near_->write_all(Bytes{0, 1, 2}, kPast));
  EXPECT_EQ(read(*far_), Bytes{0});
  EXPECT_EQ(read(*far_), (Bytes{1, 2}));
}

TEST_F(FaultyLine, ChunksThatAreMergedComeTogether) {
  LineFaults merging;
  merging.merge = 1.0;
  plug_keeping_chunks(plan_of(merging));
  ASSERT_TRUE(far_->write_all(Bytes{1}, kPast));
  ASSERT_TRUE(far_->write_all(Bytes{2}, kPast));
  EXPECT_EQ(read(*near_), (Bytes{1, 2}));
  EXPECT_EQ(near_->counts().merged, 1u);
}

TEST_F(FaultyLine, WhatIsHeldBackGoesOutWithTheNextWriteOrBeforeTheNextRead) {
  LineFaults merging;
  merging.merge = 1.0;
  plug_keeping_chunks(plan_of({}, merging));
  ASSERT_TRUE(near_->write_all(Bytes{1}, kPast));
  ASSERT_TRUE(near_->write_all(Bytes{2}, kPast));
  EXPECT_EQ(read(*far_), Bytes{});
  EXPECT_EQ(read(*near_), Bytes{});
  EXPECT_EQ(read(*far_), (Bytes{1, 2}));
  ASSERT_TRUE(near_->write_all(Bytes{3}, kPast));
  near_->close();
  EXPECT_EQ(read(*far_), Bytes{3}) << "closing sends the rest";
}

TEST_F(FaultyLine, WhatIsLateHoldsUpWhatIsBehindIt) {
  LineFaults late = script({{1, FaultKind::Delay}});
  late.delay_by = milliseconds(30);
  plug(plan_of(late));
  ASSERT_TRUE(far_->write_all(Bytes{1, 2}, kPast));
  EXPECT_EQ(read(*near_), Bytes{1});
  ASSERT_TRUE(far_->write_all(Bytes{3}, kPast));
  Bytes buffer(8);
  EXPECT_EQ(near_->read_some(buffer, milliseconds(29)).error().code, Errc::Timeout);
  EXPECT_EQ(clock_.now(), milliseconds(29));
  ASSERT_TRUE(near_->read_some(buffer, milliseconds(50)));
  EXPECT_EQ(clock_.now(), milliseconds(30));
  EXPECT_EQ(buffer[0], 2);
  EXPECT_EQ(read(*near_), Bytes{3});
  EXPECT_EQ(near_->counts(), (FaultCounts{.delayed = 1}));
}

TEST_F(FaultyLine, ALateChunkHoldsItsWriterUp) {
  LineFaults late;
  late.delay = 1.0;
  late.delay_by = milliseconds(5);
  plug(plan_of({}, late));
  ASSERT_TRUE(near_->write_all(Bytes{1, 2, 3}, kPast));
  EXPECT_EQ(clock_.now(), milliseconds(5));
  EXPECT_EQ(read(*far_), (Bytes{1, 2, 3}));
}

TEST_F(FaultyLine, UnpluggingEndsItForBothSidesBehindTheBytesBefore) {
  plug(plan_of(script({{2, FaultKind::Unplug}})));
  ASSERT_TRUE(far_->write_all(Bytes{1, 2, 3}, kPast));
  EXPECT_EQ(read(*near_), (Bytes{1, 2}));
  Bytes buffer(8);
  EXPECT_EQ(near_->read_some(buffer, kPast).error().code, Errc::Disconnected);
  EXPECT_EQ(near_->write_all(Bytes{1}, kPast).error().code, Errc::Disconnected);
  EXPECT_EQ(far_->write_all(Bytes{1}, kPast).error().code, Errc::Disconnected);
}

TEST_F(FaultyLine, UnpluggingWhileSendingIsDisconnectedAndSaysWhy) {
  plug(plan_of({}, script({{1, FaultKind::Unplug}})));
  const auto wrote = near_->write_all(Bytes{1, 2}, kPast);
  ASSERT_FALSE(wrote);
  EXPECT_EQ(wrote.error().code, Errc::Disconnected);
  EXPECT_EQ(wrote.error().what, "memory: unplugged by the fault script");
  EXPECT_EQ(read(*far_), Bytes{1});
  EXPECT_EQ(near_->write_all(Bytes{3}, kPast).error().code, Errc::Disconnected);
}

TEST_F(FaultyLine, TheSameSeedDamagesTheSameBytesHoweverTheyAreCut) {
  LineFaults some;
  some.drop = some.flip = some.repeat = some.split = 0.05;
  const Bytes sent = noise(4000, 5);
  const Bytes at_once = through(plan_of({}, some, 7), sent, 4000);
  const FaultCounts counts = near_->counts();
  EXPECT_EQ(through(plan_of({}, some, 7), sent, 7), at_once);
  EXPECT_EQ(near_->counts().dropped, counts.dropped);
  EXPECT_EQ(near_->counts().flipped, counts.flipped);
  EXPECT_EQ(near_->counts().repeated, counts.repeated);
  EXPECT_NE(through(plan_of({}, some, 8), sent, 4000), at_once);
}

TEST_F(FaultyLine, ChanceHitsAsOftenAsAskedAndCountsIt) {
  LineFaults some;
  some.drop = some.flip = 0.01;
  const Bytes sent = noise(100'000, 5);
  const Bytes arrived = through(plan_of({}, some), sent, 1000);
  const FaultCounts counts = near_->counts();
  // Six standard deviations of 1000 hits are 189.
  EXPECT_NEAR(static_cast<double>(counts.dropped), 1000, 189);
  EXPECT_NEAR(static_cast<double>(counts.flipped), 990, 189);
  EXPECT_EQ(arrived.size(), sent.size() - counts.dropped);
}

}  // namespace
}  // namespace eyebridge::bridges::testing
