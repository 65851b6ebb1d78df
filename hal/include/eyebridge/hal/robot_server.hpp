#pragma once

#include <functional>
#include <memory>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/backend.hpp"

namespace eyebridge::hal {

/// The world's end of the line to a robot's program that runs in a process of its own, where the
/// robot is reached as `remote:`. Answers one question after the other. One thread.
class RobotServer {
 public:
  /// `robot` is lent. `limit`, lent: in virtual time the program's clock may move by itself up to
  /// there, which changes (Turns::limit_of()); null: it has to ask each time.
  /// `socket` is the line, lent. `arrive`: Backend::arrive() of the program, in real time before it
  /// is welcomed. Throws std::system_error when the system has no memory for the line.
  RobotServer(Backend& robot, const Time* limit, int socket, std::function<void()> arrive = {});
  /// Traces nothing any more.
  ~RobotServer();
  RobotServer(const RobotServer&) = delete;
  RobotServer& operator=(const RobotServer&) = delete;

  /// Waits for the next question. Fails with Timeout when none came within the socket's
  /// SO_RCVTIMEO; with Disconnected when the program's end is closed, with Corrupt when what comes
  /// is no question: nothing can be asked any more.
  Result<void> receive();
  /// Answers it, once the robot's clock has got to the program's time. Fails with Disconnected.
  Result<void> answer();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace eyebridge::hal
