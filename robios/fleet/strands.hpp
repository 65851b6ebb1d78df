#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <unordered_map>

#include "lockstep.hpp"
#include "specifics.hpp"

namespace eyebridge::robios {

/// The threads that programs make in virtual time, and what they wait for: strands of the robot
/// that take turns. One thread of the process; all functions are called by strands.
///
/// Whoever waits is woken in the order in which he came, so that runs repeat.
class Strands {
 public:
  /// `lockstep` is lent.
  explicit Strands(Lockstep& lockstep) : lockstep_(lockstep), specifics_(lockstep) {}

  using Start = void* (*)(void*);
  /// A thread of the calling robot, from now on: its number.
  unsigned long create(Start start, void* argument);
  /// The number of the calling thread; 0 in the robot's main flow.
  [[nodiscard]] unsigned long self() const;
  /// Ends the calling flow; the robot with its last one.
  [[noreturn]] void finish(void* result);
  /// As pthread_join() and pthread_detach(): 0 or an error code.
  int join(unsigned long thread, void** result);
  int detach(unsigned long thread);
  /// As pthread_cancel(), but that it ends at once: 0 or an error code. Nothing is cleaned up.
  int cancel(unsigned long thread);

  /// Lays the caller down until wake(what) or `deadline` on its clock; true when that came first.
  bool park(const void* what, Time deadline);
  void wake(const void* what, bool all);

  /// A lock that knows its owner: true when the caller has it, now or before.
  bool own(const void* lock);
  /// How often the caller still has it; -1 when it has not.
  int disown(const void* lock);
  [[nodiscard]] bool owns(const void* lock) const;

  /// A barrier for `count` threads; 0: it is gone.
  void make_barrier(const void* barrier, unsigned count);
  /// Waits until as many threads are at the barrier as it is for; true for the last one.
  bool meet(const void* barrier);

  [[nodiscard]] Specifics& specifics() { return specifics_; }

  /// True once a program has made a thread.
  [[nodiscard]] bool any() const { return next_number_ > 1; }

  /// Forgets what belongs to a robot that has ended.
  void forget(std::size_t robot);

 private:
  using Strand = Lockstep::Strand;
  struct Thread {
    Strand* strand = nullptr;  ///< Null when it has ended.
    std::size_t robot = 0;
    void* result = nullptr;
    bool is_detached = false;
  };
  struct Owner {
    const Strand* strand = nullptr;  ///< Null when that has ended, and has it for ever.
    std::size_t robot = 0;
    int count = 0;
  };

  struct Barrier {
    std::size_t robot = 0;
    unsigned count = 0;
    unsigned there = 0;
  };

  [[nodiscard]] Time now() const;
  void note_end(Thread& thread, void* result);
  void forget_strand(const Strand* strand);

  Lockstep& lockstep_;
  std::map<unsigned long, Thread> threads_;
  std::unordered_map<const void*, std::deque<Strand*>> waiting_;
  std::unordered_map<const void*, Owner> owners_;
  std::unordered_map<const void*, Barrier> barriers_;
  Specifics specifics_;
  unsigned long next_number_ = 1;
};

}  // namespace eyebridge::robios
