#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <span>

#include "eyebridge/bridges/can/messages.hpp"

namespace eyebridge::bridges::can {

/// One scan, as far as it arrived.
struct LidarScan {
  LidarHeader header{};
  std::array<std::uint16_t, kMaxLidarPoints> range_mm{};  ///< EYECAN_ABSENT where a frame was lost.
  int missing = 0;                                        ///< Points that did not arrive.

  [[nodiscard]] std::span<const std::uint16_t> points() const {
    return {range_mm.data(), header.points};
  }
};

/// Puts the frames of one robot's LIDAR together. Pure: no clock, no I/O, no allocation (some 50 kB
/// in itself). Frames may be lost, repeated or out of order within a scan.
class LidarAssembler {
 public:
  /// Begins a scan. Returns the one before when it is still incomplete, else null. What is returned
  /// by any push stays valid until the second push after it that returns a scan.
  const LidarScan* push(const LidarHeader& header);
  /// Takes points. Returns the scan when they were the last ones missing, else null.
  const LidarScan* push(const LidarChunk& chunk);
  const LidarScan* push(const LidarChunkFd& chunk);

  /// Chunks that belonged to no scan, or outside it, since construction.
  [[nodiscard]] std::uint32_t stray() const { return stray_; }

 private:
  const LidarScan* take(int first, std::span<const std::uint16_t> range_mm);
  const LidarScan* finish();

  std::array<LidarScan, 2> scans_{};
  std::size_t current_ = 0;
  bool running_ = false;
  std::bitset<kMaxLidarPoints> seen_;
  std::uint32_t stray_ = 0;
};

/// How many frames the points of a scan need.
int chunk_count(int points);
int chunk_count_fd(int points);

/// Chunk `index` of a scan: 0 … chunk_count() - 1. Points after the last one are EYECAN_ABSENT.
LidarChunk make_chunk(std::uint8_t scan_id, std::span<const std::uint16_t> range_mm, int index);
/// The same for CAN FD: 0 … chunk_count_fd() - 1.
LidarChunkFd make_chunk_fd(std::uint8_t scan_id, std::span<const std::uint16_t> range_mm,
                           int index);

}  // namespace eyebridge::bridges::can
