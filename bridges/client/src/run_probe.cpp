#include "eyebridge/bridges/client/run_probe.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace eyebridge::bridges {
namespace {

constexpr int kWrongAnswers = 2;
constexpr std::size_t kMostBytes = 8192;  // twice the longest command list

struct Heard {
  std::vector<std::uint8_t> bytes;
  Time after{0};  ///< Which the first of them came.
};

/// Everything that comes until the line is quiet.
Result<Heard> listen(ByteStream& stream, Clock& clock, const ProbeTiming& timing) {
  Heard heard;
  const Time start = clock.now();
  const Time end = start + timing.longest;
  Time deadline = clock.now() + timing.first_byte;
  std::array<std::uint8_t, 256> buffer;
  while (heard.bytes.size() < kMostBytes) {
    const auto count = stream.read_some(buffer, std::min(deadline, end));
    if (!count && count.error().code == Errc::Timeout) break;
    if (!count) return tl::unexpected(count.error());
    if (heard.bytes.empty()) heard.after = clock.now() - start;
    heard.bytes.insert(heard.bytes.end(), buffer.begin(),
                       buffer.begin() + static_cast<std::ptrdiff_t>(*count));
    deadline = clock.now() + timing.quiet;
    if (clock.now() >= end) break;
  }
  return heard;
}

}  // namespace

Result<io7::ProbeReport> run_probe(ByteStream& stream, Clock& clock, const ProbeTiming& timing) {
  // What lies there from an earlier session is no answer to anything.
  if (auto stale = listen(stream, clock, {timing.quiet, timing.quiet, timing.longest}); !stale) {
    return tl::unexpected(std::move(stale.error()));
  }
  io7::Probe probe;
  std::vector<Time> answers;
  while (!probe.done()) {
    if (auto sent = stream.write_all(probe.step().send, clock.now() + timing.longest); !sent) {
      return tl::unexpected(std::move(sent.error()));
    }
    auto heard = listen(stream, clock, timing);
    if (!heard) return tl::unexpected(std::move(heard.error()));
    if (!heard->bytes.empty()) answers.push_back(heard->after);
    probe.answer(heard->bytes);
  }
  return probe.report().map([&](io7::ProbeReport report) {
    std::ranges::sort(answers);
    if (!answers.empty()) report.usual_answer = answers[answers.size() / 2];
    return report;
  });
}

Result<io7::ProbeReport> run_probe_patiently(ByteStream& stream, Clock& clock,
                                             const ProbeTiming& timing, Time patience,
                                             int* attempts) {
  const Time end = clock.now() + patience;
  int wrong = 0;
  while (true) {
    auto report = run_probe(stream, clock, timing);
    if (attempts != nullptr) ++*attempts;
    if (report || report.error().code == Errc::Disconnected) return report;
    wrong += report.error().code == Errc::Timeout ? 0 : 1;
    if (wrong == kWrongAnswers || clock.now() >= end) return report;
  }
}

}  // namespace eyebridge::bridges
