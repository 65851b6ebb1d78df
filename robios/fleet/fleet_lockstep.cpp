// A fleet in virtual time: its programs take turns in one thread.

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <utility>

#include <fmt/format.h>
#include <pthread.h>

#include "arrivals.hpp"
#include "crash_handler.hpp"
#include "eyebridge/hal/environment.hpp"
#include "fiber_robot.hpp"
#include "fleet_scheduler.hpp"
#include "watchdog.hpp"

namespace eyebridge::robios {
namespace {

double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

struct Fleet::InLockstep final : Scheduler {
  explicit InLockstep(double hang_limit)
      : watchdog([this] { return progress(); }, tell, [this] { interrupt(); }, hang_limit) {}

  hal::Turns* turns() override { return &lockstep; }
  Strands* strands() override { return &threads; }
  void expect(std::size_t /*programs*/, std::size_t newcomers) override {
    lockstep.expect(newcomers);
  }
  std::unique_ptr<Robot> make(std::size_t index, RobotProgram program,
                              hal::SharedWorld& /*world*/) override {
    return std::make_unique<FiberRobot>(index, std::move(program), lockstep, threads, awaited);
  }
  void add(Robot* robot, Time start) override {
    lockstep.add(
        [this, robot] {
          if (robot == nullptr || !robot->has_begun()) lockstep.drop_robot();
          robot->run();
        },
        start);
  }
  void start_late(Robot& /*robot*/) override {}
  void run(Fleet& fleet, const std::vector<Robot*>& /*robots*/) override {
    const CrashStack stack;
    thread = pthread_self();
    time = &fleet.world_->environment().time();
    lockstep.run(fleet.world_->step_length(), [this, &fleet] { between_rounds(fleet); });
    arrivals.close();
    for (Robot* const robot : fleet.robots()) robot->end_stuck();
  }
  void between_rounds(Fleet& fleet) {
    fleet.world_->step();
    rounds.fetch_add(1, std::memory_order_relaxed);
    for (auto next = fleet.next_entry(); next && *next <= fleet.world_->now();
         next = fleet.next_entry()) {
      fleet.let_next_in();
      lockstep.expect(fleet.newcomer_programs_.size() - fleet.entries_);
    }
    arrivals.serve();
  }
  Result<std::size_t> let_in(Fleet& fleet, hal::Newcomer newcomer) override {
    return arrivals.ask([&fleet, newcomer = std::move(newcomer)] {
      return fleet.enter(newcomer, fleet.program_of(newcomer));
    });
  }
  Result<std::size_t> let_out(Fleet& fleet, std::size_t index) override {
    return arrivals.ask([&fleet, index] { return fleet.leave(index); });
  }
  void look() override {
    ProgramProcess* const process = awaited;
    watchdog.look(processor_time() + (process != nullptr ? process->processor_time() : 0.0));
  }
  std::uint64_t progress() {
    // While a person lets time stand still nobody hangs.
    hal::TimeControl* const control = time;
    if (control != nullptr && control->is_paused()) ++paused_looks;
    return lockstep.switches() + rounds + paused_looks;
  }
  void interrupt() {
    if (ProgramProcess* const process = awaited) {
      process->kill_hanging();
    } else {
      interrupt_robot(thread);
    }
  }
  static void tell(double seconds) {
    fmt::print(stderr,
               "eyebridge: warning: a program has computed for {} s without a call with which its "
               "time passes; all robots wait for it\n",
               seconds);
  }

  Lockstep lockstep;
  Strands threads{lockstep};
  Arrivals arrivals;
  std::atomic<std::uint64_t> rounds = 0;  ///< While all sleep, or are still to come.
  AwaitedProcess awaited = nullptr;
  std::atomic<hal::TimeControl*> time = nullptr;  ///< Of the world, which runs.
  std::uint64_t paused_looks = 0;
  Watchdog watchdog;
  pthread_t thread{};
};

std::unique_ptr<Fleet::Scheduler> Fleet::in_lockstep(double hang_limit) {
  return std::make_unique<InLockstep>(hang_limit);
}

}  // namespace eyebridge::robios
