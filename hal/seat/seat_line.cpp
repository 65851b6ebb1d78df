#include "seat/seat_line.hpp"

#include <algorithm>
#include <utility>

#include "eyebridge/base/uncancelled.hpp"
#include "seat/trace_messages.hpp"

namespace eyebridge::hal {
namespace {

constexpr std::string_view kSeat = "seat";

tl::unexpected<Error> no_answer() {
  return fail(Errc::Corrupt, "what came from the robot's seat is no answer: another version?");
}

}  // namespace

Result<SeatWelcome> SeatLine::hello() {
  const std::lock_guard lock(mutex_);
  const Call call{kSeat, 1, "hello", false, {static_cast<double>(kSeatVersion)}};
  const Result<Message> message = exchange(Time{0}, call, MessageKind::Welcome);
  if (!message) return tl::unexpected(message.error());
  std::optional<SeatWelcome> welcome = decode_welcome(*message);
  if (!welcome) return lose(no_answer().value());
  is_virtual_ = welcome->is_virtual;
  take_time(welcome->now, welcome->limit);
  return std::move(*welcome);
}

Result<Values> SeatLine::ask(const Call& call) {
  const std::lock_guard lock(mutex_);
  return ask_at(now(), call);
}

Time SeatLine::ask_now() {
  // What fails leaves the time as it was.
  static_cast<void>(ask({kSeat, 1, "now", false, {}}));
  return now();
}

void SeatLine::advance_to(Time time) {
  const std::lock_guard lock(mutex_);
  move_to(time);
}

void SeatLine::spend(Time cost) {
  const std::lock_guard lock(mutex_);
  move_to(now() + std::max(cost, Time(0)));
}

void SeatLine::move_to(Time time) {
  if (time <= now()) return;
  if (time >= limit_ && !is_lost_) {
    static_cast<void>(ask_at(time, {kSeat, 1, "now", false, {}}));
    if (!is_lost_) return;
  }
  now_.store(time.count(), std::memory_order_release);
}

void SeatLine::trace_to(TraceSink* sink) {
  const std::lock_guard lock(mutex_);
  const Values wanted{sink != nullptr ? 1.0 : 0.0};
  // What is on its way is still the old one's.
  static_cast<void>(ask_at(now(), {kSeat, 1, "trace", true, wanted}));
  sink_ = sink;
}

Result<Values> SeatLine::ask_at(Time time, const Call& call) {
  const Result<Message> message = exchange(time, call, MessageKind::Reply);
  if (!message) return tl::unexpected(message.error());
  std::optional<SeatReply> reply = decode_reply(*message);
  if (!reply) return lose(no_answer().value());
  take_time(reply->now, reply->limit);
  return std::move(reply->values);
}

Result<Message> SeatLine::exchange(Time time, const Call& call, MessageKind expected) {
  if (is_lost_) return fail(Errc::Disconnected, "the robot's seat is gone");
  const SeatRequest request{
      time,        std::string(call.device), call.id, std::string(call.name), call.is_command,
      call.request};
  const Uncancelled until_answered;  // the next one would have this answer
  const Result<void> sent = stream_.send(encode(request));
  if (!sent) return lose(sent.error());
  for (;;) {
    Result<Message> message = stream_.receive();
    if (!message) return lose(message.error());
    const auto kind = kind_of(*message);
    if (kind == expected) return message;
    if (kind == MessageKind::Reply && expected == MessageKind::Welcome) {
      // Why there is none.
      const std::optional<SeatReply> reply = decode_reply(*message);
      if (reply && !reply->values) return lose(reply->values.error());
    }
    TraceMessages nobody;
    const bool is_trace =
        kind == MessageKind::Trace && tell_trace(*message, sink_ != nullptr ? *sink_ : nobody);
    if (!is_trace) return lose(no_answer().value());
  }
}

void SeatLine::take_time(Time now, Time limit) {
  now_.store(std::max(this->now(), now).count(), std::memory_order_release);
  limit_ = limit;
}

tl::unexpected<Error> SeatLine::lose(Error why) {
  is_lost_ = true;
  return tl::unexpected(std::move(why));
}

}  // namespace eyebridge::hal
