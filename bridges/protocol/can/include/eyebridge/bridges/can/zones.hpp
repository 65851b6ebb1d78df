#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "eyebridge/bridges/can/messages.hpp"

namespace eyebridge::bridges::can {

/// One reading of a range matrix, mm: the top row first, each from the left.
using Zones = std::array<std::uint16_t, kZoneCount>;

/// Puts the frames of one range matrix together. Pure: no clock, no I/O. Frames may be repeated or
/// out of order within a reading; one that lacks a frame is given up when the next one begins.
class ZoneAssembler {
 public:
  /// Takes three zones. Returns the reading when they were the last ones missing, else null; valid
  /// until the next call.
  const Zones* push(const ZoneChunk& chunk) {
    if (chunk.reading != reading_) reset();
    reading_ = chunk.reading;
    const std::size_t first = 3 * std::size_t{chunk.chunk};
    if (first >= zones_.size()) return nullptr;
    const std::size_t count = std::min(chunk.range_mm.size(), zones_.size() - first);
    std::copy_n(chunk.range_mm.begin(), count, zones_.begin() + static_cast<std::ptrdiff_t>(first));
    seen_ |= std::uint32_t{1} << chunk.chunk;
    if (seen_ != kAll) return nullptr;
    reset();
    return &zones_;
  }
  /// Forgets what came of a reading: its number comes again after 16.
  void reset() { seen_ = 0; }

 private:
  static constexpr std::uint32_t kAll = (std::uint32_t{1} << (kLastZoneChunk + 1)) - 1;

  Zones zones_{};
  std::uint32_t seen_ = 0;  ///< Bit n: chunk n.
  std::uint8_t reading_ = 0;
};

}  // namespace eyebridge::bridges::can
