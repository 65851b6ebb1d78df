#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include <gmock/gmock.h>

#include "eyebridge/bridges/can/lidar.hpp"

namespace eyebridge::bridges::can {
namespace {

class Lidar : public testing::TestWithParam<bool> {
 protected:
  [[nodiscard]] int chunks(int points) const {
    return GetParam() ? chunk_count_fd(points) : chunk_count(points);
  }
  /// Sends chunk `index` of `ranges` over the wire, as frames of the format under test.
  const LidarScan* send(std::uint8_t scan_id, const std::vector<std::uint16_t>& ranges, int index) {
    if (GetParam()) {
      const auto frame = encode(1, make_chunk_fd(scan_id, ranges, index));
      return assembler_.push(*decode<LidarChunkFd>(*frame));
    }
    const auto frame = encode(1, make_chunk(scan_id, ranges, index));
    return assembler_.push(*decode<LidarChunk>(*frame));
  }
  static LidarHeader header(std::uint8_t scan_id, std::size_t points) {
    return {.scan_id = scan_id, .points = static_cast<std::uint16_t>(points)};
  }
  static std::vector<std::uint16_t> ranges(std::size_t points, std::uint16_t first = 100) {
    std::vector<std::uint16_t> out(points);
    std::iota(out.begin(), out.end(), first);
    return out;
  }
  static std::vector<std::uint16_t> points_of(const LidarScan& scan) {
    return {scan.points().begin(), scan.points().end()};
  }

  LidarAssembler assembler_;
};

TEST_P(Lidar, ScansOfEverySizeArriveAsTheyWereSent) {
  for (const std::size_t points : {1U, 2U, 3U, 4U, 29U, 30U, 31U, 359U, 360U, 361U, 4000U}) {
    const auto sent = ranges(points);
    EXPECT_EQ(assembler_.push(header(7, points)), nullptr);
    const LidarScan* scan = nullptr;
    for (int i = 0; i < chunks(static_cast<int>(points)); ++i) {
      ASSERT_EQ(scan, nullptr) << "complete too early";
      scan = send(7, sent, i);
    }
    ASSERT_NE(scan, nullptr) << points;
    EXPECT_EQ(scan->missing, 0);
    EXPECT_EQ(points_of(*scan), sent);
  }
  EXPECT_EQ(assembler_.stray(), 0U);
}

TEST_P(Lidar, AnyOrderAndRepetitionsGiveTheSameScan) {
  std::mt19937 random(3);
  const auto sent = ranges(360);
  std::vector<int> order(static_cast<std::size_t>(chunks(360)));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  assembler_.push(header(1, 360));
  const LidarScan* scan = nullptr;
  for (std::size_t i = 0; i < order.size(); ++i) {
    ASSERT_EQ(scan, nullptr);
    if (i + 1 < order.size()) send(1, sent, order[i]);
    scan = send(1, sent, order[i]);
  }
  ASSERT_NE(scan, nullptr);
  EXPECT_EQ(points_of(*scan), sent);
}

TEST_P(Lidar, ALostFrameCostsItsPointsAlone) {
  const auto sent = ranges(360);
  assembler_.push(header(1, 360));
  for (int i = 0; i < chunks(360); ++i) {
    if (i == 5) continue;
    ASSERT_EQ(send(1, sent, i), nullptr);
  }
  const LidarScan* scan = assembler_.push(header(2, 360));
  ASSERT_NE(scan, nullptr);
  const std::size_t lost = GetParam() ? 30 : 3;
  EXPECT_EQ(scan->missing, static_cast<int>(lost));
  for (std::size_t i = 0; i < 360; ++i) {
    const bool is_lost = i / lost == 5;
    EXPECT_EQ(scan->points()[i], is_lost ? EYECAN_ABSENT : sent[i]) << i;
  }
}

TEST_P(Lidar, AScanAfterALostOneIsWhole) {
  assembler_.push(header(1, 60));
  send(1, ranges(60), 0);
  assembler_.push(header(2, 60));
  const LidarScan* scan = nullptr;
  for (int i = 0; i < chunks(60); ++i) scan = send(2, ranges(60, 500), i);
  ASSERT_NE(scan, nullptr);
  EXPECT_EQ(scan->header.scan_id, 2);
  EXPECT_EQ(points_of(*scan), ranges(60, 500));
}

TEST_P(Lidar, ChunksOfAnotherScanOrOutsideItAreStray) {
  EXPECT_EQ(send(1, ranges(60), 0), nullptr);  // no header yet
  assembler_.push(header(1, 60));
  EXPECT_EQ(send(2, ranges(60), 0), nullptr);
  EXPECT_EQ(send(1, ranges(600), chunks(60)), nullptr);
  EXPECT_EQ(assembler_.stray(), 3U);
}

TEST_P(Lidar, TheLargestScanFits) {
  const std::vector<std::uint16_t> sent(kMaxLidarPoints, 1);
  assembler_.push(header(9, sent.size()));
  const LidarScan* scan = nullptr;
  for (int i = 0; i < chunks(kMaxLidarPoints); ++i) scan = send(9, sent, i);
  ASSERT_NE(scan, nullptr);
  EXPECT_EQ(scan->points().size(), static_cast<std::size_t>(kMaxLidarPoints));
}

INSTANTIATE_TEST_SUITE_P(Formats, Lidar, testing::Bool(),
                         [](const auto& row) { return row.param ? "CanFd" : "Classic"; });

TEST(LidarChunks, A360PointScanTakes120FramesOr12) {
  EXPECT_EQ(chunk_count(360), 120);
  EXPECT_EQ(chunk_count_fd(360), 12);
}

TEST(LidarChunks, AnyHeadersAndChunksKeepTheScanWithinItsBounds) {
  std::mt19937 random(11);
  LidarAssembler assembler;
  const auto any16 = [&random] { return static_cast<std::uint16_t>(random()); };
  int scans = 0;
  for (int round = 0; round < 20000; ++round) {
    const LidarScan* scan = nullptr;
    const auto id = static_cast<std::uint8_t>(random() % 3);
    if (random() % 4 == 0) {
      scan = assembler.push(
          LidarHeader{.scan_id = id, .points = random() % 2 == 0 ? any16() : std::uint16_t{5}});
    } else if (random() % 2 == 0) {
      LidarChunk chunk{.scan_id_low = id, .chunk = random() % 2 == 0 ? any16() : std::uint16_t{1}};
      scan = assembler.push(chunk);
    } else {
      LidarChunkFd chunk{
          .scan_id = id, .count = static_cast<std::uint8_t>(random()), .first = any16()};
      scan = assembler.push(chunk);
    }
    if (scan == nullptr) continue;
    ++scans;
    ASSERT_LE(scan->points().size(), static_cast<std::size_t>(kMaxLidarPoints));
    ASSERT_GE(scan->missing, 0);
    ASSERT_LE(scan->missing, scan->header.points);
  }
  EXPECT_GT(scans, 1000);
}

}  // namespace
}  // namespace eyebridge::bridges::can
