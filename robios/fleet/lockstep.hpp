#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "eyebridge/hal/turns.hpp"
#include "fiber.hpp"

namespace eyebridge::robios {

/// Runs the programs of several robots in one virtual time, in one thread: each is a fiber, and in
/// each round of the world they run one after the other, in the order of their numbers.
class Lockstep final : public hal::Turns {
 public:
  static constexpr Time kNever = Time::max();

  Lockstep() = default;
  Lockstep(const Lockstep&) = delete;
  Lockstep& operator=(const Lockstep&) = delete;

  /// A robot whose program is `body`, which must not return, from `start` on. Before run(), or in
  /// its `step`.
  void add(std::function<void()> body, Time start);
  /// `robot` has ended: it does not go on. In run()'s `step`.
  void drop(std::size_t robot);
  /// So many robots are still to be added by `step`: run() goes on for them.
  void expect(std::size_t robots) { expected_ = robots; }
  /// So many robots are waited for, where all meet(); before run().
  void gather(std::size_t robots) { missing_ = robots; }
  [[nodiscard]] std::size_t missing() const { return missing_; }
  /// One of these has come there, or will never come, at this time on its clock.
  void count_in(Time now);
  /// Lays the calling robot down until all are there, or nobody can come any more: the time of the
  /// last one, at which all go on in the order of their numbers. At once when that was before.
  Time meet();

  /// Runs everything until no robot is left, and none expected. `step` makes a step of the world of
  /// this length.
  void run(Time step_length, const std::function<void()>& step);

  void wait(std::size_t /*robot*/, Time time) override { park(time); }
  [[nodiscard]] const Time& limit_of(std::size_t /*robot*/) const override { return round_end_; }

  /// Lays the calling robot down until `time`.
  void park(Time time);
  /// The calling robot has ended. Does not return.
  [[noreturn]] void drop_robot();

  /// Changes whenever another robot runs. Any thread.
  [[nodiscard]] std::uint64_t switches() const { return switches_.load(std::memory_order_relaxed); }
  /// The robot that ran last. Any thread.
  [[nodiscard]] std::size_t whose_turn() const { return whose_.load(std::memory_order_relaxed); }

 private:
  /// When a robot goes on, in a table that the processor reads ahead.
  struct Turn {
    Time next{0};
    std::unique_ptr<Fiber> fiber;  ///< Null when it has ended.
    bool waits_for_all = false;    ///< It has met().
  };

  void take_turn();
  void fetch_next() const;
  void begin_turn();
  Fiber* next_in_round();
  void let_all_go(Time now);

  Time round_end_{0};     ///< The first moment after this round: so far robots go by themselves.
  std::size_t at_ = 0;    ///< In a round: whose turn it is.
  bool is_over_ = false;  ///< The robot at_ has ended in its turn.
  std::vector<Turn> turns_;
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
