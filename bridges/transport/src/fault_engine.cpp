#include "fault_engine.hpp"

#include <algorithm>
#include <cassert>

namespace eyebridge::bridges {
namespace {

[[maybe_unused]] bool is_probability(double p) { return p >= 0.0 && p <= 1.0; }

}  // namespace

FaultEngine::FaultEngine(const LineFaults& faults, std::uint64_t seed, std::uint64_t direction)
    : faults_(faults),
      drop_(seed, 10 * direction),
      flip_(seed, 10 * direction + 1),
      repeat_(seed, 10 * direction + 2),
      split_(seed, 10 * direction + 3),
      delay_(seed, 10 * direction + 4),
      merge_(seed, 10 * direction + 5) {
  assert(is_probability(faults.drop) && is_probability(faults.flip) &&
         is_probability(faults.repeat) && is_probability(faults.split) &&
         is_probability(faults.merge) && is_probability(faults.delay));
  std::ranges::stable_sort(faults_.script, {}, &ScriptedFault::at);
}

Fate FaultEngine::next(unsigned bits) {
  Fate fate;
  fate.drop = drop_.chance(faults_.drop);
  // The bit is drawn in any case, so that hits do not shift those that follow.
  const bool flips = flip_.chance(faults_.flip);
  const auto bit = static_cast<unsigned>(flip_.bits() % std::max(bits, 1U));
  if (flips) fate.flip = bit;
  fate.repeat = repeat_.chance(faults_.repeat);
  fate.split = split_.chance(faults_.split);
  while (next_script_ < faults_.script.size() && faults_.script[next_script_].at == position_) {
    const ScriptedFault& fault = faults_.script[next_script_++];
    switch (fault.kind) {
      case FaultKind::Drop:
        fate.drop = true;
        break;
      case FaultKind::Flip:
        fate.flip = fault.bit % std::max(bits, 1U);
        break;
      case FaultKind::Delay:
        fate.delay = true;
        break;
      case FaultKind::Repeat:
        fate.repeat = true;
        break;
      case FaultKind::Split:
        fate.split = true;
        break;
      case FaultKind::Unplug:
        fate.unplug = true;
        break;
    }
  }
  ++position_;
  if (fate.unplug) return fate;
  if (fate.drop) {
    count(&FaultCounts::dropped);
    fate.flip.reset();
    fate.repeat = false;
  }
  if (bits == 0) fate.flip.reset();
  if (fate.flip) count(&FaultCounts::flipped);
  if (fate.repeat) count(&FaultCounts::repeated);
  return fate;
}

void FaultEngine::count(std::uint64_t FaultCounts::*kind) {
  const std::lock_guard lock(mutex_);
  ++(counts_.*kind);
}

FaultCounts FaultEngine::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

FaultCounts operator+(const FaultCounts& a, const FaultCounts& b) {
  return {a.dropped + b.dropped, a.flipped + b.flipped, a.repeated + b.repeated,
          a.split + b.split,     a.merged + b.merged,   a.delayed + b.delayed};
}

}  // namespace eyebridge::bridges
