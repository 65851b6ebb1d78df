#pragma once

#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

#include "entry.hpp"
#include "sweep/outcome.hpp"
#include "sweep/sweep_file.hpp"

namespace eyebridge::fuzz {

/// A sweep file: of what is accepted, all cells are different runs.
inline void sweep(std::string_view text) {
  try {
    const apps::SweepPlan plan = apps::read_sweep(text, "fuzz.toml");
    std::size_t count = 1;
    for (const apps::Axis& axis : plan.axes) {
      if (axis.values.empty()) found();
      count *= axis.values.size();
      if (count > 10'000) return;  // more of the same
    }
    if (apps::cells_of(plan).size() != count) found();
  } catch (const ConfigError&) {  // the input is no sweep
  }
}

/// What one process tells another of a run: what is accepted is written as it was.
inline void outcome(std::string_view text) {
  try {
    const std::string once = apps::to_text(apps::outcome_from_text(std::string(text)));
    if (apps::to_text(apps::outcome_from_text(once)) != once) found();
  } catch (const std::runtime_error&) {  // the input is no outcome
  }
}

}  // namespace eyebridge::fuzz
