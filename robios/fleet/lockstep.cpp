#include "lockstep.hpp"

#include <algorithm>
#include <utility>

namespace eyebridge::robios {

void Lockstep::add(std::function<void()> body, Time start) {
  turns_.push_back({start, std::make_unique<Fiber>(std::move(body))});
  soonest_ = std::min(soonest_, start);
  ++alive_;
}

void Lockstep::drop(std::size_t robot) {
  Turn& turn = turns_[robot];
  if (turn.fiber == nullptr) return;
  turn = {kNever, nullptr};
  --alive_;
}

void Lockstep::run(Time step_length, const std::function<void()>& step) {
  round_end_ = step_length;
  while (alive_ > 0 || expected_ > 0) {
    soonest_ = kNever;
    for (at_ = 0; at_ < turns_.size(); ++at_) {
      while (turns_[at_].next < round_end_) take_turn();
      soonest_ = std::min(soonest_, turns_[at_].next);
    }
    if (any_waits_ && (missing_ == 0 || soonest_ == kNever)) {
      let_all_go(round_end_ - step_length);
      continue;
    }
    while (soonest_ >= round_end_) {
      if (expected_ == 0 && alive_ == 0) return;
      step();
      round_end_ += step_length;
    }
  }
}

/// Has what the next robots need on its way while one runs: with a hundred of them the processor
/// waits for memory most of the time.
void Lockstep::fetch_next() const {
  if (at_ + 2 >= turns_.size()) return;
  if (const auto& next = turns_[at_ + 1].fiber) next->fetch();
  __builtin_prefetch(turns_[at_ + 2].fiber.get(), 1);
}

/// The turn of the robot at_; where those after it have theirs at once (park), theirs, too: then
/// at_ is the last of them.
void Lockstep::take_turn() {
  begin_turn();
  turns_[at_].fiber->resume();
  if (std::exchange(is_over_, false)) drop(at_);  // with its stack
}

/// The robot at_ runs from now on.
void Lockstep::begin_turn() {
  fetch_next();
  // One thread writes.
  switches_.store(switches_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  whose_.store(at_, std::memory_order_relaxed);
}

void Lockstep::park(Time time) {
  Fiber& me = *turns_[at_].fiber;
  turns_[at_].next = time;
  Fiber* const next = next_in_round();
  if (next == nullptr) return me.suspend();
  begin_turn();
  me.hand_over(*next);
}

/// Ends the turn of the robot at_ when that of the next one can begin at once, and gives its fiber:
/// one switch of stacks instead of two. Null, and nothing done, when the round is over, or it is
/// the same robot's turn again.
Fiber* Lockstep::next_in_round() {
  if (turns_[at_].next < round_end_) return nullptr;
  Time soonest = std::min(soonest_, turns_[at_].next);
  for (std::size_t next = at_ + 1; next < turns_.size(); ++next) {
    if (turns_[next].next < round_end_) {
      soonest_ = soonest;
      at_ = next;
      return turns_[next].fiber.get();
    }
    soonest = std::min(soonest, turns_[next].next);
  }
  return nullptr;
}

void Lockstep::count_in(Time now) {
  met_ = std::max(met_, now);
  if (missing_ > 0) --missing_;
}

Time Lockstep::meet() {
  if (have_met_) return met_;
  any_waits_ = true;
  turns_[at_].waits_for_all = true;
  park(kNever);
  return met_;
}

void Lockstep::let_all_go(Time now) {
  have_met_ = true;
  any_waits_ = false;
  met_ = std::max(met_, now);
  for (Turn& turn : turns_) {
    if (std::exchange(turn.waits_for_all, false)) turn.next = met_;
  }
}

void Lockstep::drop_robot() {
  is_over_ = true;
  turns_[at_].fiber->leave_for_good();
}

}  // namespace eyebridge::robios
