#include "fleet.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <utility>

#include <fmt/format.h>
#include <pthread.h>
#include <unistd.h>

#include "arrivals.hpp"
#include "crash_handler.hpp"
#include "fiber_robot.hpp"
#include "generation.hpp"
#include "robot_calls.hpp"
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
  /// So many robots will have a program, and so many will enter later: before the first one.
  virtual void expect(std::size_t programs, std::size_t newcomers) = 0;
  virtual std::unique_ptr<Robot> make(std::size_t index, RobotProgram program,
                                      hal::SharedWorld& world) = 0;
  /// The next robot of the world, in the order of their numbers, from `start` on; null for one
  /// without a program.
  virtual void add(Robot* robot, Time start) = 0;
  /// Lets `robot`, which entered while the others run, run, too.
  virtual void start_late(Robot& robot) = 0;
  /// Lets those of the start run, and all that enter later, to the end.
  virtual void run(Fleet& fleet, const std::vector<Robot*>& robots) = 0;
  /// Fleet::add().
  virtual Result<std::size_t> let_in(Fleet& fleet, hal::Newcomer newcomer) = 0;
  /// Called ten times a second from a thread of ours.
  virtual void look() = 0;
};

namespace {

Fleet* the_fleet = nullptr;  // For signals, which know no objects.

/// When the time limit of all is over.
bool comes_too_late(Time time, const hal::Config& config) {
  return config.is_set("time_limit") && time >= from_seconds(config.number("time_limit"));
}

double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

struct Fleet::InLockstep final : Scheduler {
  explicit InLockstep(double hang_limit)
      : watchdog([this] { return lockstep.switches() + rounds; }, tell, [this] { interrupt(); },
                 hang_limit) {}

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
    arrivals.serve([&fleet](const hal::Newcomer& newcomer) {
      return fleet.enter(newcomer, fleet.program_of(newcomer));
    });
  }
  Result<std::size_t> let_in(Fleet& /*fleet*/, hal::Newcomer newcomer) override {
    return arrivals.ask(std::move(newcomer));
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
  Arrivals arrivals;
  std::atomic<std::uint64_t> rounds = 0;  ///< While all sleep, or are still to come.
  AwaitedProcess awaited = nullptr;
  Watchdog watchdog;
  pthread_t thread{};
};

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
  void look() override {}

  std::unique_ptr<Barrier> barrier;
};

Fleet::Fleet(hal::Config config, const std::vector<std::string>& words,
             eyebridge_robot_calls& calls)
    : config_(std::move(config)),
      log_(lowest_severity(config_)),
      scenario_(config_.is_set("world") ? config_.path("world") : "the empty room") {
  if (config_.boolean("fast")) {
    scheduler_ = std::make_unique<InLockstep>(config_.number("hang_limit"));
  } else {
    scheduler_ = std::make_unique<InRealTime>();
  }
  calls = robot_calls(scheduler_->strands());
  world_ = hal::open_shared_world(config_, log_, scheduler_->turns());
  add_robots(words);
}

Fleet::~Fleet() = default;

void Fleet::add_robots(const std::vector<std::string>& words) {
  std::vector<hal::SharedRobot> all = world_->robots();
  const std::size_t count = all.size();
  for (const hal::Newcomer& newcomer : world_->newcomers()) {
    if (comes_too_late(newcomer.time, config_)) break;
    all.push_back({newcomer.model.name, newcomer.program, newcomer.arguments});
  }
  std::vector<RobotProgram> programs = programs_of(all, words, scenario_);
  const auto runs = [](const RobotProgram& program) { return !program.file.empty(); };
  const auto is_loaded = [&](const RobotProgram& program) {
    return runs(program) && !is_script(program.file);
  };
  const auto first = std::ranges::find_if(programs, is_loaded);
  if (first != programs.end() && is_of_other_generation(first->file)) become_launcher(true, words);
  const auto first_late = programs.begin() + static_cast<std::ptrdiff_t>(count);
  newcomer_programs_.assign(first_late, programs.end());
  programs.erase(first_late, programs.end());
  scheduler_->expect(static_cast<std::size_t>(std::ranges::count_if(programs, runs)),
                     newcomer_programs_.size());
  for (std::size_t i = 0; i < count; ++i) add_robot(i, std::move(programs[i]));
}

