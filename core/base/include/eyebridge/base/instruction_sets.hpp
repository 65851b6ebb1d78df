#pragma once

#include <string_view>
#include <type_traits>
#include <vector>

namespace eyebridge::simd {

/// What a source of eyebridge_simd() is compiled for. Plain: for every CPU of its kind; on ARM,
/// NEON.
enum class InstructionSet : unsigned char { Plain, Sse4, Avx2 };

/// Those that this CPU has, the best one first.
std::vector<InstructionSet> instruction_sets();
std::string_view name_of(InstructionSet set);

/// The one that runs: the best that this CPU has, unless a test said otherwise. Any thread.
InstructionSet chosen_set();
/// From now on this one runs, which the CPU has. For tests.
void choose_set(InstructionSet set);

/// The function for chosen_set(); `plain` where a set's own was not compiled.
template <class Function>
Function* best_of(std::type_identity_t<Function>* avx2, std::type_identity_t<Function>* sse4,
                  Function* plain) {
  const InstructionSet set = chosen_set();
  if (set == InstructionSet::Avx2 && avx2 != nullptr) return avx2;
  if (set != InstructionSet::Plain && sse4 != nullptr) return sse4;
  return plain;
}

}  // namespace eyebridge::simd

/// After foreach_target.h: a pointer to the best of `function`, which was compiled in each
/// HWY_NAMESPACE here. Highway has such a macro, too, but it needs Highway's library: that measures
/// a clock whenever a process loads it, 3 ms.
#define EYEBRIDGE_BEST(function)                                                   \
  ::eyebridge::simd::best_of(HWY_CHOOSE_AVX2(function), HWY_CHOOSE_SSE4(function), \
                             HWY_CHOOSE_FALLBACK(function))
