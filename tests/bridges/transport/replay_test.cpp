#include "eyebridge/bridges/replay.hpp"

#include <gmock/gmock.h>

#include "eyebridge/bridges/memory.hpp"
#include "fake_clock.hpp"
#include "frames.hpp"
#include "rigs.hpp"

namespace eyebridge::bridges::testing {
namespace {

using ::testing::HasSubstr;

class Replay : public ::testing::Test {
 protected:
  std::unique_ptr<ByteStream> stream(std::string_view text, ReplayMode mode) {
    return make_replay_stream(read_byte_trace(text, "t"), "t", mode, clock_);
  }
  std::unique_ptr<CanBus> bus(std::string_view text, ReplayMode mode) {
    return make_replay_bus(read_can_trace(text, "t"), "t", mode, clock_);
  }

  FakeClock clock_;
  Bytes buffer_ = Bytes(16);
};

TEST_F(Replay, AnAnswerComesOnceItsQuestionWasSent) {
  const auto line = stream("0 > 7172\n5 < 0102\n9 > 73\n9 < 03\n", ReplayMode::Strict);
  EXPECT_EQ(line->read_some(buffer_, std::chrono::seconds(1)).error().code, Errc::Timeout);
  EXPECT_EQ(clock_.now(), std::chrono::seconds(1));
  ASSERT_TRUE(line->write_all(Bytes{0x71}, kPast));
  EXPECT_EQ(line->read_some(buffer_, kPast).error().code, Errc::Timeout);
  ASSERT_TRUE(line->write_all(Bytes{0x72, 0x73}, kPast)) << "cut otherwise than in the trace";
  EXPECT_EQ(read_exactly(*line, 16, kPast), (Bytes{1, 2, 3}));
  const auto end = line->read_some(buffer_, kPast);
  EXPECT_EQ(end.error().code, Errc::Disconnected);
  EXPECT_EQ(end.error().what, "t: the trace ends here");
  EXPECT_EQ(line->write_all(Bytes{1}, kPast).error().code, Errc::Disconnected);
}

TEST_F(Replay, SmallBuffersGetTheRestLater) {
  const auto line = stream("0 < 010203\n", ReplayMode::Strict);
  buffer_.resize(2);
  EXPECT_EQ(*line->read_some(buffer_, kPast), 2u);
  EXPECT_EQ(*line->read_some(buffer_, kPast), 1u);
  EXPECT_EQ(buffer_[0], 3);
}

TEST_F(Replay, AnotherByteThanInTheTraceIsNamed) {
  const auto line = stream("0 < 00\n7 > 7172\n", ReplayMode::Strict);
  const auto wrote = line->write_all(Bytes{0x71, 0x99}, kPast);
  ASSERT_FALSE(wrote);
  EXPECT_EQ(wrote.error().code, Errc::Corrupt);
  EXPECT_EQ(wrote.error().what, "t: record 2, byte 2: found '7 > 7199', expected '7 > 7172'");
}

TEST_F(Replay, LenientIgnoresWhatIsSent) {
  const auto line = stream("0 > 71\n5 < 0102\n", ReplayMode::Lenient);
  EXPECT_TRUE(line->write_all(Bytes{0x99}, kPast));
  EXPECT_EQ(read_exactly(*line, 16, kPast), (Bytes{1, 2}));
  EXPECT_EQ(line->read_some(buffer_, kPast).error().code, Errc::Disconnected);
}

TEST_F(Replay, AClosedLineStaysClosed) {
  const auto line = stream("0 < 0102\n", ReplayMode::Strict);
  line->close();
  EXPECT_EQ(line->read_some(buffer_, kPast).error().code, Errc::Disconnected);
  EXPECT_EQ(line->write_all(Bytes{1}, kPast).error().code, Errc::Disconnected);
}

TEST_F(Replay, WhatWasTracedCanBeReplayed) {
  std::string text;
  const Bytes question = noise(100, 1);
  const Bytes answer = noise(5000, 2);
  {
    auto [near, far] = make_memory_streams(clock_);
    const auto traced = make_traced(
        std::move(near), clock_, [&](std::string_view line) { text += std::string(line) + '\n'; });
    ASSERT_TRUE(traced->write_all(question, kPast));
    ASSERT_TRUE(far->write_all(answer, kPast));
    ASSERT_EQ(read_exactly(*traced, answer.size(), kPast), answer);
  }
  const auto line = stream(text, ReplayMode::Strict);
  ASSERT_TRUE(line->write_all(question, kPast));
  EXPECT_EQ(read_exactly(*line, answer.size(), kPast), answer);
}

constexpr char kFrames[] =
    "(0.000000) can0 181#01 R\n"
    "(0.000100) can0 201#AABB T\n"
    "(0.000200) can0 181#02\n"
    "(0.000300) can0 20000004#0020000000000000 R\n"
    "(0.000400) can0 191#03 R\n";

TEST_F(Replay, AFrameComesOnceTheOneBeforeWasSent) {
  const auto line = bus(kFrames, ReplayMode::Strict);
  EXPECT_EQ(*line->receive(kPast), standard(0x181, {1}));
  EXPECT_EQ(line->receive(kPast).error().code, Errc::Timeout);
  ASSERT_TRUE(line->send(standard(0x201, {0xAA, 0xBB}), kPast));
  EXPECT_EQ(*line->receive(kPast), standard(0x181, {2})) << "without a direction: received";
  EXPECT_EQ(*line->receive(kPast), standard(0x191, {3}));
  EXPECT_EQ(line->receive(kPast).error().what, "t: the trace ends here");
  EXPECT_EQ(
      line->statistics(),
      (CanStatistics{.sent = 1, .received = 3, .error_frames = 1, .state = CanState::Passive}));
}

TEST_F(Replay, AnotherFrameThanInTheTraceIsNamed) {
  const auto line = bus(kFrames, ReplayMode::Strict);
  const auto sent = line->send(standard(0x201, {0xAA, 0xBC}), kPast);
  ASSERT_FALSE(sent);
  EXPECT_EQ(sent.error().code, Errc::Corrupt);
  EXPECT_EQ(sent.error().what,
            "t: record 2: found '(0.000100) can0 201#AABC T', expected "
            "'(0.000100) can0 201#AABB T'");
  EXPECT_EQ(line->send(impossible_frames().front(), kPast).error().code, Errc::OutOfRange);
}

TEST_F(Replay, LenientBusesIgnoreWhatIsSentAndKeepTheFilters) {
  const auto line = bus(kFrames, ReplayMode::Lenient);
  const CanFilter filter{0x190, 0x7F0, false};
  ASSERT_TRUE(line->set_filters(std::span(&filter, 1)));
  EXPECT_TRUE(line->send(standard(0x7FF, {}), kPast));
  EXPECT_EQ(*line->receive(kPast), standard(0x191, {3}));
  EXPECT_EQ(line->receive(kPast).error().code, Errc::Disconnected);
}

TEST_F(Replay, BusOffIsReplayedToo) {
  const auto line = bus("(0.000000) can0 20000040#0000000000000000 R\n(1.000000) can0 181# R\n",
                        ReplayMode::Strict);
  const auto got = line->receive(kPast);
  ASSERT_FALSE(got);
  EXPECT_EQ(got.error().code, Errc::Disconnected);
  EXPECT_THAT(got.error().what, HasSubstr("bus off"));
  EXPECT_EQ(line->send(standard(1, {}), kPast).error().code, Errc::Disconnected);
  EXPECT_TRUE(line->receive(kPast));
  EXPECT_EQ(line->statistics().state, CanState::Active);
}

}  // namespace
}  // namespace eyebridge::bridges::testing
