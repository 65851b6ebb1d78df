#include "lockstep.hpp"

#include <algorithm>
#include <utility>

namespace eyebridge::robios {

void Lockstep::add(std::function<void()> body) {
  auto& place = *places_.emplace_back(std::make_unique<Place>());
  const std::size_t robot = places_.size() - 1;
  place.strands.push_back(
      std::make_unique<Strand>(Strand{robot, std::make_unique<Fiber>(std::move(body))}));
  next_.push_back(Time(0));
  ++alive_;
}

Lockstep::Strand& Lockstep::add_strand(std::function<void()> body) {
  Place& place = *places_[running_->robot];
  auto& strand = *place.strands.emplace_back(std::make_unique<Strand>(
      Strand{running_->robot, std::make_unique<Fiber>(std::move(body)), kNever}));
  return strand;
}

void Lockstep::run(Time step_length, const std::function<void()>& step) {
  round_end_ = step_length;
  while (alive_ > 0) {
    Time next = kNever;
    for (std::size_t robot = 0; robot < next_.size(); ++robot) {
      while (next_[robot] < round_end_) run_next(robot);
      next = std::min(next, next_[robot]);
    }
    if (alive_ == 0) return;
    // Strands that wait for each other only: who could wake them has ended.
    if (next == kNever) return;
    do {
      step();
      round_end_ += step_length;
    } while (next >= round_end_);
  }
}

void Lockstep::run_next(std::size_t robot) {
  Place& place = *places_[robot];
  Strand* first = place.strands.front().get();
  place.limit = round_end_;
  if (place.strands.size() > 1) {
    const auto earlier = [](const auto& a, const auto& b) { return a->wake < b->wake; };
    first = std::ranges::min_element(place.strands, earlier)->get();
    for (const auto& other : place.strands) {
      if (other.get() != first) place.limit = std::min(place.limit, other->wake);
    }
  }
  switches_.fetch_add(1, std::memory_order_relaxed);
  running_ = first;
  first->fiber->resume();
  running_ = nullptr;
  if (place.strands.size() == 1 && !place.has_dropped) {
    next_[robot] = first->wake;
  } else {
    tidy(robot);
  }
}

/// Forgets what was dropped, and finds the robot's next time.
void Lockstep::tidy(std::size_t robot) {
  Place& place = *places_[robot];
  if (place.has_dropped) {
    place.has_dropped = false;
    std::erase_if(place.strands, [](const auto& strand) { return strand->fiber == nullptr; });
    if (place.strands.empty()) --alive_;
  }
  next_[robot] = kNever;
  for (const auto& strand : place.strands) next_[robot] = std::min(next_[robot], strand->wake);
}

void Lockstep::wait(std::size_t /*robot*/, Time time) { park(time); }

void Lockstep::park(Time deadline) {
  running_->wake = deadline;
  Fiber::suspend();
}

void Lockstep::wake(Strand& strand, Time now) {
  strand.wake = std::min(strand.wake, now);
  next_[strand.robot] = std::min(next_[strand.robot], strand.wake);
  // The one that runs gives way when it gets there.
  Time& limit = places_[strand.robot]->limit;
  limit = std::min(limit, strand.wake);
}

bool Lockstep::is_last_strand() const {
  const auto is_there = [](const auto& strand) { return strand->fiber != nullptr; };
  return std::ranges::count_if(places_[running_->robot]->strands, is_there) == 1;
}

void Lockstep::drop_robot() {
  Place& place = *places_[running_->robot];
  for (const auto& strand : place.strands) {
    if (strand.get() != running_) strand->fiber.reset();
  }
  drop_strand();
}

void Lockstep::drop_strand() {
  places_[running_->robot]->has_dropped = true;
  // Its stack is in use until it is left: whoever resumed it lets it go.
  Fiber* const mine = running_->fiber.release();
  running_->wake = kNever;
  mine->leave_for_good();
}

}  // namespace eyebridge::robios
