// What an Io7Session does on a line that is known to spoil bytes.
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "agreement.hpp"
#include "io7_session.hpp"

namespace eyebridge::bridges {
namespace {

constexpr int kReadings = 6;  // that are compared before none is believed

}  // namespace

Result<io7::Reply> Io7Session::confirmed(const io7::Request& request,
                                         const io7::RequestBytes& bytes, const io7::Reply& first) {
  const io7::ReplyKind kind = io7::find_command(request.letter)->reply;
  if (kind == io7::ReplyKind::Values) return agreed(request, bytes, first);
  if (kind == io7::ReplyKind::None && is_unanswered() && !is_movement(request.letter)) {
    ++statistics_.repeated;
    auto sent = stream_->write_all(bytes.view(), clock_.now() + settings_.reply_timeout);
    if (!sent) return tl::unexpected(std::move(sent.error()));
  }
  return first;
}

// Any two of them, so that one that was spoiled costs one more, not all.
Result<io7::Reply> Io7Session::agreed(const io7::Request& request, const io7::RequestBytes& bytes,
                                      const io7::Reply& first) {
  struct Reading {
    io7::Reply reply;
    Time at{0};
  };
  std::array<Reading, kReadings> readings;
  readings[0] = {first, last_heard_};
  std::size_t count = 1;
  for (int attempt = 1; attempt < kReadings; ++attempt) {
    auto reply = exchange_once(request, bytes);
    if (!reply && reply.error().code == Errc::Disconnected) return reply;
    if (!reply) continue;
    const auto fits = [&](const Reading& one) {
      return agree(one.reply, *reply, last_heard_ - one.at);
    };
    if (std::any_of(readings.begin(), readings.begin() + static_cast<std::ptrdiff_t>(count),
                    fits)) {
      return reply;
    }
    ++statistics_.disagreements;
    quality_.note_fault(clock_.now());
    readings[count++] = {*reply, last_heard_};
  }
  return fail(Errc::Corrupt, std::string(stream_->name()) + ": IO7 '" + request.letter +
                                 "': the line is noisy, and no two readings agree");
}

Result<void> Io7Session::repeat_orders() {
  if (!orders_stand()) return {};
  if (is_unanswered()) return write_orders();
  while (const io7::Request* order = orders_.due(clock_.now())) {
    ++statistics_.repeated;
    const auto bytes = io7::encode(*order, report_.profile);
    if (!bytes || ask(*order, *bytes, reply_patience())) continue;
    return resync();
  }
  return {};
}

Result<void> Io7Session::write_orders() {
  if (!orders_stand() || !is_unanswered()) return {};
  bool any = false;
  const Time deadline = clock_.now() + settings_.reply_timeout;
  while (const io7::Request* order = orders_.due(clock_.now())) {
    ++statistics_.repeated;
    const auto bytes = io7::encode(*order, report_.profile);
    if (!bytes) continue;
    any = true;
    auto sent = stream_->write_all(bytes->view(), deadline);
    if (!sent) return sent;
  }
  // One whose end was spoiled must not swallow what follows it; a prompt would answer an empty
  // line.
  if (!any || !speaks_lines() || !report_.profile.prompt.view().empty()) return {};
  return stream_->write_all(io7::bytes_of(report_.profile.terminator), deadline);
}

void Io7Session::quieten() {
  if (report_.profile.reply_form != io7::ReplyForm::Raw) return;
  const auto raw = io7::encode(io7::verbose(false), report_.profile);
  if (raw) (void)stream_->write_all(raw->view(), clock_.now() + settings_.reply_timeout);
}

// A board that is silent must find nobody at the line, and stop its motors.
bool Io7Session::orders_stand() const {
  return noisy() && clock_.now() - last_heard_ < 2 * settings_.idle;
}

bool Io7Session::is_unanswered() const {
  const io7::Profile& profile = report_.profile;
  const bool prompts = !profile.prompt.view().empty() &&
                       (profile.reply_form == io7::ReplyForm::Text || profile.prompt_after_raw);
  return !profile.echo && !prompts;
}

// A board that takes bytes would take those of an order for arguments of the request that it is
// still waiting for.
bool Io7Session::orders_interrupt() const {
  return speaks_lines() && is_unanswered() && orders_stand();
}

}  // namespace eyebridge::bridges
