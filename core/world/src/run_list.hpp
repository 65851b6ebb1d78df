#pragma once

#include <cstddef>
#include <cstdint>

namespace eyebridge::world {

/// Numbers that begin registers, of many runs of registers: one loop through them instead of short
/// ones, of which nobody can foresee the ends. `kUsual` of a run are listed at once.
template <std::size_t kMost, std::size_t kUsual, std::uint32_t kStep>
struct RunList {
  std::uint32_t items[kMost + kUsual];
  std::size_t size = 0;

  /// Adds `count` numbers: `first` and each kStep more. Calls full() when there may be no more
  /// room: it takes what is listed, and sets `size` to 0. The caller takes the rest at the end.
  template <class Full>
  void add(std::uint32_t first, std::size_t count, Full full) {
    for (;;) {
      // This many, whether there are or not.
      for (std::uint32_t i = 0; i < kUsual; ++i) items[size + i] = first + i * kStep;
      size += count < kUsual ? count : kUsual;
      if (size >= kMost) [[unlikely]] {
        full();
      }
      if (count <= kUsual) [[likely]] {
        return;
      }
      count -= kUsual;
      first += static_cast<std::uint32_t>(kUsual) * kStep;
    }
  }
};

}  // namespace eyebridge::world
