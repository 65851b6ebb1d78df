#pragma once

#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge::robios {

/// What the kernel knows of a thread.
struct ThreadState {
  enum class Kind { Computes, Sleeps, Gone };

  Kind kind = Kind::Computes;
  double processor_s = 0.0;  ///< Processor time so far, seconds, in steps of the kernel's tick.
};

/// Reads the `text` of proc(5), /proc/PID/task/TID/stat. Who waits for the disk computes; a text
/// that is none is Gone.
ThreadState read_thread_state(const char* text);

/// A look at one thread of this process; 4 microseconds each.
class ThreadView {
 public:
  /// `tid`: its number for the kernel, gettid(2).
  explicit ThreadView(int tid) : tid_(tid) {}

  [[nodiscard]] int tid() const { return tid_; }
  ThreadState look();

 private:
  int tid_;
  UniqueFd file_;  ///< Kept open: half of the time otherwise.
};

}  // namespace eyebridge::robios
