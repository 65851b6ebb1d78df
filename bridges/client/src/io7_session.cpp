#include "io7_session.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "io7_stop.hpp"
#include "opcodes.h"

namespace eyebridge::bridges {
namespace {

using State = io7::ReplyParser::State;

// A line that answers, but wrongly, is noisy: on one that spoils a byte in fifty every seventh
// attempt fails. A silent one is given up sooner.
constexpr int kResyncAttempts = 8;
constexpr int kSilentAttempts = 3;
// A silent board is asked often at first: a question that it did not hear is never answered.
constexpr Time kAskedOften = std::chrono::milliseconds(400);
constexpr Time kSilence = std::chrono::milliseconds(600);  // until it is given up
constexpr int kAttempts = 2;                               // of an exchange
constexpr int kNoisyAttempts = 3;                          // on a line that is known to spoil bytes
constexpr int kQuickAttempts = 5;  // to find back there, before silence counts for a board's
constexpr int kSpoiltMode = 2;  // after so many of them a spoiled byte may have made replies text

// A line may be slower at times than it was while the board was probed.
constexpr int kSlower = 4;
constexpr Time kLongestReply = std::chrono::seconds(1);

Io7Settings fit(Io7Settings settings, const io7::ProbeReport& report) {
  settings.reply_timeout =
      std::max(settings.reply_timeout, std::min(kSlower * report.usual_answer, kLongestReply));
  if (settings.said_timeout) settings.reply_timeout = *settings.said_timeout;
  settings.resync_timeout = std::max(settings.resync_timeout, settings.reply_timeout);
  return settings;
}

bool is_lost(const Error& error) { return error.code == Errc::Disconnected; }

}  // namespace

Io7Session::Io7Session(std::unique_ptr<ByteStream> stream, io7::ProbeReport report, Clock& clock,
                       const Io7Settings& settings, Io7Statistics& statistics)
    : stream_(std::move(stream)),
      report_(std::move(report)),
      clock_(clock),
      settings_(fit(settings, report_)),
      statistics_(statistics),
      last_heard_(clock.now()) {
  report_.profile.vw_letters = settings.vw_letters;
}

Time Io7Session::longest_patience() const {
  if (settings_.said_timeout) return settings_.reply_timeout;
  const Time late = quality_.lateness(clock_.now());
  return std::min(kLongestReply, std::max(settings_.reply_timeout, late + late / 2));
}

Time Io7Session::reply_patience() const {
  if (smoothed_latency_ == Time{0} || quality_.late(clock_.now())) return longest_patience();
  const Time least = noisy() ? settings_.noisy_least : settings_.reply_least;
  return std::clamp(10 * smoothed_latency_, least, settings_.reply_timeout);
}

bool Io7Session::speaks_lines() const {
  return report_.profile.request_form == io7::RequestForm::Ascii;
}

void Io7Session::note_latency(Time latency) {
  ++statistics_.answered;
  statistics_.latency_min = std::min(statistics_.latency_min, latency);
  statistics_.latency_max = std::max(statistics_.latency_max, latency);
  statistics_.latency_sum += latency;
  const Time step = (latency - smoothed_latency_) / 8;
  smoothed_latency_ = smoothed_latency_ == Time{0} ? latency : smoothed_latency_ + step;
  smoothed_latency_ = std::max(smoothed_latency_, Time{1});
}

Result<io7::Reply> Io7Session::exchange(const io7::Request& request) {
  const auto bytes = io7::encode(request, report_.profile);
  if (!bytes) return tl::unexpected(bytes.error());
  ++statistics_.requests;
  orders_.note(request, clock_.now());
  note_turning(request);
  if (!noisy()) return exchange_once(request, *bytes);
  if (auto repeated = repeat_orders(); !repeated) {
    return tl::unexpected(std::move(repeated.error()));
  }
  auto reply = exchange_once(request, *bytes);
  return reply ? confirmed(request, *bytes, *reply) : reply;
}

Result<io7::Reply> Io7Session::exchange_once(const io7::Request& request,
                                             const io7::RequestBytes& bytes) {
  if (auto silent = expect_silence(); !silent) return tl::unexpected(std::move(silent.error()));

  auto reply = ask(request, bytes, reply_patience());
  for (int attempt = 1; !reply && !is_lost(reply.error()); ++attempt) {
    quality_.note_fault(clock_.now());
    const bool timed_out = reply.error().code == Errc::Timeout;
    const std::uint64_t stray = statistics_.stray;
    const Time asked = last_asked_;
    if (auto found = resync(); !found) return tl::unexpected(std::move(found.error()));
    if (timed_out && statistics_.stray > stray) {
      quality_.note_late(clock_.now(), last_drained_ - asked);
    }
    const int most = noisy() ? kNoisyAttempts : kAttempts;
    if (attempt >= most || is_movement(request.letter)) break;
    ++statistics_.retries;
    // A line that was slow once may be so again, and the last time there is no other.
    const bool last = attempt + 1 >= most;
    reply = ask(request, bytes, last ? longest_patience() : reply_patience());
  }
  return reply;
}

// Replies have no frame: what comes before anything is asked is a late or second answer, and more
// of it may follow.
Result<void> Io7Session::expect_silence() {
  const std::uint32_t before = parser_.stray();
  while (true) {
    const auto count = stream_->read_now(buffer_);
    if (!count) return tl::unexpected(count.error());
    for (std::size_t i = 0; i < *count; ++i) parser_.push(buffer_[i]);
    if (*count < buffer_.size()) break;
  }
  const std::uint32_t stray = parser_.stray() - before;
  if (stray == 0) return {};
  statistics_.stray += stray;
  quality_.note_fault(clock_.now());
  return resync();
}

Result<io7::Reply> Io7Session::ask(const io7::Request& request, const io7::RequestBytes& bytes,
                                   Time patience) {
  const Time start = clock_.now();
  tell_guard(start);
  last_asked_ = start;
  parser_.start(request, report_.profile);
  if (auto sent = stream_->write_all(bytes.view(), start + patience); !sent) {
    return tl::unexpected(std::move(sent.error()));
  }
  if (parser_.state() == State::Complete) return parser_.reply();  // Nothing comes back.

  const std::uint32_t before = parser_.stray();
  while (parser_.state() == State::Waiting) {
    const Time deadline = start + patience;
    const Time until = orders_interrupt() ? std::min(deadline, orders_.next_motor()) : deadline;
    const auto count = stream_->read_some(buffer_, until);
    if (!count && count.error().code == Errc::Timeout && until < deadline) {
      if (auto sent = write_orders(); !sent) return tl::unexpected(std::move(sent.error()));
      continue;
    }
    if (!count && count.error().code != Errc::Timeout) return tl::unexpected(count.error());
    if (!count && parser_.quiet() == State::Waiting) {
      ++statistics_.timeouts;
      return fail(Errc::Timeout,
                  std::string(stream_->name()) + ": " + parser_.reply().error().what);
    }
    for (std::size_t i = 0; count && i < *count; ++i) parser_.push(buffer_[i]);
  }
  const std::uint32_t stray = parser_.stray() - before;
  statistics_.stray += stray;
  if (parser_.state() == State::Corrupt) {
    ++statistics_.corrupt;
    return fail(Errc::Corrupt, std::string(stream_->name()) + ": " + parser_.reply().error().what);
  }
  if (stray > 0) {
    // Whose reply the first bytes were, nobody knows.
    ++statistics_.corrupt;
    return fail(Errc::Corrupt, std::string(stream_->name()) + ": IO7 '" + request.letter +
                                   "': " + std::to_string(stray) + " bytes too many came");
  }
  last_heard_ = clock_.now();
  note_latency(last_heard_ - start);
  if (last_heard_ - start > settings_.reply_timeout) {
    quality_.note_late(last_heard_, last_heard_ - start);
  }
  return parser_.reply();
}

Result<std::size_t> Io7Session::drain_until_quiet(Time quiet) {
  // A text board ends a request in part at the next line end; one that takes bytes must see quiet.
  quiet = std::max(quiet, speaks_lines() ? std::min(reply_patience(), settings_.probe.quiet)
                                         : settings_.probe.quiet);
  std::size_t drained = 0;
  const Time end = clock_.now() + settings_.probe.longest;
  while (clock_.now() < end) {
    const auto count = stream_->read_some(buffer_, clock_.now() + quiet);
    if (!count && count.error().code == Errc::Timeout) break;
    if (!count) return tl::unexpected(count.error());
    drained += *count;
    if (*count > 0) last_drained_ = clock_.now();
  }
  return drained;
}

Result<void> Io7Session::resync() {
  ++statistics_.resyncs;
  const auto wake_up = speaks_lines() ? io7::bytes_of(report_.profile.terminator)
                                      : std::span<const std::uint8_t>(kIo7Completion);
  const auto version = io7::request(IO7_VERSION);
  const auto bytes = io7::encode(version, report_.profile);
  if (!bytes) return tl::unexpected(bytes.error());
  std::string found = "nothing";
  int silent = 0;
  const int quick_attempts = noisy() ? kQuickAttempts : 0;
  const Time since = clock_.now();
  for (int attempt = 0; attempt < quick_attempts + kResyncAttempts; ++attempt) {
    if (silent >= kSilentAttempts && clock_.now() - since >= kSilence) break;
    // The first time, an answer that only comes late may still be under way, and tells how late.
    const bool may_be_late = attempt == 0 && !noisy() && !quality_.late(clock_.now());
    const auto late = drain_until_quiet(
        may_be_late ? last_asked_ + 2 * settings_.reply_timeout - clock_.now() : Time{0});
    if (!late) return tl::unexpected(late.error());
    statistics_.stray += *late;
    if (auto repeated = write_orders(); !repeated) return repeated;
    if (attempt >= kSpoiltMode && quick_attempts > 0) quieten();
    auto woken = stream_->write_all(wake_up, clock_.now() + settings_.resync_timeout);
    if (!woken && is_lost(woken.error())) return woken;
    if (auto prompt = drain_until_quiet(); !prompt) return tl::unexpected(prompt.error());
    // Mostly a byte was lost and the board is well: it answers as soon as ever.
    const bool quick = attempt < quick_attempts;
    const bool often = clock_.now() - since < kAskedOften;
    const Time patience =
        often ? longest_patience() : std::max(longest_patience(), settings_.resync_timeout);
    const auto reply = ask(version, *bytes, quick ? reply_patience() : patience);
    if (!reply && is_lost(reply.error())) return tl::unexpected(reply.error());
    if (reply && std::equal(reply->version.begin(), reply->version.end(), report_.version.begin(),
                            report_.version.end())) {
      return {};
    }
    if (!reply && reply.error().code == Errc::Timeout && !quick) ++silent;
    found = reply ? "the version " + std::string(reply->version.begin(), reply->version.end())
                  : reply.error().what;
  }
  return fail(Errc::Disconnected,
              std::string(stream_->name()) +
                  ": the board does not answer any more; expected its version " + report_.version +
                  ", found " + found);
}

}  // namespace eyebridge::bridges
