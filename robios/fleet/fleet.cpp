#include "fleet.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <utility>

#include <fmt/format.h>
#include <pthread.h>
#include <unistd.h>

#include "crash_handler.hpp"
#include "fiber_robot.hpp"
#include "generation.hpp"
#include "robot_programs.hpp"
#include "session_parts.hpp"
#include "signals.hpp"
#include "thread_robot.hpp"
#include "watchdog.hpp"

namespace eyebridge::robios {

/// Who lets robots run: one after the other in virtual time, or each by itself.
struct Fleet::Scheduler {
  virtual ~Scheduler() = default;
  /// For the world; null in real time.
  virtual hal::Turns* turns() = 0;
  /// What programs' threads wait for each other with; null in real time.
  virtual Strands* strands() = 0;
  /// So many robots will have a program: before the first one.
  virtual void expect(std::size_t programs) = 0;
  virtual std::unique_ptr<Robot> make(std::size_t index, RobotProgram program,
                                      hal::SharedWorld& world) = 0;
  /// The next robot of the world, in the order of their numbers; null for one without a program.
  virtual void add(Robot* robot) = 0;
  virtual void run(Fleet& fleet) = 0;
  /// Called ten times a second from a thread of ours.
  virtual void look() = 0;
};

namespace {

Fleet* the_fleet = nullptr;  // For signals, which know no objects.

double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

struct Fleet::InLockstep final : Scheduler {
  explicit InLockstep(double hang_limit)
      : watchdog([this] { return lockstep.switches(); }, tell, [this] { interrupt(); },
                 hang_limit) {}

  hal::Turns* turns() override { return &lockstep; }
  Strands* strands() override { return &threads; }
  void expect(std::size_t /*programs*/) override {}
  std::unique_ptr<Robot> make(std::size_t index, RobotProgram program,
                              hal::SharedWorld& /*world*/) override {
    return std::make_unique<FiberRobot>(index, std::move(program), lockstep, threads, awaited);
  }
  void add(Robot* robot) override {
    lockstep.add([this, robot] {
      if (robot == nullptr) lockstep.drop_robot();
      robot->run();
    });
  }
  void run(Fleet& fleet) override {
    const CrashStack stack;
    thread = pthread_self();
    lockstep.run(fleet.world_->step_length(), [&fleet] { fleet.world_->step(); });
    for (const auto& robot : fleet.robots_) robot->end_stuck();
  }
  void look() override {
    ProgramProcess* const process = awaited;
    watchdog.look(processor_time() + (process != nullptr ? process->processor_time() : 0.0));
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
  AwaitedProcess awaited = nullptr;
  Watchdog watchdog;
  pthread_t thread{};
};

struct Fleet::InRealTime final : Scheduler {
  hal::Turns* turns() override { return nullptr; }
  Strands* strands() override { return nullptr; }
  void expect(std::size_t programs) override { barrier = std::make_unique<Barrier>(programs); }
  std::unique_ptr<Robot> make(std::size_t index, RobotProgram program,
                              hal::SharedWorld& world) override {
    return std::make_unique<ThreadRobot>(index, std::move(program), *barrier, world);
  }
  void add(Robot* /*robot*/) override {}  // run() starts them all
  void run(Fleet& fleet) override {
    for (const auto& robot : fleet.robots_) static_cast<ThreadRobot&>(*robot).start();
    constexpr double kPatience_s = 5.0;
    for (bool has_told = false; !barrier->await_all(kPatience_s); has_told = true) {
      const std::size_t awaited = barrier->awaited();
      if (awaited == 0 || has_told) continue;
      fleet.log_.write(Severity::Warning,
                       fmt::format("{} of {} robots have made no call yet: all wait for them",
                                   awaited, fleet.robots_.size()));
    }
  }
  void look() override {}

  std::unique_ptr<Barrier> barrier;
};

Fleet::Fleet(hal::Config config, const std::vector<std::string>& words)
    : config_(std::move(config)), log_(lowest_severity(config_)) {
  if (config_.boolean("fast")) {
    scheduler_ = std::make_unique<InLockstep>(config_.number("hang_limit"));
  } else {
    scheduler_ = std::make_unique<InRealTime>();
  }
  world_ = hal::open_shared_world(config_, log_, scheduler_->turns());
  add_robots(words);
}

Fleet::~Fleet() = default;

void Fleet::add_robots(const std::vector<std::string>& words) {
  const auto scenario =
      config_.is_set("world") ? config_.path("world") : std::filesystem::path("the empty room");
  std::vector<RobotProgram> programs = programs_of(world_->robots(), words, scenario);
  const auto runs = [](const RobotProgram& program) { return !program.file.empty(); };
  const auto is_loaded = [&](const RobotProgram& program) {
    return runs(program) && !is_script(program.file);
  };
  const auto first = std::ranges::find_if(programs, is_loaded);
  if (first != programs.end() && is_of_other_generation(first->file)) become_launcher(true, words);
  scheduler_->expect(static_cast<std::size_t>(std::ranges::count_if(programs, runs)));
  const auto out = config_.is_set("out") ? config_.path("out") : std::filesystem::path();
  for (std::size_t i = 0; i < programs.size(); ++i) {
    Robot* robot = nullptr;
    if (runs(programs[i])) {
      robot = robots_.emplace_back(scheduler_->make(i, std::move(programs[i]), *world_)).get();
    }
    scheduler_->add(robot);  // before its session, whose clock asks for its turn
    if (robot != nullptr) robot->begin(config_, {world_, i}, out);
  }
}

Strands* Fleet::strands() { return scheduler_->strands(); }

int Fleet::run() {
  handle_crashes();
  the_fleet = this;
  watch_signals([](int) { the_fleet->stop(); }, [] { the_fleet->scheduler_->look(); });
  const auto start = std::chrono::steady_clock::now();
  for (const auto& robot : robots_) robot->start_process();  // all interpreters at once
  scheduler_->run(*this);
  while (is_stopped_) pause();  // a signal ends the process
  end();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  Time simulated{0};
  for (const auto& robot : robots_) simulated = std::max(simulated, robot->now());
  fmt::print(
      stderr,
      "eyebridge: {} robots, {:.2f} s on their clock in {:.2f} s ({:.0f}x), state {:016x}{}{}\n",
      robots_.size(), to_seconds(simulated), wall.count(), to_seconds(simulated) / wall.count(),
      world_->hash().value(),
      config_.is_set("out") ? "; results in " + config_.path("out").string() : "",
      world_->overruns() == 0
          ? ""
          : fmt::format("; the computer was too slow {} times", world_->overruns()));
  return exit_code();
}

void Fleet::stop() {
  is_stopped_ = true;
  end();
}

void Fleet::end() {
  for (const auto& robot : robots_) robot->end_session();
  for (const auto& robot : robots_) robot->make_process_end();
  world_->end();
}

int Fleet::exit_code() const {
  for (const auto& robot : robots_) {
    if (robot->exit_code() != 0) return robot->exit_code();
  }
  return 0;
}

}  // namespace eyebridge::robios
