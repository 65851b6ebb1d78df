#include "eyebridge/bridges/client/io7_client.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "eyebridge/bridges/guard/line_guard.hpp"
#include "io7_session.hpp"
#include "io7_stop.hpp"

namespace eyebridge::bridges {
namespace {

constexpr const char* kNoSuchBoard =
    "; expected an EyeBot I/O board: is it another device, or another bit rate?";

std::string describe(const io7::ProbeReport& report) {
  char supply[48] = "";
  if (report.battery_cv) {
    std::snprintf(supply, sizeof supply, ", supply %.2f V", *report.battery_cv / 100.0);
  }
  const io7::Profile& profile = report.profile;
  return "IO7 board, version " + report.version + supply + ", " +
         (profile.request_form == io7::RequestForm::Ascii ? "text" : "binary") + " requests, " +
         (profile.reply_form == io7::ReplyForm::Text ? "text" : "raw") + " replies";
}

/// What the user said goes first. Fails where a wrong guess would leave the wheels and the sensors
/// dead without a word.
Result<void> settle(io7::ProbeReport& report, const Io7Settings& settings) {
  if (settings.said_requests) report.profile.request_form = *settings.said_requests;
  if (settings.said_byte_order) report.profile.byte_order = *settings.said_byte_order;
  report.byte_order_proven = report.byte_order_proven || settings.said_byte_order.has_value();
  if (report.request_form_proven || settings.said_requests) return {};
  return fail(Errc::Unsupported,
              "the board lists no reading that would tell whether its requests are text or bytes; "
              "expected requests=text or requests=bytes in the URL");
}

}  // namespace

Io7Client::Io7Client(StreamOpener open, Clock& clock, LogSink& log, const Io7Settings& settings)
    : open_(std::move(open)),
      clock_(clock),
      log_(log),
      settings_(settings),
      loss_{Errc::Disconnected, "IO7 board: not connected"},
      backoff_(settings.first_backoff) {}

Io7Client::~Io7Client() = default;

Result<void> Io7Client::connect() { return find_board(settings_.boot_patience); }

Result<void> Io7Client::find_board(Time patience) {
  auto stream = open_();
  if (!stream) return tl::unexpected(std::move(stream.error()));
  auto report = run_probe_patiently(**stream, clock_, settings_.probe, patience);
  if (!report) {
    const bool odd = report.error().code != Errc::Disconnected;
    return fail(report.error().code, std::string((*stream)->name()) + ": " + report.error().what +
                                         (odd ? kNoSuchBoard : ""));
  }
  if (auto settled = settle(*report, settings_); !settled) {
    return fail(settled.error().code, std::string((*stream)->name()) + ": " + settled.error().what);
  }
  // Made ready before anybody else can reach it.
  Io7Statistics counts;
  auto session = std::make_unique<Io7Session>(std::move(*stream), std::move(*report), clock_,
                                              settings_, counts);
  if (auto stopped = session->stop_motors(); !stopped) return stopped;
  note_found(session->report(), session->stream().name());

  const std::lock_guard lock(mutex_);
  report_ = session->report();
  session_ = std::make_unique<Io7Session>(session->release_stream(), *report_, clock_, settings_,
                                          statistics_);
  backoff_ = settings_.first_backoff;
  ++statistics_.connects;
  ++generation_;
  auto guarded = guard();
  if (guarded || generation_ == 1) return guarded;
  // A board that is back is worth more than its guard.
  log_.write(Severity::Error, std::string(session_->stream().name()) + ": " + guarded.error().what);
  return {};
}

Result<void> Io7Client::guard() {
  if (!settings_.guarded) return {};
  if (guard_ == nullptr) {
    auto started = LineGuard::start();
    if (!started) return tl::unexpected(std::move(started.error()));
    guard_ = std::move(*started);
  }
  ByteStream& line = session_->stream();
  session_->guard_with(guard_.get());
  return guard_->hold(line.descriptor(), line.name(), stop_orders(*report_));
}

void Io7Client::note_guard() {
  if (guard_ == nullptr || session_ == nullptr || session_->is_guarded()) return;
  guard_.reset();
  log_.write(Severity::Error,
             std::string(session_->stream().name()) +
                 ": its guard was ended: nobody stops the motors if the program crashes");
}

void Io7Client::note_found(const io7::ProbeReport& report, std::string_view name) const {
  const std::string where(name);
  log_.write(Severity::Info, where + ": " + describe(report));
  log_.write(Severity::Debug, where + ": its command list: " + report.list);
  if (!report.byte_order_proven && report.profile.reply_form == io7::ReplyForm::Raw) {
    log_.write(Severity::Warning,
               where +
                   ": its readings could be read both ways round: most significant byte first "
                   "is assumed; order=msb or order=lsb in the URL says which");
  }
}

void Io7Client::lose(const Error& error) {
  loss_ = error;
  // Its descriptor would keep the line busy. When the guard is gone nothing keeps it.
  if (guard_ != nullptr && !guard_->let_go()) {
    guard_.reset();
    log_.write(Severity::Warning,
               "the IO7 board's guard was ended; another one begins when the board is back");
  }
  session_.reset();
  ++statistics_.losses;
  retry_at_ = clock_.now() + backoff_;
  log_.write(Severity::Error, error.what + "; it is looked for again");
}

Result<io7::Reply> Io7Client::exchange(const io7::Request& request, Time* asked) {
  const std::lock_guard lock(mutex_);
  if (session_ == nullptr) return tl::unexpected(loss_);
  auto reply = session_->exchange(request);
  if (asked != nullptr) *asked = session_->last_asked();
  note_guard();
  if (!reply && reply.error().code == Errc::Disconnected) lose(reply.error());
  return reply;
}

Result<void> Io7Client::confirm_stop() {
  const std::lock_guard lock(mutex_);
  if (session_ == nullptr) return tl::unexpected(loss_);
  auto stopped = session_->confirm_stop();
  note_guard();
  if (!stopped && stopped.error().code == Errc::Disconnected) lose(stopped.error());
  return stopped;
}

Result<void> Io7Client::keep_alive() {
  if (clock_.now() - session_->last_heard() < settings_.idle) return session_->repeat_orders();
  return session_->exchange(io7::request(IO7_VERSION)).map([](const io7::Reply&) {});
}

bool Io7Client::look_after() {
  {
    const std::lock_guard lock(mutex_);
    if (session_ != nullptr) {
      if (const auto alive = keep_alive(); !alive && alive.error().code == Errc::Disconnected) {
        lose(alive.error());
      }
      return false;
    }
    if (generation_ == 0 || clock_.now() < retry_at_) return false;
  }
  if (const auto found = find_board(Time{0}); !found) {
    const std::lock_guard lock(mutex_);
    backoff_ = std::min(2 * backoff_, settings_.longest_backoff);
    retry_at_ = clock_.now() + backoff_;
    return false;
  }
  log_.write(Severity::Warning,
             "the IO7 board was plugged in again or has rebooted: its encoders and pose are lost, "
             "all motors stand");
  return true;
}

std::uint32_t Io7Client::generation() const {
  const std::lock_guard lock(mutex_);
  return generation_;
}

bool Io7Client::has(char letter) const {
  const std::lock_guard lock(mutex_);
  return session_ != nullptr && session_->report().profile.letters.has(letter);
}

std::optional<io7::ProbeReport> Io7Client::report() const {
  const std::lock_guard lock(mutex_);
  return report_;
}

Io7Statistics Io7Client::statistics() const {
  const std::lock_guard lock(mutex_);
  return statistics_;
}

}  // namespace eyebridge::bridges
