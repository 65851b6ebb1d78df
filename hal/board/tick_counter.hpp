#pragma once

#include <cstdint>
#include <optional>

namespace eyebridge::hal {

/// One count that never jumps, out of a board's counters: over their wrapping around, and over
/// restarts of the board.
class TickCounter {
 public:
  /// The board's 16-bit counter, read often enough that it cannot have moved by 32768 meanwhile.
  std::int32_t feed16(std::uint16_t count, std::uint32_t generation) {
    if (fits(generation)) add(static_cast<std::int16_t>(static_cast<std::uint16_t>(count - last_)));
    last_ = count;
    return total();
  }
  /// The board's 32-bit counter.
  std::int32_t feed32(std::int32_t count, std::uint32_t generation) {
    const auto bits = static_cast<std::uint32_t>(count);
    if (fits(generation)) add(static_cast<std::int32_t>(bits - last_));
    last_ = bits;
    return total();
  }
  /// How far feed16() would go.
  [[nodiscard]] int step_to(std::uint16_t count, std::uint32_t generation) const {
    if (generation_ != generation) return 0;
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(count - last_));
  }

 private:
  bool fits(std::uint32_t generation) {
    const bool same = generation_ == generation;
    generation_ = generation;
    return same;
  }
  void add(std::int32_t step) { total_ += static_cast<std::uint32_t>(step); }
  [[nodiscard]] std::int32_t total() const { return static_cast<std::int32_t>(total_); }

  std::optional<std::uint32_t> generation_;
  std::uint32_t last_ = 0;
  std::uint32_t total_ = 0;
};

}  // namespace eyebridge::hal
