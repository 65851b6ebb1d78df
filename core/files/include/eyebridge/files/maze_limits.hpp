#pragma once

#include <cstddef>

namespace eyebridge::files {

/// So many cells a `.maz` may have: 512 x 512.
inline constexpr std::size_t kMostMazeCells = 262144;

}  // namespace eyebridge::files
