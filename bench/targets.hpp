#pragma once

#include <benchmark/benchmark.h>

namespace eyebridge::bench {

/// Notes a figure of a benchmark under `name`, and what it should be at least, or at most. A run
/// with five rounds or more, as it is without flags, fails where the median misses that by more
/// than a tenth.
void at_least(benchmark::State& state, const char* name, benchmark::Counter value, double target);
void at_most(benchmark::State& state, const char* name, benchmark::Counter value, double target);
/// The same of the CPU time of one iteration, nanoseconds.
void time_at_most(benchmark::State& state, double nanoseconds);

}  // namespace eyebridge::bench
