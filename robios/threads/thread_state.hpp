#pragma once

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

/// A look at the thread `tid` of this process, as gettid(2) has it; some 10 microseconds. One that
/// cannot be looked at, as the process has no more files, sleeps.
ThreadState look_at_thread(int tid);
/// The same for the main thread of process `pid`.
ThreadState look_at_process(int pid);

}  // namespace eyebridge::robios
