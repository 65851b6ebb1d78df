#include "lockstep.hpp"

#include <algorithm>
#include <utility>

namespace eyebridge::robios {

void Lockstep::add(std::function<void()> body, Time start) {
  Place& place = places_.emplace_back();
  const std::size_t robot = places_.size() - 1;
  place.strands.push_back(std::make_unique<Strand>(robot, start, std::move(body)));
  turns_.push_back({start, place.strands.front().get()});
  soonest_ = std::min(soonest_, start);
  ++alive_;
}

void Lockstep::drop(std::size_t robot) {
  Place& place = places_[robot];
  if (place.strands.empty()) return;
  place.strands.clear();
  place.has_dropped = false;
  turns_[robot] = {kNever};
  --alive_;
}

Lockstep::Strand& Lockstep::add_strand(std::function<void()> body) {
  turns_[running_->robot].only = nullptr;
  return *places_[running_->robot].strands.emplace_back(
      std::make_unique<Strand>(running_->robot, kNever, std::move(body)));
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
    // Strands that wait for each other only: who could wake them has ended.
    while (soonest_ >= round_end_) {
      if (expected_ == 0 && (alive_ == 0 || soonest_ == kNever)) return;
      step();
      round_end_ += step_length;
    }
  }
}

/// Has what the next robots need on its way while one runs: with a hundred of them the processor
/// waits for memory most of the time.
void Lockstep::fetch_next() const {
  if (at_ + 2 >= turns_.size()) return;
  if (const Strand* const next = turns_[at_ + 1].only) next->fiber.fetch();
  __builtin_prefetch(turns_[at_ + 2].only, 1);
  __builtin_prefetch(&places_[at_ + 2], 1);
}

/// The turn of the robot at_; where those after it have theirs at once (park), theirs, too: then
/// at_ is the last of them.
void Lockstep::take_turn() {
  Strand* const only = turns_[at_].only;
  if (only != nullptr) {
    begin_turn(*only, round_end_);
  } else {
    Strand& first = earliest();
    Time limit = round_end_;
    for (const auto& other : places_[at_].strands) {
      if (other.get() != &first) limit = std::min(limit, other->wake);
    }
    begin_turn(first, limit);
  }
  running_->fiber.resume();
  const Strand* const last = std::exchange(running_, nullptr);
  if (turns_[at_].only == last && !last->has_ended) {
    turns_[at_].next = last->wake;
  } else {
    tidy(at_);  // it made another one, or has ended
  }
}

Lockstep::Strand& Lockstep::earliest() {
  const auto earlier = [](const auto& a, const auto& b) { return a->wake < b->wake; };
  return **std::ranges::min_element(places_[at_].strands, earlier);
}

/// `strand` of the robot at_ runs from now on.
void Lockstep::begin_turn(Strand& strand, Time limit) {
  fetch_next();
  places_[at_].limit = limit;
  // One thread writes.
  switches_.store(switches_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  whose_.store(strand.robot, std::memory_order_relaxed);
  running_ = &strand;
}

/// Forgets what was dropped, and finds the robot's next time.
void Lockstep::tidy(std::size_t robot) {
  Place& place = places_[robot];
  if (place.has_dropped) {
    place.has_dropped = false;
    std::erase_if(place.strands, [](const auto& strand) { return strand->has_ended; });
    turns_[robot].only = place.strands.size() == 1 ? place.strands.front().get() : nullptr;
    if (place.strands.empty()) --alive_;
  }
  Time& next = turns_[robot].next;
  next = kNever;
  for (const auto& strand : place.strands) next = std::min(next, strand->wake);
}

void Lockstep::wait(std::size_t /*robot*/, Time time) { park(time); }

void Lockstep::park(Time deadline) {
  Strand& me = *running_;
  me.wake = deadline;
  Strand* const next = next_in_round();
  if (next == nullptr) return me.fiber.suspend();
  begin_turn(*next, round_end_);
  me.fiber.hand_over(next->fiber);
}

/// Ends the turn of the robot at_ when that of the next one can begin at once, and gives its
/// strand: one switch of stacks instead of two. Null, and nothing done, when run() has to look
/// after this robot or the next one, or the round is over.
Lockstep::Strand* Lockstep::next_in_round() {
  Turn& mine = turns_[at_];
  if (mine.only != running_ || running_->wake < round_end_) return nullptr;
  Time soonest = std::min(soonest_, running_->wake);
  for (std::size_t next = at_ + 1; next < turns_.size(); ++next) {
    if (turns_[next].next < round_end_) {
      if (turns_[next].only == nullptr) return nullptr;
      mine.next = running_->wake;
      soonest_ = soonest;
      at_ = next;
      return turns_[next].only;
    }
    soonest = std::min(soonest, turns_[next].next);
  }
  return nullptr;
}

void Lockstep::wake(Strand& strand, Time now) {
  strand.wake = std::min(strand.wake, now);
  Time& next = turns_[strand.robot].next;
  next = std::min(next, strand.wake);
  // The one that runs gives way when it gets there.
  Time& limit = places_[strand.robot].limit;
  limit = std::min(limit, strand.wake);
}

bool Lockstep::is_last_strand() const {
  const auto is_there = [](const auto& strand) { return !strand->has_ended; };
  return std::ranges::count_if(places_[running_->robot].strands, is_there) == 1;
}

void Lockstep::count_in(Time now) {
  met_ = std::max(met_, now);
  if (missing_ > 0) --missing_;
}

Time Lockstep::meet() {
  if (have_met_) return met_;
  any_waits_ = true;
  running_->waits_for_all = true;
  park();
  return met_;
}

void Lockstep::let_all_go(Time now) {
  have_met_ = true;
  any_waits_ = false;
  met_ = std::max(met_, now);
  for (std::size_t robot = 0; robot < places_.size(); ++robot) {
    for (const auto& strand : places_[robot].strands) {
      if (!std::exchange(strand->waits_for_all, false)) continue;
      strand->wake = met_;
      turns_[robot].next = std::min(turns_[robot].next, met_);
    }
  }
}

void Lockstep::drop_robot() {
  for (const auto& strand : places_[running_->robot].strands) strand->has_ended = true;
  drop_strand();
}

void Lockstep::drop_other(Strand& strand) {
  places_[strand.robot].has_dropped = true;
  strand.has_ended = true;
  strand.wake = kNever;
}

void Lockstep::drop_strand() {
  places_[running_->robot].has_dropped = true;
  running_->has_ended = true;
  running_->wake = kNever;
  running_->fiber.leave_for_good();  // take_turn() forgets it, with its stack
}

}  // namespace eyebridge::robios
