#pragma once

#include <functional>
#include <mutex>

#include "door_socket.hpp"
#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/hal/shared_world.hpp"

namespace eyebridge::robios {

/// Where other processes ask a run for one more robot (`eyebridge add`).
class Door {
 public:
  /// Lets a robot in: its index.
  using Add = std::function<Result<std::size_t>(const Words&)>;

  /// Answers from a thread of its own from now on; where the system refuses, it stays shut.
  /// What `add` has is lent for the life of the process.
  explicit Door(Add add);
  [[nodiscard]] bool is_open() const { return door_.valid(); }
  /// Nobody finds it any more. Any thread.
  static void close() noexcept { close_door(); }
  /// Returns when who was let in, or not, has been told so. When `add` lets nobody in any more.
  void finish() { const std::lock_guard lock(answering_); }

 private:
  void answer_all();
  [[nodiscard]] Words answer(const Words& words);

  const Add add_;
  const UniqueFd door_;
  std::mutex answering_;  ///< Held from a question to its answer.
};

/// Who `words` want: MODEL x y phi [PROGRAM [ARGUMENTS]], millimetres and degrees. Throws
/// ConfigError.
hal::Newcomer read_newcomer(const Words& words, const hal::SharedWorld& world);

}  // namespace eyebridge::robios
