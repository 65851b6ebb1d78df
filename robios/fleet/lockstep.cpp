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
    Time next = kNever;
    for (std::size_t robot = 0; robot < turns_.size(); ++robot) {
      fetch_next(robot);
      while (turns_[robot].next < round_end_) take_turn(robot);
      next = std::min(next, turns_[robot].next);
    }
    soonest_ = next;
    // Strands that wait for each other only: who could wake them has ended.
    while (soonest_ >= round_end_) {
      if (expected_ == 0 && (alive_ == 0 || soonest_ == kNever)) return;
      step();
      round_end_ += step_length;
    }
  }
}

/// Has what the next robots need on its way while `robot` runs: with a hundred of them the
/// processor waits for memory most of the time.
void Lockstep::fetch_next(std::size_t robot) const {
  if (robot + 2 >= turns_.size()) return;
  Fiber::fetch(turns_[robot + 1].left_off);
  __builtin_prefetch(turns_[robot + 2].only, 1);
  __builtin_prefetch(&places_[robot + 2], 1);
}

void Lockstep::take_turn(std::size_t robot) {
  Strand* const only = turns_[robot].only;
  if (only == nullptr) return run_earliest(robot);
  places_[robot].limit = round_end_;
  run(*only);
  Turn& turn = turns_[robot];
  turn.next = only->wake;
  turn.left_off = only->fiber.left_off();
  if (turn.only == nullptr || only->has_ended) tidy(robot);  // it made another one, or has ended
}

void Lockstep::run_earliest(std::size_t robot) {
  Place& place = places_[robot];
  const auto earlier = [](const auto& a, const auto& b) { return a->wake < b->wake; };
  Strand* const first = std::ranges::min_element(place.strands, earlier)->get();
  place.limit = round_end_;
  for (const auto& other : place.strands) {
    if (other.get() != first) place.limit = std::min(place.limit, other->wake);
  }
  run(*first);
  tidy(robot);
}

void Lockstep::run(Strand& strand) {
  // One thread writes.
  switches_.store(switches_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  running_ = &strand;
  strand.fiber.resume();
  running_ = nullptr;
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
  running_->wake = deadline;
  running_->fiber.suspend();
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

void Lockstep::drop_robot() {
  for (const auto& strand : places_[running_->robot].strands) strand->has_ended = true;
  drop_strand();
}

void Lockstep::drop_strand() {
  places_[running_->robot].has_dropped = true;
  running_->has_ended = true;
  running_->wake = kNever;
  running_->fiber.leave_for_good();  // whoever resumed it forgets it, with its stack
}

}  // namespace eyebridge::robios