Robot* Fleet::add_robot(std::size_t index, RobotProgram program) {
  Robot* robot = nullptr;
  if (!program.file.empty()) {
    robot = robots_.emplace_back(scheduler_->make(index, std::move(program), *world_)).get();
  }
  scheduler_->add(robot, world_->now());  // before its session, whose clock asks for its turn
  if (robot == nullptr) return nullptr;
  const auto out = config_.is_set("out") ? config_.path("out") : std::filesystem::path();
  robot->begin(config_, {world_, index}, out);
  return robot;
}

Result<std::size_t> Fleet::add(hal::Newcomer newcomer) {
  return scheduler_->let_in(*this, std::move(newcomer));
}

RobotProgram Fleet::program_of(const hal::Newcomer& newcomer) const {
  if (newcomer.program.empty()) return {};
  return programs_of({{newcomer.model.name, newcomer.program, newcomer.arguments}}, {}, scenario_)
      .front();
}

Result<std::size_t> Fleet::enter(const hal::Newcomer& newcomer, RobotProgram program) {
  const std::lock_guard lock(mutex_);
  return world_->enter(newcomer).and_then([&](std::size_t index) -> Result<std::size_t> {
    try {
      Robot* const robot = add_robot(index, std::move(program));
      if (robot != nullptr) scheduler_->start_late(*robot);
      return index;
    } catch (const std::exception& error) {  // it stands there without a program
      return fail(Errc::Unsupported, fmt::format("robot {}: {}", index + 1, error.what()));
    }
  });
}

std::optional<Time> Fleet::next_entry() const {
  if (entries_ == newcomer_programs_.size()) return std::nullopt;
  return world_->newcomers()[entries_].time;
}

bool Fleet::let_next_in() {
  const hal::Newcomer& newcomer = world_->newcomers()[entries_];
  RobotProgram program = std::move(newcomer_programs_[entries_++]);
  const bool runs = !program.file.empty();
  const auto index = enter(newcomer, std::move(program));
  if (index) return runs;
  has_refused_ = true;
  log_.write(Severity::Error,
             fmt::format("{}: a robot cannot enter after {:g} s: {}", newcomer.where.str(),
                         to_seconds(newcomer.time), index.error().what));
  return false;
}

std::vector<Robot*> Fleet::robots() const {
  const std::lock_guard lock(mutex_);
  std::vector<Robot*> out;
  for (const auto& robot : robots_) {
    if (robot->has_begun()) out.push_back(robot.get());
  }
  return out;
}

int Fleet::run() {
  handle_crashes();
  the_fleet = this;
  watch_signals([](int) { the_fleet->stop(); }, [] { the_fleet->scheduler_->look(); });
  const std::vector<Robot*> robots_at_start = robots();
  door_.emplace(*world_, [this](hal::Newcomer newcomer) { return add(std::move(newcomer)); });
  const auto start = std::chrono::steady_clock::now();
  for (Robot* const robot : robots_at_start) robot->start_process();  // all interpreters at once
  scheduler_->run(*this, robots_at_start);
  door_->finish();
  while (is_stopped_) pause();  // a signal ends the process
  end();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  Time simulated{0};
  const std::vector<Robot*> all = robots();
  for (Robot* const robot : all) simulated = std::max(simulated, robot->now());
  fmt::print(
      stderr,
      "eyebridge: {} robots, {:.2f} s on their clock in {:.2f} s ({:.0f}x), state {:016x}{}{}\n",
      all.size(), to_seconds(simulated), wall.count(), to_seconds(simulated) / wall.count(),
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
  Door::close();
  for (Robot* const robot : robots()) robot->end_session();
  for (Robot* const robot : robots()) robot->make_process_end();
  world_->end();
}

int Fleet::exit_code() const {
  for (Robot* const robot : robots()) {
    if (robot->exit_code() != 0) return robot->exit_code();
  }
  return has_refused_ ? 1 : 0;
}

}  // namespace eyebridge::robios
