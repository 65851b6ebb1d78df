#pragma once

#include <cstddef>

namespace eyebridge::files {

/// So many cells a `.maz` may have: 512 x 512.
inline constexpr std::size_t kMostMazeCells = 262144;

/// The edge of a cell, metres.
inline constexpr double kLeastMazeCell = 0.01;
inline constexpr double kMostMazeCell = 100.0;

}  // namespace eyebridge::files
