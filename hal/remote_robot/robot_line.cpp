#include "remote_robot/robot_line.hpp"

#include <algorithm>
#include <utility>

#include "eyebridge/base/uncancelled.hpp"
#include "remote_robot/trace_messages.hpp"

namespace eyebridge::hal {
namespace {

using Wait = MessageStream::Wait;

constexpr std::string_view kServer = "robot";

tl::unexpected<Error> no_answer() {
  return fail(Errc::Corrupt, "what came from the robot's server is no answer: another version?");
}

}  // namespace

Result<RobotWelcome> RobotLine::hello() {
  const std::lock_guard lock(mutex_);
  const Uncancelled until_welcome;
  Result<LineMemory> memory = LineMemory::accept(socket_.get());
  if (!memory) return lose(memory.error());
  stream_.emplace(socket_.get(), std::move(*memory), MessageStream::End::Program);
  const Call call{kServer, 1, "hello", false, {static_cast<double>(kRobotLineVersion)}};
  const Result<Message> message =
      exchange(Time{0}, call, MessageKind::Welcome, MessageStream::Wait::Asleep);
  if (!message) return tl::unexpected(message.error());
  std::optional<RobotWelcome> welcome = decode_welcome(*message);
  if (!welcome) return lose(no_answer().value());
  is_virtual_ = welcome->is_virtual;
  take_time(welcome->now, welcome->limit);
  return std::move(*welcome);
}

Result<Values> RobotLine::ask(const Call& call) {
  const std::lock_guard lock(mutex_);
  return ask_at(now(), call);
}

Time RobotLine::ask_now() {
  // What fails leaves the time as it was.
  static_cast<void>(ask({kServer, 1, "now", false, {}}));
  return now();
}

void RobotLine::advance_to(Time time) {
  const std::lock_guard lock(mutex_);
  move_to(time);
}

void RobotLine::spend(Time cost) {
  const std::lock_guard lock(mutex_);
  move_to(now() + std::max(cost, Time(0)));
}

void RobotLine::move_to(Time time) {
  if (time <= now()) return;
  if (time >= limit_ && !is_lost_) {
    static_cast<void>(ask_at(time, {kServer, 1, "now", false, {}}, Wait::Asleep));
    if (!is_lost_) return;
  }
  now_.store(time.count(), std::memory_order_release);
}

void RobotLine::trace_to(TraceSink* sink) {
  const std::lock_guard lock(mutex_);
  const Values wanted{sink != nullptr ? 1.0 : 0.0};
  // What is on its way is still the old one's.
  static_cast<void>(ask_at(now(), {kServer, 1, "trace", true, wanted}));
  sink_ = sink;
}

Result<Values> RobotLine::ask_at(Time time, const Call& call, Wait wait) {
  const Result<Message> message = exchange(time, call, MessageKind::Reply, wait);
  if (!message) return tl::unexpected(message.error());
  std::optional<RobotReply> reply = decode_reply(*message);
  if (!reply) return lose(no_answer().value());
  take_time(reply->now, reply->limit);
  return std::move(reply->values);
}

Result<Message> RobotLine::exchange(Time time, const Call& call, MessageKind expected, Wait wait) {
  if (is_lost_ || !stream_) return fail(Errc::Disconnected, "the robot's server is gone");
  const RobotRequest request{
      time,        std::string(call.device), call.id, std::string(call.name), call.is_command,
      call.request};
  const Uncancelled until_answered;  // the next one would have this answer
  const Result<void> sent = stream_->send(encode(request));
  if (!sent) return lose(sent.error());
  for (;;) {
    Result<Message> message = stream_->receive(wait);
    if (!message) return lose(message.error());
    const auto kind = kind_of(*message);
    if (kind == expected) return message;
    if (kind == MessageKind::Reply && expected == MessageKind::Welcome) {
      // Why there is none.
      const std::optional<RobotReply> reply = decode_reply(*message);
      if (reply && !reply->values) return lose(reply->values.error());
    }
    TraceMessages nobody;
    const bool is_trace =
        kind == MessageKind::Trace && tell_trace(*message, sink_ != nullptr ? *sink_ : nobody);
    if (!is_trace) return lose(no_answer().value());
  }
}

void RobotLine::take_time(Time now, Time limit) {
  now_.store(std::max(this->now(), now).count(), std::memory_order_release);
  limit_ = limit;
}

tl::unexpected<Error> RobotLine::lose(Error why) {
  is_lost_ = true;
  return tl::unexpected(std::move(why));
}

}  // namespace eyebridge::hal
