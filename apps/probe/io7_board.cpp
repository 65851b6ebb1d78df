#include "io7_board.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include "eyebridge/base/text.hpp"
#include "eyebridge/bridges/io7/reply_parser.hpp"
#include "opcodes.h"

namespace eyebridge::apps {
namespace {

using namespace bridges;
using State = io7::ReplyParser::State;

constexpr int kVersions = 20;
constexpr Time kReplyPatience = std::chrono::milliseconds(200);

/// Asks `v` once; whether the answer was the one that is expected.
Result<bool> ask_version(ByteStream& stream, Clock& clock, const io7::Profile& profile) {
  const auto version = io7::request(IO7_VERSION);
  const auto bytes = io7::encode(version, profile);
  if (!bytes) return tl::unexpected(bytes.error());
  const Time end = clock.now() + kReplyPatience;
  if (auto sent = stream.write_all(bytes->view(), end); !sent) {
    return tl::unexpected(std::move(sent.error()));
  }
  io7::ReplyParser parser;
  parser.start(version, profile);
  std::array<std::uint8_t, 64> buffer;
  while (parser.state() == State::Waiting) {
    const auto count = stream.read_some(buffer, end);
    if (!count && count.error().code != Errc::Timeout) return tl::unexpected(count.error());
    if (!count) return false;
    for (std::size_t i = 0; i < *count; ++i) parser.push(buffer[i]);
  }
  return parser.state() == State::Complete && parser.stray() == 0;
}

Result<RoundTrips> time_versions(ByteStream& stream, Clock& clock, const io7::Profile& profile) {
  RoundTrips trips;
  std::vector<Time> taken;
  for (; trips.asked < kVersions; ++trips.asked) {
    const Time start = clock.now();
    const auto good = ask_version(stream, clock, profile);
    if (!good) return tl::unexpected(good.error());
    if (*good) taken.push_back(clock.now() - start);
  }
  trips.answered = static_cast<int>(taken.size());
  if (taken.empty()) return trips;
  std::sort(taken.begin(), taken.end());
  trips.fastest = taken.front();
  trips.median = taken[taken.size() / 2];
  trips.slowest = taken.back();
  return trips;
}

}  // namespace

Result<Io7Board> look_at_io7(std::unique_ptr<ByteStream> stream, Clock& clock, Time patience,
                             LineCounts& line, const ProbeTiming& timing) {
  const auto counted = make_counting(std::move(stream), line);
  Io7Board board;
  auto report = run_probe_patiently(*counted, clock, timing, patience, &board.attempts);
  if (!report) return tl::unexpected(std::move(report.error()));
  board.report = std::move(*report);
  auto trips = time_versions(*counted, clock, board.report.profile);
  if (!trips) return tl::unexpected(std::move(trips.error()));
  board.trips = *trips;
  board.line = line;
  return board;
}

std::string why_no_board(const Error& error, const LineCounts& line, unsigned baud) {
  const std::string rate =
      baud == 0 ? ""
                : fmt::format(
                      ", {} bits per second (now; a USB board takes any, others as in "
                      "serial:DEVICE?baud=9600)",
                      baud);
  if (error.code == Errc::Disconnected) return error.what;
  if (line.received == 0) {
    return fmt::format(
        "nothing answers; expected an EyeBot I/O board that is switched on and "
        "runs its firmware{}",
        rate);
  }
  const auto printable = std::count_if(line.first.begin(), line.first.end(), [](char c) {
    return (c >= ' ' && c <= '~') || c == '\r' || c == '\n' || c == '\t';
  });
  const bool is_text = printable * 10 >= static_cast<std::ptrdiff_t>(line.first.size()) * 9;
  const std::string said = in_quotes(trimmed(line.first));
  if (is_text) {
    return fmt::format("something answers, but not as an EyeBot I/O board does: {}; found {}",
                       error.what, said);
  }
  return fmt::format("what comes is no text: {}; expected an EyeBot I/O board{}", said, rate);
}

}  // namespace eyebridge::apps
