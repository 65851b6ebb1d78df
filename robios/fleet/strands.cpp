#include "strands.hpp"

#include <algorithm>
#include <cerrno>
#include <iterator>

#include <pthread.h>

#include "flow.hpp"
#include "robot.hpp"
#include "threads/turn_calls.h"

namespace eyebridge::robios {

Time Strands::now() const { return Session::here()->clock().now(); }

unsigned long Strands::create(Start start, void* argument) {
  const unsigned long number = next_number_++;
  Session* const session = Session::here();
  Strand& strand = lockstep_.add_strand([this, session, start, argument] {
    Session::set_here(session);
    finish(start(argument));
  });
  threads_[number] = {&strand, strand.robot};
  lockstep_.wake(strand, now());
  return number;
}

unsigned long Strands::self() const {
  const Strand* const mine = lockstep_.current();
  for (const auto& [number, thread] : threads_) {
    if (thread.strand == mine) return number;
  }
  return 0;
}

void Strands::finish(void* result) {
  specifics_.destroy();
  forget_strand(lockstep_.current());
  if (lockstep_.is_last_strand()) Robot::current()->exit(0, EYEBRIDGE_EXIT);
  const auto me = threads_.find(self());
  if (me != threads_.end()) {
    note_end(me->second, result);
    if (me->second.is_detached) threads_.erase(me);
  }
  lockstep_.drop_strand();
}

void Strands::note_end(Thread& thread, void* result) {
  thread.strand = nullptr;
  thread.result = result;
  wake(&thread, true);
}

/// Another one may lie where it lay; the locks that it has are nobody's.
void Strands::forget_strand(const Strand* strand) {
  for (auto& [lock, owner] : owners_) {
    if (owner.strand == strand) owner.strand = nullptr;
  }
}

int Strands::cancel(unsigned long number) {
  const auto found = threads_.find(number);
  if (found == threads_.end() || found->second.robot != lockstep_.current()->robot) return ESRCH;
  Strand* const strand = found->second.strand;
  if (strand == nullptr) return 0;
  if (strand == lockstep_.current()) finish(PTHREAD_CANCELED);
  for (auto row = waiting_.begin(); row != waiting_.end();) {
    std::erase(row->second, strand);
    row = row->second.empty() ? waiting_.erase(row) : std::next(row);
  }
  specifics_.forget_strand(strand);
  forget_strand(strand);
  note_end(found->second, PTHREAD_CANCELED);
  if (found->second.is_detached) threads_.erase(found);
  lockstep_.drop_other(*strand);
  return 0;
}

void Strands::make_barrier(const void* barrier, unsigned count) {
  if (count == 0) {
    barriers_.erase(barrier);
  } else {
    barriers_[barrier] = {lockstep_.current()->robot, count, 0};
  }
}

bool Strands::meet(const void* barrier) {
  const auto found = barriers_.find(barrier);
  if (found == barriers_.end()) return true;  // it is none
  if (++found->second.there < found->second.count) {
    park(barrier, Lockstep::kNever);
    return false;
  }
  found->second.there = 0;
  wake(barrier, true);
  return true;
}

int Strands::join(unsigned long number, void** result) {
  const auto found = threads_.find(number);
  if (found == threads_.end() || found->second.robot != lockstep_.current()->robot) return ESRCH;
  Thread& thread = found->second;
  if (thread.is_detached) return EINVAL;
  if (thread.strand == lockstep_.current()) return EDEADLK;
  while (thread.strand != nullptr) park(&thread, Lockstep::kNever);
  if (result != nullptr) *result = thread.result;
  threads_.erase(number);
  return 0;
}

int Strands::detach(unsigned long number) {
  const auto found = threads_.find(number);
  if (found == threads_.end()) return ESRCH;
  found->second.is_detached = true;
  if (found->second.strand == nullptr) threads_.erase(found);
  return 0;
}

bool Strands::park(const void* what, Time deadline) {
  Strand* const me = lockstep_.current();
  waiting_[what].push_back(me);
  if (deadline <= now()) deadline = now() + Time(1);
  lockstep_.park(deadline);
  const auto queue = waiting_.find(what);
  if (queue == waiting_.end()) return false;
  const auto mine = std::ranges::find(queue->second, me);
  if (mine == queue->second.end()) return false;  // woken
  queue->second.erase(mine);
  if (queue->second.empty()) waiting_.erase(queue);
  // Nobody else has moved the clock to where the wait ended.
  Session::here()->clock().wait_until(deadline);
  if (flow.calls == 0) {  // else a library's lock, which is given back first
    const InCall in_call;
    Session::here()->check_limit();
  }
  return true;
}

void Strands::wake(const void* what, bool all) {
  const auto queue = waiting_.find(what);
  if (queue == waiting_.end()) return;
  do {
    lockstep_.wake(*queue->second.front(), now());
    queue->second.pop_front();
  } while (all && !queue->second.empty());
  if (queue->second.empty()) waiting_.erase(queue);
}

bool Strands::own(const void* lock) {
  Owner& owner = owners_[lock];
  Strand* const me = lockstep_.current();
  if (owner.count > 0 && owner.strand != me) return false;
  owner.strand = me;
  owner.robot = me->robot;
  ++owner.count;
  return true;
}

int Strands::disown(const void* lock) {
  const auto owner = owners_.find(lock);
  if (owner == owners_.end() || owner->second.strand != lockstep_.current()) return -1;
  const int left = --owner->second.count;
  if (left == 0) owners_.erase(owner);
  return left;
}

bool Strands::owns(const void* lock) const {
  const auto owner = owners_.find(lock);
  return owner != owners_.end() && owner->second.strand == lockstep_.current();
}

void Strands::forget(std::size_t robot) {
  std::erase_if(threads_, [&](const auto& row) { return row.second.robot == robot; });
  std::erase_if(owners_, [&](const auto& row) { return row.second.robot == robot; });
  std::erase_if(barriers_, [&](const auto& row) { return row.second.robot == robot; });
  specifics_.forget_robot(robot);
  for (auto row = waiting_.begin(); row != waiting_.end();) {
    std::erase_if(row->second, [&](const Strand* strand) { return strand->robot == robot; });
    row = row->second.empty() ? waiting_.erase(row) : std::next(row);
  }
}

}  // namespace eyebridge::robios
