#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/bridges/guard/stop_orders.hpp"

namespace eyebridge::bridges {

/// A process that holds the line to a robot, too, and stops the robot when this process is gone in
/// whichever way, or silent for half a second while wheels turn.
///
/// It keeps trying while the board is deaf or the line is gone, at most for two minutes, opens a
/// line again that was lost, and says on standard error what it did. What ends it as well: the end
/// of the whole machine or container, kill -9 to itself. One thread at a time.
class LineGuard {
 public:
  /// After so much silence while wheels turn.
  static constexpr Time kSilence = std::chrono::milliseconds(500);

  /// Fails with Disconnected when the system gives no process.
  static Result<std::unique_ptr<LineGuard>> start();
  /// The guard does what is to be done when the program is gone.
  ~LineGuard() = default;
  LineGuard(const LineGuard&) = delete;
  LineGuard& operator=(const LineGuard&) = delete;

  /// From now on the robot behind `line`, a terminal or a socket, is guarded. `device` is what the
  /// line is opened again by, where it is no socket. Fails with Disconnected when the guard is
  /// gone.
  Result<void> hold(int line, std::string_view device, const StopOrders& orders);
  /// The line is lost and about to be opened anew: returns once the guard has closed it.
  Result<void> let_go();
  /// Wheels are about to turn, or turn on: to be called at least every 250 ms.
  Result<void> turning(Time now);
  /// The robot is known to stand: nothing is to be done at the end, until turning().
  Result<void> still();

 private:
  explicit LineGuard(UniqueFd words) : words_(std::move(words)) {}

  UniqueFd words_;
  bool turns_ = true;
  Time said_{0};
};

}  // namespace eyebridge::bridges
