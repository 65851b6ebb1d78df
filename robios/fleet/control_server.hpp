#pragma once

#include <functional>
#include <mutex>

#include "control_socket.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/hal/shared_world.hpp"

namespace eyebridge::robios {

/// Where other processes ask a run for one more robot, or one less (`eyebridge add`, `remove`).
class ControlServer {
 public:
  /// Lets a robot in or out: its index.
  using Act = std::function<Result<std::size_t>(const Words&)>;

  /// Answers from a thread of its own from now on; where the system refuses, `log` is told so.
  /// What `act` has is lent for the life of the process.
  ControlServer(Act act, LogSink& log);
  /// Nobody finds it any more. Any thread.
  static void close() noexcept { close_control_socket(); }
  /// Returns when who was let in or out, or not, has been told so. When `act` refuses all.
  void finish() { const std::lock_guard lock(answering_); }

 private:
  void answer_all();
  [[nodiscard]] Words answer(const Words& words);

  const Act act_;
  const UniqueFd control_;
  std::mutex answering_;  ///< Held from a question to its answer.
};

/// Who `words` want: MODEL x y phi [PROGRAM [ARGUMENTS]], millimetres and degrees. Throws
/// ConfigError.
hal::Newcomer read_newcomer(const Words& words, const hal::SharedWorld& world);

/// The index of the robot that `words` want out: kRemove and its number. Throws ConfigError.
std::size_t read_leaver(const Words& words);

}  // namespace eyebridge::robios
