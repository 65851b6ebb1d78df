// A fleet in real time: each program has a thread, the world another.

#include <memory>
#include <utility>

#include <fmt/format.h>

#include "arrivals.hpp"
#include "fleet_scheduler.hpp"
#include "robot_programs.hpp"
#include "thread_robot.hpp"

namespace eyebridge::robios {

struct Fleet::InRealTime final : Scheduler {
  hal::Turns* turns() override { return nullptr; }
  Strands* strands() override { return nullptr; }
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
  void look() override {}

  std::unique_ptr<Barrier> barrier;
};

std::unique_ptr<Fleet::Scheduler> Fleet::in_real_time() { return std::make_unique<InRealTime>(); }

}  // namespace eyebridge::robios
