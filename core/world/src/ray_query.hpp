#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace eyebridge::world {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// A ray on its way through a grid. Ranges are metres from the ray's origin.
struct RayState {
  double next[2];     ///< Range to the next border of columns, and of rows; or infinite.
  double between[2];  ///< Range from one such border to the next.
  double limit;       ///< Range at which it leaves the grid.
  std::size_t cell;
  std::size_t step[2];  ///< To the cell beyond the next border; modulo 2^64 when it is before.
};

/// Neighbours of a fan that go through a grid together, and the ranges found so far.
struct RayGroup {
  static constexpr std::size_t kMost = 128;
  /// Where fewer cells around are empty, they are crossed one by one: a leap takes a division.
  static constexpr std::size_t kLeap = 3;
  alignas(64) double dx[kMost];  ///< Up to a multiple of eight there are some.
  alignas(64) double dy[kMost];
  alignas(64) double best[kMost];
  RayState states[kMost];
  std::uint32_t active[kMost];  ///< Indices of the rays that have not ended yet, ascending.
  std::size_t left = 0;         ///< How many those are.
};

}  // namespace eyebridge::world
