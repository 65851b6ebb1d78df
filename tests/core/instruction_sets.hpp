#pragma once

#include <cstdint>
#include <vector>

#include <hwy/targets.h>

namespace eyebridge {

/// While it lives, Highway's code runs with one instruction set: a HWY_ value, e. g. HWY_AVX2.
class InstructionSet {
 public:
  explicit InstructionSet(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(target);
  }
  ~InstructionSet() {
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().DeInit();
  }
  InstructionSet(const InstructionSet&) = delete;
  InstructionSet& operator=(const InstructionSet&) = delete;
};

/// Those that our code is compiled for and that this CPU has.
inline std::vector<std::int64_t> instruction_sets() { return hwy::SupportedAndGeneratedTargets(); }

/// Calls check(name) with each of them in turn.
template <class Check>
void in_every_instruction_set(Check check) {
  for (const std::int64_t target : instruction_sets()) {
    const InstructionSet chosen(target);
    check(hwy::TargetName(target));
  }
}

}  // namespace eyebridge
