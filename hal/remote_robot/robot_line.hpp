#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "calls/interceptor.hpp"
#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/hal/trace.hpp"
#include "remote_robot/message.hpp"
#include "remote_robot/message_stream.hpp"

namespace eyebridge::hal {

/// The program's end of the line to its robot's server: one question at a time, and the robot's
/// time, which the answers bring along. Any thread.
///
/// Once the other end is gone every question fails with Disconnected, and virtual time passes
/// without it, so that nobody waits for ever.
class RobotLine {
 public:
  explicit RobotLine(UniqueFd socket) : socket_(std::move(socket)) {}

  /// The first question. In real time it returns when all robots are there. Fails with
  /// Disconnected, Corrupt, and as the server says.
  Result<RobotWelcome> hello();
  /// Asks the server. Fails as the device does there, with Disconnected, and with Corrupt for an
  /// answer that is none.
  Result<Values> ask(const Call& call);

  /// The robot's time as it was last known; in virtual time it is the time.
  [[nodiscard]] Time now() const { return Time(now_.load(std::memory_order_acquire)); }
  /// In real time: the time as it is.
  Time ask_now();
  /// In virtual time: returns when it is `time`, or `cost` later.
  void advance_to(Time time);
  void spend(Time cost);
  [[nodiscard]] bool is_lost() const { return is_lost_; }

  /// As Backend::trace_to(): points come with the answers.
  void trace_to(TraceSink* sink);

 private:
  // mutex_ is held.
  Result<Message> exchange(Time time, const Call& call, MessageKind expected,
                           MessageStream::Wait wait);
  Result<Values> ask_at(Time time, const Call& call,
                        MessageStream::Wait wait = MessageStream::Wait::Awake);
  void move_to(Time time);
  void take_time(Time now, Time limit);
  tl::unexpected<Error> lose(Error why);

  const UniqueFd socket_;
  std::optional<MessageStream> stream_;  ///< Since hello().
  std::mutex mutex_;
  std::atomic<Time::rep> now_{0};
  Time limit_{0};
  bool is_virtual_ = false;
  TraceSink* sink_ = nullptr;
  std::atomic<bool> is_lost_ = false;
};

}  // namespace eyebridge::hal
