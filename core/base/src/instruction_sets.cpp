#include "eyebridge/base/instruction_sets.hpp"

#include <atomic>

namespace eyebridge::simd {
namespace {

InstructionSet best_set() {
#ifdef __x86_64__
  // Static objects may ask before the compiler's own start-up code ran.
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
      __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2")) {
    return InstructionSet::Avx2;
  }
  if (__builtin_cpu_supports("sse4.2")) return InstructionSet::Sse4;
#endif
  return InstructionSet::Plain;
}

std::atomic<InstructionSet>& chosen() {
  static std::atomic<InstructionSet> set = best_set();
  return set;
}

}  // namespace

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> sets;
  for (const auto set : {InstructionSet::Avx2, InstructionSet::Sse4, InstructionSet::Plain}) {
    if (set <= best_set()) sets.push_back(set);
  }
  return sets;
}

std::string_view name_of(InstructionSet set) {
  switch (set) {
    case InstructionSet::Avx2:
      return "AVX2";
    case InstructionSet::Sse4:
      return "SSE4";
    case InstructionSet::Plain:
      break;
  }
  return "Plain";
}

InstructionSet chosen_set() { return chosen().load(std::memory_order_relaxed); }
void choose_set(InstructionSet set) { chosen() = set; }

}  // namespace eyebridge::simd
