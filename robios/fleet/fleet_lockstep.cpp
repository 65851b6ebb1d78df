// A fleet in virtual time: its programs take turns in one thread.

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "arrivals.hpp"
#include "crash_handler.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/hal/environment.hpp"
#include "fiber_robot.hpp"
#include "fleet_scheduler.hpp"
#include "hold_up.hpp"
#include "thread_state.hpp"
#include "thread_wait.hpp"
#include "watchdog.hpp"

namespace eyebridge::robios {

struct Fleet::InLockstep final : Scheduler {
  explicit InLockstep(double hang_limit)
      : watchdog([this] { return progress(); }, [this](double seconds) { tell(seconds); },
                 [this] { interrupt(); }, hang_limit),
        waiting([this] { return progress(); }, [this](double seconds) { tell(seconds); }, [] {},
                hang_limit) {}

  hal::Turns* turns() override { return &lockstep; }
  void expect(std::size_t programs, std::size_t newcomers) override {
    programs_at_start = programs;
    lockstep.gather(programs);
    lockstep.expect(newcomers);
  }
  std::unique_ptr<Robot> make(std::size_t index, RobotProgram program,
                              hal::SharedWorld& /*world*/) override {
    return std::make_unique<FiberRobot>(index, std::move(program), lockstep, awaited);
  }
  void add(Robot* robot, Time start) override {
    lockstep.add(
        [this, robot] {
          if (robot == nullptr || !robot->has_begun()) lockstep.drop_robot();
          robot->run();
        },
        start);
  }
  void start_late(Robot& robot) override { static_cast<FiberRobot&>(robot).be_late(); }
  void run(Fleet& fleet, const std::vector<Robot*>& /*robots*/) override {
    const CrashStack stack;
    tid = gettid();
    running = &fleet;
    time = &fleet.world_->environment().time();
    lockstep.run(fleet.world_->step_length(), [this, &fleet] { between_rounds(fleet); });
    running = nullptr;  // who waits for a person from now on holds up nobody
    arrivals.close();
  }
  void between_rounds(Fleet& fleet) {
    fleet.world_->step();
    rounds.fetch_add(1, std::memory_order_relaxed);
    if (lockstep.missing() > 0) tell_of_missing(fleet);
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
    if (running == nullptr) return;
    ProgramProcess* const process = awaited;
    const ThreadState state = look_at_thread(tid);
    double processor_s = state.processor_s;
    bool sleeps = state.kind == ThreadState::Kind::Sleeps;
    if (process != nullptr) {
      processor_s += process->processor_time();
      sleeps = look_at_process(process->pid()).kind == ThreadState::Kind::Sleeps;
    }
    constexpr double kPeriod_s = 0.1;
    hold_up.look(processor_s, sleeps, kPeriod_s);
    // Who waits for a person, at a terminal or, a process of its own, at its windows, is only told
    // of.
    if (hold_up.is_waiting() && (process != nullptr || present_wait().is_at_terminal)) {
      waited_for_person_s += kPeriod_s;
    }
    watchdog.look(hold_up.processor_s() + hold_up.waited_s() - waited_for_person_s);
    waiting.look(waited_for_person_s);
  }
  std::uint64_t progress() {
    // While a person lets time stand still nobody hangs.
    hal::TimeControl* const control = time;
    if (control != nullptr && control->is_paused()) ++paused_looks;
    return lockstep.switches() + rounds + paused_looks;
  }
  /// What all wait for; a robot that computes waits for nothing.
  [[nodiscard]] ThreadWait present_wait() const {
    if (!hold_up.is_waiting()) return {};
    ProgramProcess* const process = awaited;
    const int pid = process != nullptr ? process->pid() : getpid();
    return look_at_wait(pid, process != nullptr ? pid : tid);
  }
  void interrupt() {
    if (ProgramProcess* const process = awaited) {
      process->kill_hanging();
      return;
    }
    for (Robot* const robot : running.load()->robots()) {
      if (robot->index() != lockstep.whose_turn()) continue;
      const std::string call = present_wait().call;
      eyebridge::tell(
          fmt::format("robot {}: error: the program has made no call for too long{}, by "
                      "--hang-limit: all robots end (with --isolate only this one would)",
                      robot->index() + 1, call.empty() ? "" : ", and waits in " + call));
      robot->break_off(124);
      running.load()->end_without(*robot);
    }
  }
  void tell_of_missing(Fleet& fleet) {
    constexpr Time kPatience = std::chrono::seconds(60);
    if (fleet.world_->now() < kPatience || std::exchange(has_told, true)) return;
    fleet.log_.write(
        Severity::Warning,
        fmt::format("{} of {} robots have made no call in the first {} s of their "
                    "time: all wait for them",
                    lockstep.missing(), programs_at_start, kPatience / std::chrono::seconds(1)));
  }
  void tell(double seconds) {
    const ThreadWait wait = present_wait();
    fmt::print(
        stderr, "eyebridge: robot {}: warning: the program has {}; all robots wait for it\n",
        lockstep.whose_turn() + 1,
        wait.call.empty()
            ? fmt::format("computed for {:g} s without a call with which its time passes", seconds)
            : fmt::format("waited for {:g} s in {}{}", seconds, wait.call,
                          wait.is_at_terminal ? " at the terminal" : ""));
  }

  Lockstep lockstep;
  Arrivals arrivals;
  std::atomic<std::uint64_t> rounds = 0;  ///< While all sleep, or are still to come.
  AwaitedProcess awaited = nullptr;
  std::size_t programs_at_start = 0;
  bool has_told = false;                          ///< Of those who are missing.
  std::atomic<hal::TimeControl*> time = nullptr;  ///< Of the world, which runs.
  std::uint64_t paused_looks = 0;
  HoldUp hold_up;
  double waited_for_person_s = 0.0;
  Watchdog watchdog;
  Watchdog waiting;
  int tid = 0;
  std::atomic<Fleet*> running = nullptr;
};

std::unique_ptr<Fleet::Scheduler> Fleet::in_lockstep(double hang_limit) {
  return std::make_unique<InLockstep>(hang_limit);
}

}  // namespace eyebridge::robios
