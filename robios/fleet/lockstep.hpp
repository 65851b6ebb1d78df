#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <vector>

#include "eyebridge/hal/turns.hpp"
#include "fiber.hpp"

namespace eyebridge::robios {

/// Runs the programs of several robots in one virtual time, in one thread: each is a fiber, and in
/// each round of the world they run one after the other, in the order of their numbers.
///
/// A robot may have several flows: its main program and the threads that it makes. Of them the one
/// with the earliest time goes on, and gives way to the next when it gets to that one's time.
class Lockstep final : public hal::Turns {
 public:
  static constexpr Time kNever = Time::max();

  /// One flow of a robot.
  struct Strand {
    Strand(std::size_t of_robot, Time from, std::function<void()> body)
        : robot(of_robot), wake(from), fiber(std::move(body)) {}

    const std::size_t robot;
    Time wake;  ///< When it goes on; kNever: when somebody wakes it.
    bool has_ended = false;
    bool waits_for_all = false;  ///< It has met().
    Fiber fiber;
  };

  Lockstep() = default;
  Lockstep(const Lockstep&) = delete;
  Lockstep& operator=(const Lockstep&) = delete;

  /// A robot whose main flow is `body`, which must not return, from `start` on. Before run(), or in
  /// its `step`.
  void add(std::function<void()> body, Time start);
  /// `robot` has ended: none of its strands goes on. In run()'s `step`.
  void drop(std::size_t robot);
  /// So many robots are still to be added by `step`: run() goes on for them.
  void expect(std::size_t robots) { expected_ = robots; }
  /// So many robots are waited for, where all meet(); before run().
  void gather(std::size_t robots) { missing_ = robots; }
  [[nodiscard]] std::size_t missing() const { return missing_; }
  /// One of these has come there, or will never come, at this time on its clock.
  void count_in(Time now);
  /// Lays the calling strand down until all are there, or nobody can come any more: the time of the
  /// last one, at which all go on in the order of their numbers. At once when that was before.
  Time meet();
  /// Another flow of the calling strand's robot, from now on; `body` must not return but
  /// drop_strand().
  Strand& add_strand(std::function<void()> body);

  /// Runs everything until no robot is left, and none expected. `step` makes a step of the world of
  /// this length.
  void run(Time step_length, const std::function<void()>& step);

  void wait(std::size_t robot, Time time) override;
  [[nodiscard]] const Time& limit_of(std::size_t robot) const override {
    return places_[robot].limit;
  }

  /// The calling flow's; null in none.
  [[nodiscard]] Strand* current() const { return running_; }
  /// Lays the calling strand down until `deadline` or wake(); the robot's others go on.
  void park(Time deadline = kNever);
  /// `strand`, of the calling robot, goes on at the robot's present time.
  void wake(Strand& strand, Time now);
  /// The calling robot has ended: none of its strands goes on. Does not return.
  [[noreturn]] void drop_robot();
  /// The calling strand ends, the robot's others go on. Does not return.
  [[noreturn]] void drop_strand();

  /// `strand`, another one of the calling strand's robot, ends where it waits: it goes no further.
  void drop_other(Strand& strand);

  /// True when the calling strand is its robot's only one.
  [[nodiscard]] bool is_last_strand() const;

  /// Changes whenever another strand runs. Any thread.
  [[nodiscard]] std::uint64_t switches() const { return switches_.load(std::memory_order_relaxed); }
  /// The robot whose strand ran last. Any thread.
  [[nodiscard]] std::size_t whose_turn() const { return whose_.load(std::memory_order_relaxed); }

 private:
  /// When a robot goes on, in a table that the processor reads ahead.
  struct Turn {
    Time next{0};            ///< Its earliest strand's time.
    Strand* only = nullptr;  ///< When it has one strand, that.
  };
  struct Place {
    Time limit{0};                                 ///< How far the one that runs may go by itself.
    std::vector<std::unique_ptr<Strand>> strands;  ///< In the order they were made.
    bool has_dropped = false;
  };

  void take_turn();
  void fetch_next() const;
  [[nodiscard]] Strand& earliest();
  void begin_turn(Strand& strand, Time limit);
  Strand* next_in_round();
  void tidy(std::size_t robot);
  void let_all_go(Time now);

  Time round_end_{0};         ///< The first moment after this round.
  std::size_t at_ = 0;        ///< In a round: whose turn it is.
  std::deque<Place> places_;  ///< A queue: its elements stay where they are.
  std::vector<Turn> turns_;
  Strand* running_ = nullptr;
  std::size_t alive_ = 0;
  std::size_t expected_ = 0;
  Time soonest_ = kNever;  ///< When somebody goes on; in a round, of those before at_.
  std::atomic<std::uint64_t> switches_ = 0;
  std::atomic<std::size_t> whose_ = 0;
  std::size_t missing_ = 0;
  Time met_{0};             ///< When the last one came, so far.
  bool have_met_ = false;   ///< All.
  bool any_waits_ = false;  ///< For all.
};

}  // namespace eyebridge::robios
