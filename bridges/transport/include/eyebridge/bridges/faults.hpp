#pragma once

#include <cstdint>
#include <vector>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::bridges {

/// One kind of damage to a line.
enum class FaultKind {
  Drop,    ///< The byte or frame never arrives.
  Flip,    ///< A bit of it arrives inverted.
  Delay,   ///< It arrives late, and everything behind it.
  Repeat,  ///< It arrives twice.
  Split,   ///< Bytes only: a chunk ends before it.
  Unplug,  ///< The line is cut before it, for good.
};

/// A fault at a certain place.
struct ScriptedFault {
  std::uint64_t at = 0;  ///< Which byte or frame of that direction, from 0.
  FaultKind kind = FaultKind::Drop;
  unsigned bit = 0;  ///< Flip: which bit, 0 … 7 of a byte, 0 … 511 of a frame's data.
};

/// What goes wrong in one direction: by chance (probabilities 0 … 1) and by script.
struct LineFaults {
  double drop = 0;                    ///< Of each byte or frame.
  double flip = 0;                    ///< Of each byte or frame: one bit of it.
  double repeat = 0;                  ///< Of each byte or frame.
  double split = 0;                   ///< Of each byte: a chunk ends before it.
  double merge = 0;                   ///< Of each chunk: comes together with the next one.
  double delay = 0;                   ///< Of each chunk or frame.
  Time delay_by{};                    ///< How late that is.
  std::vector<ScriptedFault> script;  ///< In any order.
};

/// Everything that goes wrong on a line. The same seed damages the same bytes or frames.
struct FaultPlan {
  std::uint64_t seed = 0;
  LineFaults incoming;
  LineFaults outgoing;
};

/// How often what was done, both directions together.
struct FaultCounts {
  std::uint64_t dropped = 0;
  std::uint64_t flipped = 0;
  std::uint64_t repeated = 0;
  std::uint64_t split = 0;
  std::uint64_t merged = 0;
  std::uint64_t delayed = 0;

  friend bool operator==(const FaultCounts&, const FaultCounts&) = default;
};

}  // namespace eyebridge::bridges
