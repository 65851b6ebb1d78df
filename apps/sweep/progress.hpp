#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

#include "sweep/outcome.hpp"
#include "sweep/plan.hpp"

namespace eyebridge::apps {

/// Tells a person how far a sweep is: a bar on a terminal, else a line for each run.
class Progress {
 public:
  /// `present` runs of `all` are in the results already. `terminal`: `out` is one.
  Progress(std::FILE* out, bool terminal, std::size_t all, std::size_t present);

  /// A run has ended; `elapsed` seconds of real time after the first began.
  void ended(const Cell& cell, const Outcome& outcome, double elapsed);
  /// Ends the bar's line.
  void finish();

 private:
  void draw(double elapsed);

  std::FILE* out_;
  const bool terminal_;
  const std::size_t all_;
  const std::size_t present_;
  std::size_t done_;
  std::size_t bad_ = 0;
};

/// "program seed=3 keep=0.2": a cell in a few words.
std::string short_name(const Cell& cell);

}  // namespace eyebridge::apps
