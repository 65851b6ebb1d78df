#pragma once

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/bridges/byte_stream.hpp"
#include "eyebridge/bridges/io7/probe.hpp"

namespace eyebridge::bridges {

/// How long a probe listens.
struct ProbeTiming {
  Time first_byte = std::chrono::milliseconds(100);  ///< For the beginning of an answer.
  Time quiet = std::chrono::milliseconds(30);        ///< After which an answer has ended.
  Time longest = std::chrono::seconds(2);            ///< Of one answer, for lines that never rest.
};

/// Finds out over `stream` how a board wants to be spoken to, and how long its answers take: runs
/// io7::Probe. `clock` is the one of the stream. Fails as io7::Probe does, or with Disconnected.
Result<io7::ProbeReport> run_probe(ByteStream& stream, Clock& clock,
                                   const ProbeTiming& timing = {});

/// The same, again and again for `patience`: opening a port resets some boards, which are deaf then
/// for a while. A board that answers wrongly twice, or a lost line, ends it at once: a banner may
/// spoil the first probe, not the second. `attempts`, when not null, counts the probes.
Result<io7::ProbeReport> run_probe_patiently(ByteStream& stream, Clock& clock,
                                             const ProbeTiming& timing, Time patience,
                                             int* attempts = nullptr);

}  // namespace eyebridge::bridges
