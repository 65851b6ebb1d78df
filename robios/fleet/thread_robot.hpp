#pragma once

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <utility>

#include "robot.hpp"

namespace eyebridge::robios {

/// Where robots in real time wait for each other: at their first call, and for the last one's end.
/// Any thread.
class Barrier {
 public:
  /// `newcomers` come when all `robots` are there.
  Barrier(std::size_t robots, std::size_t newcomers)
      : awaited_(robots), left_(robots + newcomers) {}

  /// A robot is there; returns when all are, or have ended. The last one gets true: before any of
  /// the others goes on it may do what is to be done once.
  template <class AtLast>
  void arrive(AtLast&& at_last) {
    std::unique_lock lock(mutex_);
    if (--awaited_ == 0) {
      at_last();
      changed_.notify_all();
    }
    changed_.wait(lock, [this] { return awaited_ == 0; });
  }
  /// A robot has ended; `has_arrived` before.
  template <class AtLast>
  void leave(bool has_arrived, AtLast&& at_last) {
    const std::lock_guard lock(mutex_);
    if (!has_arrived && --awaited_ == 0) at_last();
    --left_;
    changed_.notify_all();
  }
  /// One more that nobody waits for at its first call; false when all have ended.
  [[nodiscard]] bool join();
  /// Returns when all are there; false when `seconds` have passed before.
  bool await_start(double seconds);
  /// Returns when all have ended.
  void await_end();
  [[nodiscard]] std::size_t awaited();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t awaited_;  ///< Robots that have not arrived yet.
  std::size_t left_;     ///< Robots that have not ended.
};

/// A robot in real time: its program runs in a thread.
class ThreadRobot final : public Robot {
 public:
  ThreadRobot(std::size_t index, RobotProgram program, Barrier& barrier, hal::SharedWorld& world)
      : Robot(index, std::move(program)), barrier_(barrier), world_(world) {}

  /// Starts the thread. Throws std::system_error when there are no more.
  void start();
  /// The same for one that comes when the others run.
  void start_late() {
    has_arrived_ = true;
    start();
  }

  /// Its program's thread, as gettid(2) has it; 0 before. Any thread.
  [[nodiscard]] int tid() const { return tid_; }
  /// It has made its first call, or came late.
  [[nodiscard]] bool has_arrived() const { return has_arrived_; }

  [[noreturn]] void hold_thread() override;
  void arrive() override;

 protected:
  [[noreturn]] void drop(int code) override;
  void forget() override;

 private:
  Barrier& barrier_;
  hal::SharedWorld& world_;
  std::atomic<bool> has_arrived_ = false;
  std::atomic<int> tid_ = 0;
};

}  // namespace eyebridge::robios
