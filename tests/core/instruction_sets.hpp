#pragma once

#include <string>

#include "eyebridge/base/instruction_sets.hpp"

namespace eyebridge {

/// While it lives, code of eyebridge_simd() runs with this instruction set.
class ChosenSet {
 public:
  explicit ChosenSet(simd::InstructionSet set) { simd::choose_set(set); }
  ~ChosenSet() { simd::choose_set(simd::instruction_sets().front()); }
  ChosenSet(const ChosenSet&) = delete;
  ChosenSet& operator=(const ChosenSet&) = delete;
};

/// Calls check(name) with each of the CPU's in turn.
template <class Check>
void in_every_instruction_set(Check check) {
  for (const simd::InstructionSet set : simd::instruction_sets()) {
    const ChosenSet chosen(set);
    check(std::string(simd::name_of(set)));
  }
}

}  // namespace eyebridge
