#include "thread_turns.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include <pthread.h>

#include "eyebridge/base/uncancelled.hpp"
#include "flow.hpp"

namespace eyebridge::robios {
namespace {

using std::chrono::microseconds;
using Stage = ThreadTurns::Member::Stage;

// How often those who wait look whether somebody who computed sleeps now, in real time. He tells
// nobody, if he waits for something that we do not know of.
constexpr microseconds kLookSoon(50);
constexpr microseconds kLookAgain(2000);
constexpr microseconds kLookSeldom(20'000);  // who is not next

}  // namespace

ThreadTurns::ThreadTurns(Look look, Tell tell, Events events)
    : look_(std::move(look)), tell_(std::move(tell)), events_(std::move(events)) {}
ThreadTurns::~ThreadTurns() = default;

void ThreadTurns::begin(Clock& clock) { clock_.store(&clock, std::memory_order_release); }

void ThreadTurns::end() {
  const InCall in_call;
  const Lock lock = enter();
  has_ended_ = true;
  for (Member& member : members_) {
    if (member.stage != Stage::Waiting) continue;
    wake_member(member);
    member.stage = Stage::Going;
    member.turn->post();
  }
}

/// Takes the lock. Whoever waits for it sleeps, by the kernel's word, and yet goes on.
ThreadTurns::Lock ThreadTurns::enter() {
  ++entering_;
  Lock lock(mutex_);
  --entering_;
  return lock;
}

ThreadTurns::Member& ThreadTurns::expect() {
  const InCall in_call;
  const Lock lock = enter();
  Member& made = members_.emplace_back();
  ++count_;
  if (have_begun()) {
    made.deadline = now();
    made.stage = Stage::Waiting;
  }
  return made;
}

void ThreadTurns::start(Member& me) {
  const InCall in_call;
  Lock lock = enter();
  if (me.stage == Stage::Waiting) await_turn(me, lock);
  me.stage = Stage::Out;
}

ThreadTurns::Member& ThreadTurns::adopt(int tid) {
  const InCall in_call;
  const Lock lock = enter();
  const auto found = std::ranges::find(members_, tid, [](const Member& m) { return m.tid.load(); });
  if (found != members_.end()) return *found;
  Member& made = members_.emplace_back();
  made.tid = tid;
  ++count_;
  return made;
}

void ThreadTurns::name(const Member& member, unsigned long thread) {
  const InCall in_call;
  const Lock lock = enter();
  for (Member& present : members_) {
    if (&present == &member) present.thread = thread;
    if (&present == &member) left_.erase(thread);  // of one before, which nobody waited for
  }
}

void ThreadTurns::cancel(unsigned long thread) {
  const InCall in_call;
  const Lock lock = enter();
  for (Member& member : members_) {
    if (member.thread == thread && member.stage == Stage::Waiting) wake_member(member);
  }
}

void ThreadTurns::leave(Member& member) {
  const InCall in_call;
  Lock lock = enter();
  member.stage = Stage::Gone;
  forget_gone();
  const std::shared_ptr<WakeUp> next = have_begun() ? pass_on() : nullptr;
  lock.unlock();
  if (next != nullptr) next->post();
}

void ThreadTurns::wait(Member& me, Time deadline) {
  if (deadline <= now()) return;
  if (is_alone()) return clock()->wait_until(deadline);
  park(me, nullptr, deadline);
  pthread_testcancel();  // as every sleep
}

bool ThreadTurns::park(Member& me, const void* what, Time deadline, const Unless& unless) {
  const InCall in_call;
  Lock lock = enter();
  if (unless.is_free != nullptr && unless.is_free(what, unless.value) != 0) return false;
  return park_in(me, lock, what, deadline, unless);
}

bool ThreadTurns::park_in(Member& me, Lock& lock, const void* what, Time deadline,
                          const Unless& unless) {
  // Whatever happens: what steps the world may throw.
  const struct Leaving {
    Member& me;
    ~Leaving() { me.stage = Stage::Out; }
  } leaving{me};
  while (!has_ended_) {
    me.what = what;
    me.unless = unless;
    me.deadline = std::max(deadline, now() + Time(1));
    me.arrival = ++arrivals_;
    me.was_woken = false;
    me.was_passed = false;
    me.is_left_alone = false;
    me.computes_since.reset();
    me.stage = Stage::Waiting;
    await_turn(me, lock);
    if (me.was_woken) return false;
    const std::optional<Time> event = std::exchange(me.event, std::nullopt);
    clock()->wait_until(event.value_or(me.deadline));
    if (!event) return true;
    me.stage = Stage::Out;
    events_.run();
    lock = enter();
    if (unless.is_free == nullptr || unless.is_free(what, unless.value) != 0) return false;
  }
  return false;
}

/// Gives way until it is the caller's turn. `lock` is released.
void ThreadTurns::await_turn(Member& me, Lock& lock) {
  // Who sleeps here is cancelled where he may be, not here: a condition has its mutex then.
  const Uncancelled until_then;
  microseconds pause = kLookSoon;
  for (;;) {
    const std::shared_ptr<WakeUp> next = pass_on();
    const bool is_mine = me.stage == Stage::Going;
    const microseconds patience = first_waiting() == &me ? pause : kLookSeldom;
    lock.unlock();
    if (is_mine) return;
    // Not before: whoever wakes would run into the lock, which takes four times as long.
    if (next != nullptr) next->post();
    me.turn->wait_for(patience);
    // Whose turn it is needs no lock, which who gave it may still have.
    if (me.stage == Stage::Going) return;
    lock = enter();
    pause = std::min(2 * pause, kLookAgain);
  }
}

void ThreadTurns::wake(const void* what, bool all) {
  if (is_alone()) return;
  const InCall in_call;
  const Lock lock = enter();
  wake_locked(what, all);
}

void ThreadTurns::wake_locked(const void* what, bool all) {
  const auto waits = [what](const Member& member) {
    return member.stage == Stage::Waiting && member.what == what && !member.was_woken;
  };
  for (;;) {
    Member* first = nullptr;
    for (Member& member : members_) {
      if (waits(member) && (first == nullptr || member.arrival < first->arrival)) first = &member;
    }
    if (first == nullptr) return;
    wake_member(*first);
    if (!all) return;
  }
}

void ThreadTurns::wake_member(Member& member) const {
  member.was_woken = true;
  member.deadline = now();
}

void ThreadTurns::come_back(Member& me) {
  const InCall in_call;
  Lock lock = enter();
  if (!me.was_passed || !have_begun()) return;
  park_in(me, lock, nullptr, now(), {});
}

ThreadTurns::Ended ThreadTurns::await_end(Member& me, unsigned long thread, Time deadline) {
  const InCall in_call;
  for (bool is_late = false; have_begun();) {
    Lock lock = enter();
    if (left_.erase(thread) != 0) return Ended::Yes;
    const auto found =
        std::ranges::find_if(members_, [=](const Member& m) { return m.thread == thread; });
    if (found == members_.end()) break;
    if (is_late) return Ended::Late;
    is_late = park_in(me, lock, &*found, deadline, {});
  }
  return Ended::Unknown;
}

/// Who waits for what others than members have given, a signal's handler or another process: the
/// first one of each, unless one of them has been woken already.
void ThreadTurns::wake_by_others() {
  for (Member& member : members_) {
    if (member.stage != Stage::Waiting || !member.unless.is_watched || member.was_woken) continue;
    const auto is_before = [&](const Member& other) {
      return other.stage == Stage::Waiting && other.what == member.what &&
             (other.was_woken || other.arrival < member.arrival);
    };
    if (std::ranges::any_of(members_, is_before)) continue;
    if (member.unless.is_free(member.what, member.unless.value) != 0) wake_member(member);
  }
}

ThreadTurns::Member* ThreadTurns::first_waiting() {
  Member* first = nullptr;
  for (Member& member : members_) {
    if (member.stage != Stage::Waiting) continue;
    if (first == nullptr || member.deadline < first->deadline) first = &member;
  }
  return first;
}

bool ThreadTurns::is_busy(Member& member) {
  switch (member.stage) {
    case Stage::Going:
      return true;
    case Stage::Waiting:
    case Stage::Gone:
      return false;
    case Stage::Out:
      break;
  }
  if (member.is_left_alone) return false;
  if (member.tid == 0 || member.is_in_call) return true;
  const ThreadState state = look_(member);
  if (state.kind == ThreadState::Kind::Gone) member.stage = Stage::Gone;
  if (state.kind != ThreadState::Kind::Computes) {
    member.computes_since.reset();
    return false;
  }
  if (!member.computes_since) member.computes_since = state.processor_s;
  if (state.processor_s - *member.computes_since < member.patience_s) return true;
  member.is_left_alone = true;
  if (std::exchange(member.patience_s, kLessPatience_s) == kPatience_s) tell_();
  return false;
}

/// It is the next one's turn, unless somebody goes on already: what he sleeps at, else null.
std::shared_ptr<WakeUp> ThreadTurns::pass_on() {
  bool is_gone = false;
  for (Member& member : members_) {
    if (is_busy(member)) return nullptr;
    is_gone = is_gone || member.stage == Stage::Gone;
  }
  if (is_gone) forget_gone();
  if (entering_ != 0) return nullptr;  // after the looks: who sleeps at our own lock goes on
  wake_by_others();
  Member* const next = first_waiting();
  if (next == nullptr) return nullptr;
  if (next->deadline == kNever) {
    if (all_wait()) next->event = events_.next();
    if (!next->event) return nullptr;
  }
  next->stage = Stage::Going;
  for (Member& member : members_) member.was_passed = member.stage == Stage::Out;
  return next->turn;
}

/// Nobody sleeps somewhere else, or computes on.
bool ThreadTurns::all_wait() const {
  return std::ranges::all_of(members_, [](const Member& m) { return m.stage == Stage::Waiting; });
}

bool ThreadTurns::are_stuck() {
  const InCall in_call;
  const Lock lock(mutex_);
  return have_begun() && !members_.empty() &&
         std::ranges::all_of(members_, [](const Member& member) {
           return member.stage == Stage::Waiting && member.deadline == kNever &&
                  !member.was_woken && !member.unless.is_from_outside;
         });
}

void ThreadTurns::forget_gone() {
  for (auto member = members_.begin(); member != members_.end();) {
    if (member->stage != Stage::Gone) {
      ++member;
      continue;
    }
    const void* const gone = &*member;
    if (have_begun()) wake_locked(gone, true);
    if (member->thread != 0) left_.insert(member->thread);
    member = members_.erase(member);
    --count_;
  }
}

}  // namespace eyebridge::robios
