#include "eyebridge/bridges/can/lidar.hpp"

#include <algorithm>

namespace eyebridge::bridges::can {
namespace {

constexpr int kPoints = 3;
constexpr int kPointsFd = 30;

/// Copies the points from `first` on; returns how many there were.
int fill(std::span<std::uint16_t> out, std::span<const std::uint16_t> range_mm, int first) {
  std::fill(out.begin(), out.end(), std::uint16_t{EYECAN_ABSENT});
  const auto rest = range_mm.subspan(std::min(range_mm.size(), static_cast<std::size_t>(first)));
  const auto count = std::min(out.size(), rest.size());
  std::copy_n(rest.begin(), count, out.begin());
  return static_cast<int>(count);
}

}  // namespace

const LidarScan* LidarAssembler::finish() {
  running_ = false;
  const LidarScan* finished = &scans_[current_];
  current_ = 1 - current_;
  return finished;
}

const LidarScan* LidarAssembler::push(const LidarHeader& header) {
  const LidarScan* before = running_ ? finish() : nullptr;
  LidarScan& scan = scans_[current_];
  scan.header = header;
  scan.header.points = std::min<std::uint16_t>(header.points, kMaxLidarPoints);
  scan.missing = scan.header.points;
  std::fill_n(scan.range_mm.begin(), scan.header.points, std::uint16_t{EYECAN_ABSENT});
  seen_.reset();
  running_ = scan.header.points > 0;
  return before;
}

const LidarScan* LidarAssembler::push(const LidarChunk& chunk) {
  if (!running_ || chunk.scan_id_low != (scans_[current_].header.scan_id & 0x0F)) {
    ++stray_;
    return nullptr;
  }
  return take(chunk.chunk * kPoints, chunk.range_mm);
}

const LidarScan* LidarAssembler::push(const LidarChunkFd& chunk) {
  if (!running_ || chunk.scan_id != scans_[current_].header.scan_id || chunk.count > kPointsFd) {
    ++stray_;
    return nullptr;
  }
  return take(chunk.first, std::span(chunk.range_mm).first(chunk.count));
}

const LidarScan* LidarAssembler::take(int first, std::span<const std::uint16_t> range_mm) {
  LidarScan& scan = scans_[current_];
  if (first >= scan.header.points) {
    ++stray_;
    return nullptr;
  }
  const auto begin = static_cast<std::size_t>(first);
  const auto count = std::min<std::size_t>(range_mm.size(), scan.header.points - begin);
  for (std::size_t i = 0; i < count; ++i) {
    scan.range_mm[begin + i] = range_mm[i];
    if (!seen_.test(begin + i)) --scan.missing;
    seen_.set(begin + i);
  }
  return scan.missing == 0 ? finish() : nullptr;
}

int chunk_count(int points) { return (points + kPoints - 1) / kPoints; }
int chunk_count_fd(int points) { return (points + kPointsFd - 1) / kPointsFd; }

LidarChunk make_chunk(std::uint8_t scan_id, std::span<const std::uint16_t> range_mm, int index) {
  LidarChunk chunk{.scan_id_low = static_cast<std::uint8_t>(scan_id & 0x0F),
                   .chunk = static_cast<std::uint16_t>(index)};
  fill(chunk.range_mm, range_mm, index * kPoints);
  return chunk;
}

LidarChunkFd make_chunk_fd(std::uint8_t scan_id, std::span<const std::uint16_t> range_mm,
                           int index) {
  LidarChunkFd chunk{.scan_id = scan_id, .first = static_cast<std::uint16_t>(index * kPointsFd)};
  chunk.count = static_cast<std::uint8_t>(fill(chunk.range_mm, range_mm, chunk.first));
  return chunk;
}

}  // namespace eyebridge::bridges::can
