#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/bridges/can_bus.hpp"
#include "eyebridge/bridges/client/dbc_plan.hpp"
#include "eyebridge/bridges/guard/line_guard.hpp"

namespace eyebridge::bridges {

/// A number as the robot sent it last.
struct DbcValue {
  std::int64_t whole = 0;  ///< The signal's bits, with their sign.
  double value = 0;        ///< In the signal's unit.
  Time at{0};              ///< When it came.
};

/// A robot that is driven by its own messages: the speeds of its wheels are sent at their period as
/// long as the program lives, and its numbers are kept.
///
/// Frames are sent and taken by a thread of its own (start()) or by the caller (pump()), never by
/// both. All else: any thread. Nothing is sent before the robot's heartbeat was heard. When the
/// robot is lost its wheels are told 0 from then on, every call fails with Disconnected until it is
/// heard again, and generation() grows.
class DbcClient {
 public:
  /// `clock`, the one of `bus`, and `log` must outlive this.
  DbcClient(std::unique_ptr<CanBus> bus, DbcPlan plan, Clock& clock, LogSink& log);
  /// Speed 0 goes out; the thread ends.
  ~DbcClient();
  DbcClient(const DbcClient&) = delete;
  DbcClient& operator=(const DbcClient&) = delete;

  /// Starts the thread "eb:dbc".
  void start();
  /// Does what the thread would until `until`. Only without start().
  void pump(Time until);
  /// From now on a LineGuard tells the wheels 0 when this process is gone without stop(): with all
  /// values of a counter of up to 16, else with the first 16. Fails with Disconnected; Unsupported
  /// where the bus has no socket.
  Result<void> guard();
  /// Waits until the robot lives and every reading has come; at most for `patience`. Fails with
  /// what is missing.
  Result<void> wait_ready(Time patience);

  /// Wheel `index` of the plan turns at `value`, in its signal's unit, from now on. Fails with
  /// Disconnected, or OutOfRange for what the signal cannot say.
  Result<void> wheel(std::size_t index, double value);
  /// Reading `index` of the plan. Fails with Disconnected; Timeout when it is older than four
  /// periods of its message (at least 300 ms; a second where the file names none); Unsupported
  /// when the robot says that there is no value.
  Result<DbcValue> latest(std::size_t index) const;
  /// All wheels stand: tells them, and waits up to a second until the robot shows it, where it can.
  /// Fails with Disconnected or Timeout.
  Result<void> stop();

  /// Grows whenever the robot was lost.
  [[nodiscard]] std::uint32_t generation() const;

 private:
  enum class Phase { Unheard, Ready, Lost };
  /// A reading, as it came last.
  struct Latest {
    std::uint64_t bits = 0;
    std::optional<Time> at;
    Time changed{0};
  };
  /// A command on its way.
  struct Sender {
    std::vector<std::uint8_t> bytes;
    std::uint64_t counter = 0;
    Time due{0};
  };

  void run();
  Time tick();
  void take(const CanFrame& frame);
  void check_heartbeat(Time now, const std::string& why);  // under mutex_
  void rest();                                             // under mutex_
  CanFrame next_frame(std::size_t command);                // under mutex_
  [[nodiscard]] bool is_turning() const;                   // under mutex_
  [[nodiscard]] Result<void> check_ready() const;          // under mutex_
  [[nodiscard]] bool stands_since(Time told) const;        // under mutex_
  [[nodiscard]] std::string missing() const;               // under mutex_
  bool wait_for(const std::function<bool()>& done, Time deadline);
  void tell_guard(bool turning);  // under sending_
  [[nodiscard]] StopOrders stop_orders() const;

  const std::unique_ptr<CanBus> bus_;
  const DbcPlan plan_;
  const std::string who_;  ///< "can0: rover"
  Clock& clock_;
  LogSink& log_;
  std::unique_ptr<LineGuard> guard_;  // under sending_
  std::thread thread_;

  std::mutex sending_;  // taken before mutex_; frames leave in the order of their decisions
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Phase phase_ = Phase::Unheard;
  Time heard_{0};
  std::uint32_t generation_ = 0;
  std::string trouble_;  ///< Why the robot is lost.
  std::vector<Latest> latest_;
  std::vector<Sender> senders_;
  bool ending_ = false;
};

}  // namespace eyebridge::bridges
