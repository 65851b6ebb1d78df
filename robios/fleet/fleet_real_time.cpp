// A fleet in real time: each program has a thread, the world another.

#include <atomic>
#include <cstdio>
#include <map>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "arrivals.hpp"
#include "eyebridge/base/log.hpp"
#include "fleet_scheduler.hpp"
#include "robot_programs.hpp"
#include "thread_robot.hpp"
#include "thread_state.hpp"
#include "watchdog.hpp"

namespace eyebridge::robios {

struct Fleet::InRealTime final : Scheduler {
  explicit InRealTime(double limit_s) : hang_limit(limit_s) {}

  hal::Turns* turns() override { return nullptr; }
  void expect(std::size_t programs, std::size_t newcomers) override {
    barrier = std::make_unique<Barrier>(programs, newcomers);
  }
  std::unique_ptr<Robot> make(std::size_t index, RobotProgram program,
                              hal::SharedWorld& world) override {
    return std::make_unique<ThreadRobot>(index, std::move(program), *barrier, world);
  }
  void add(Robot* /*robot*/, Time /*start*/) override {}  // run() starts them all
  void start_late(Robot& robot) override { static_cast<ThreadRobot&>(robot).start_late(); }
  void run(Fleet& fleet, const std::vector<Robot*>& robots) override {
    for (Robot* const robot : robots) static_cast<ThreadRobot&>(*robot).start();
    running = &fleet;
    if (robots.empty()) fleet.world_->begin_time();  // nobody else does; some enter later
    constexpr double kPatience_s = 5.0;
    for (bool has_told = false; !barrier->await_start(kPatience_s); has_told = true) {
      if (has_told) continue;
      fleet.log_.write(Severity::Warning,
                       fmt::format("{} of {} robots have made no call yet: all wait for them",
                                   barrier->awaited(), robots.size()));
    }
    while (const auto next = fleet.next_entry()) {
      fleet.world_->wait_until(*next);
      if (!fleet.let_next_in()) barrier->leave(true, [] {});
    }
    barrier->await_end();
    running = nullptr;
  }
  Result<std::size_t> let_in(Fleet& fleet, hal::Newcomer newcomer) override {
    if (!barrier->join()) return Arrivals::too_late();
    RobotProgram program = fleet.program_of(newcomer);
    const bool runs = !program.file.empty();
    auto index = fleet.enter(newcomer, std::move(program));
    if (!index || !runs) barrier->leave(true, [] {});
    return index;
  }
  Result<std::size_t> let_out(Fleet& fleet, std::size_t index) override {
    // So that the run has not ended before the robot is out of the world.
    if (!barrier->join()) return Arrivals::too_late();
    auto left = fleet.leave(index);
    barrier->leave(true, [] {});
    return left;
  }
  void look() override {
    Fleet* const fleet = running;
    if (fleet == nullptr) return;
    const bool is_over = comes_too_late(fleet->world_->now(), fleet->config_);
    looks_over = is_over ? looks_over + 1 : 0;
    for (Robot* const each : fleet->robots()) {
      auto& robot = static_cast<ThreadRobot&>(*each);
      if (robot.has_ended() || robot.tid() == 0) continue;
      // Whoever calls has ended by itself.
      constexpr int kPatience_looks = 10;
      if (looks_over > kPatience_looks) {
        robot.remove(0, "the program has made no call since the time limit was reached; it ends");
      } else {
        watchdog_of(robot).look(look_at_thread(robot.tid()).processor_s);
      }
    }
  }
  Watchdog& watchdog_of(ThreadRobot& robot) {
    return watchdogs
        .try_emplace(
            &robot, [&robot] { return robot.calls(); },
            [&robot](double seconds) { tell(robot, seconds); }, [&robot] { end_early(robot); },
            hang_limit)
        .first->second;
  }
  static void tell(const Robot& robot, double seconds) {
    eyebridge::tell(
        fmt::format("robot {}: warning: the program has computed for {:g} s without a call",
                    robot.index() + 1, seconds));
  }
  /// One that computes on holds up nobody, but where all wait for its first call.
  static void end_early(ThreadRobot& robot) {
    if (robot.has_arrived()) return;
    robot.remove(124,
                 "the program has made no first call for too long and is ended; the others go on");
  }

  const double hang_limit;
  std::map<const Robot*, Watchdog> watchdogs;
  int looks_over = 0;
  std::atomic<Fleet*> running = nullptr;
  std::unique_ptr<Barrier> barrier;
};

std::unique_ptr<Fleet::Scheduler> Fleet::in_real_time(double hang_limit) {
  return std::make_unique<InRealTime>(hang_limit);
}

}  // namespace eyebridge::robios
