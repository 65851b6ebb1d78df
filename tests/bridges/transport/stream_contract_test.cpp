#include <numeric>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rigs.hpp"

namespace eyebridge::bridges::testing {
namespace {

/// What every kind of byte stream does.
class StreamContract : public ::testing::TestWithParam<StreamCase> {
 protected:
  Time soon() const { return rig_.clock->now() + kSoon; }

  StreamRig rig_ = GetParam().make();
  ByteStream& near_ = *rig_.near;
  ByteStream& far_ = *rig_.far;
};

TEST_P(StreamContract, CarriesAllByteValuesInOrderBothWays) {
  Bytes all(256);
  std::iota(all.begin(), all.end(), std::uint8_t{0});
  ASSERT_TRUE(near_.write_all(all, soon()));
  EXPECT_EQ(read_exactly(far_, all.size(), soon()), all);
  ASSERT_TRUE(far_.write_all(all, soon()));
  EXPECT_EQ(read_exactly(near_, all.size(), soon()), all);
}

TEST_P(StreamContract, ReadingTakesOnlyWhatTheBufferHolds) {
  ASSERT_TRUE(far_.write_all(Bytes{1, 2, 3}, soon()));
  EXPECT_EQ(read_exactly(near_, 1, soon()), Bytes{1});
  EXPECT_EQ(read_exactly(near_, 2, soon()), (Bytes{2, 3}));
}

TEST_P(StreamContract, ReadingNothingTimesOut) {
  Bytes buffer(8);
  for (const Time wait : {Time{0}, Time(std::chrono::milliseconds(2))}) {
    const Time deadline = rig_.clock->now() + wait;
    const auto got = near_.read_some(buffer, deadline);
    ASSERT_FALSE(got);
    EXPECT_EQ(got.error().code, Errc::Timeout);
    EXPECT_GE(rig_.clock->now(), deadline);
  }
}

TEST_P(StreamContract, WritingNothingIsNoError) { EXPECT_TRUE(near_.write_all({}, kPast)); }

TEST_P(StreamContract, CarriesAMegabyteBothWaysAtOnce) {
  const Bytes there = noise(1 << 20, 1);
  const Bytes back = noise(1 << 20, 2);
  Result<void> near_wrote;
  Result<void> far_wrote;
  Bytes at_near;
  {
    const std::jthread near_writer([&] { near_wrote = near_.write_all(there, soon()); });
    const std::jthread far_writer([&] { far_wrote = far_.write_all(back, soon()); });
    const std::jthread near_reader([&] { at_near = read_exactly(near_, back.size(), soon()); });
    EXPECT_TRUE(read_exactly(far_, there.size(), soon()) == there);
  }
  EXPECT_TRUE(near_wrote) << what(near_wrote);
  EXPECT_TRUE(far_wrote) << what(far_wrote);
  EXPECT_TRUE(at_near == back);
}

TEST_P(StreamContract, AFullLineHoldsTheWriterUpAndLosesNothing) {
  constexpr std::size_t kChunk = 4096;
  constexpr std::size_t kMostChunks = 16384;
  const Bytes chunk = noise(kChunk, 3);
  std::size_t whole = 0;
  Result<void> wrote;
  while ((wrote = near_.write_all(chunk, kPast)) && whole < kMostChunks) ++whole;
  ASSERT_FALSE(wrote) << "64 MB and still not full";
  EXPECT_EQ(wrote.error().code, Errc::Timeout) << wrote.error().what;
  ASSERT_GT(whole, 0u);

  for (std::size_t i = 0; i < whole; ++i) {
    ASSERT_TRUE(read_exactly(far_, kChunk, soon()) == chunk) << "chunk " << i;
  }
  EXPECT_TRUE(near_.write_all(chunk, soon()));
}

TEST_P(StreamContract, AWaitingReaderWakesWhenBytesCome) {
  Bytes got;
  {
    const std::jthread reader([&] { got = read_exactly(near_, 3, soon()); });
    ASSERT_TRUE(far_.write_all(Bytes{7, 8, 9}, soon()));
  }
  EXPECT_EQ(got, (Bytes{7, 8, 9}));
}

TEST_P(StreamContract, AWaitingReaderWakesWhenTheOtherSideCloses) {
  Bytes buffer(8);
  Result<std::size_t> got = 0u;
  {
    const std::jthread reader([&] { got = near_.read_some(buffer, soon()); });
    far_.close();
  }
  ASSERT_FALSE(got);
  EXPECT_EQ(got.error().code, Errc::Disconnected) << what(got);
}

TEST_P(StreamContract, WhatWasSentBeforeClosingStillArrives) {
  ASSERT_TRUE(near_.write_all(Bytes{1, 2, 3, 4}, soon()));
  near_.close();
  EXPECT_EQ(read_exactly(far_, 4, soon()), (Bytes{1, 2, 3, 4}));
  Bytes buffer(8);
  const auto got = far_.read_some(buffer, soon());
  ASSERT_FALSE(got);
  EXPECT_EQ(got.error().code, Errc::Disconnected) << what(got);
}

TEST_P(StreamContract, WritingToNobodyIsDisconnected) {
  rig_.far.reset();
  const Bytes chunk(1024);
  Result<void> wrote;
  // Buffers on the way may take some before the loss comes back.
  for (int i = 0; i < 65536 && wrote; ++i) wrote = near_.write_all(chunk, soon());
  ASSERT_FALSE(wrote);
  EXPECT_EQ(wrote.error().code, Errc::Disconnected) << what(wrote);
}

TEST_P(StreamContract, AfterClosingEverythingIsDisconnected) {
  near_.close();
  near_.close();
  Bytes buffer(8);
  const auto got = near_.read_some(buffer, soon());
  const auto wrote = near_.write_all(Bytes{1}, soon());
  ASSERT_FALSE(got);
  ASSERT_FALSE(wrote);
  EXPECT_EQ(got.error().code, Errc::Disconnected);
  EXPECT_EQ(wrote.error().code, Errc::Disconnected);
}

TEST_P(StreamContract, ErrorsNameTheLine) {
  Bytes buffer(8);
  const std::string name(near_.name());
  ASSERT_FALSE(name.empty());
  EXPECT_THAT(what(near_.read_some(buffer, kPast)), ::testing::StartsWith(name + ": "));
}

INSTANTIATE_TEST_SUITE_P(AllStreams, StreamContract, ::testing::ValuesIn(stream_cases()),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace eyebridge::bridges::testing
