#pragma once

#include <string>

#include "counting_stream.hpp"
#include "eyebridge/base/clock.hpp"
#include "eyebridge/bridges/byte_stream.hpp"
#include "eyebridge/bridges/client/run_probe.hpp"

namespace eyebridge::apps {

/// How long a board takes to answer its version, asked so many times.
struct RoundTrips {
  int asked = 0;
  int answered = 0;
  Time fastest{0}, median{0}, slowest{0};  ///< Of those that were answered.
};

/// All that a board told.
struct Io7Board {
  bridges::io7::ProbeReport report;
  RoundTrips trips;
  LineCounts line;
  int attempts = 0;  ///< Probes until it was understood.
};

/// Finds out what is behind `stream`: runs the probe for at most `patience`, then asks `v` twenty
/// times. Sends nothing else, and nothing that could move a robot. `clock` is the one of the
/// stream. Fails as io7::Probe does, or with Disconnected; `line` tells what passed even then.
Result<Io7Board> look_at_io7(std::unique_ptr<bridges::ByteStream> stream, Clock& clock,
                             Time patience, LineCounts& line,
                             const bridges::ProbeTiming& timing = {});

/// What a person wants to know of the board, several lines; `url` is how --hal names it.
std::string described(const Io7Board& board, const std::string& url);

/// Why nothing of that came of a line on which `line` passed: one line without the line's name.
/// `baud` is the bit rate of a serial line, 0 of others.
std::string why_no_board(const Error& error, const LineCounts& line, unsigned baud);

}  // namespace eyebridge::apps
