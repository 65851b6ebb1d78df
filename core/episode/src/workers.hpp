#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace eyebridge::episode {

/// Threads that share out the indices of a loop. One caller at a time.
class Workers {
 public:
  /// `threads` with the caller's own; 0: one a core.
  explicit Workers(unsigned threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// `body(i)` for each i below `count`, in no order; returns when all are done. An exception ends
  /// nothing but its own index: the one of the least index is thrown again at the end.
  void for_each(std::size_t count, const std::function<void(std::size_t)>& body);

 private:
  void wait_for_work();
  void take_shares();
  void note_failure(std::size_t index);

  std::mutex mutex_;
  std::condition_variable begun_;
  std::condition_variable done_;
  std::uint64_t round_ = 0;
  std::size_t busy_ = 0;  ///< Threads that have not yet ended the round.
  bool ending_ = false;
  const std::function<void(std::size_t)>* body_ = nullptr;
  std::size_t count_ = 0;
  std::size_t share_ = 1;
  std::atomic<std::size_t> next_ = 0;
  std::exception_ptr failure_;
  std::size_t failed_index_ = 0;
  std::vector<std::thread> threads_;
};

}  // namespace eyebridge::episode
