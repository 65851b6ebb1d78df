#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace eyebridge::gui {

/// A thread for what the windows' thread must not wait for: disks, mostly. Any thread.
class Worker {
 public:
  Worker();
  /// Returns when all that was given is done.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// One after the other, in the order in which they are given. They throw nothing.
  void give(std::function<void()> job);
  /// Returns when all that was given so far is done. Not for jobs.
  void finish();

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> jobs_;
  bool is_busy_ = false;
  bool is_ending_ = false;
  std::thread thread_;  ///< Last: it uses the others.
};

}  // namespace eyebridge::gui
