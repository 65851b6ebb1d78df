#include "fleet.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <semaphore>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "crash_handler.hpp"
#include "eyebridge/base/deaf_thread.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/hal/environment.hpp"
#include "fleet_scheduler.hpp"
#include "generation.hpp"
#include "robot_calls.hpp"
#include "robot_programs.hpp"
#include "session_parts.hpp"
#include "session_windows.hpp"
#include "signals.hpp"
#include "windows/open_windows.hpp"

namespace eyebridge::robios {

namespace {

Fleet* the_fleet = nullptr;  // For signals, which know no objects.

}  // namespace

Fleet::Fleet(hal::Config config, const std::vector<std::string>& words,
             eyebridge_robot_calls& calls)
    : config_(std::move(config)),
      log_(lowest_severity(config_)),
      scheduler_(config_.boolean("fast") ? in_lockstep(config_.number("hang_limit"))
                                         : in_real_time(config_.number("hang_limit"))),
      scenario_(config_.is_set("world") ? config_.path("world") : "the empty room") {
  if (config_.boolean("isolate") && config_.boolean("shared_globals")) {
    throw ConfigError(
        {"isolate"},
        "programs in processes of their own cannot share variables; leave out isolate "
        "or shared_globals");
  }
  calls = robot_calls();
  windows_ = open_session_windows(config_, log_);
  world_ = hal::open_shared_world(config_, log_, scheduler_->turns());
  add_robots(words);
  config_.keep_outputs();
}

Fleet::~Fleet() = default;

bool Fleet::comes_too_late(Time time, const hal::Config& config) {
  return config.is_set("time_limit") && time >= from_seconds(config.number("time_limit"));
}

void Fleet::add_robots(const std::vector<std::string>& words) {
  std::vector<hal::SharedRobot> all = world_->robots();
  const std::size_t count = all.size();
  for (const hal::Newcomer& newcomer : world_->newcomers()) {
    if (comes_too_late(newcomer.time, config_)) break;
    all.push_back({newcomer.model.name, newcomer.program, newcomer.arguments});
  }
  if (words.empty()) check_trust(all, scenario_);
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

Result<std::size_t> Fleet::add(const Words& words) {
  try {
    return add(read_newcomer(words, *world_));
  } catch (const std::exception& error) {
    return fail(Errc::OutOfRange, error.what());
  }
}

Result<std::size_t> Fleet::answer(const Words& words) {
  if (words.empty() || words.front() != kRemove) return add(words);
  try {
    return scheduler_->let_out(*this, read_leaver(words));
  } catch (const ConfigError& error) {
    return fail(Errc::OutOfRange, error.what());
  }
}

Result<void> Fleet::remove(std::size_t index) {
  return scheduler_->let_out(*this, index).map([](std::size_t) {});
}

Result<std::size_t> Fleet::leave(std::size_t index) {
  const std::lock_guard lock(leaving_);
  if (const auto possible = world_->can_leave(index); !possible) {
    return tl::unexpected(possible.error());
  }
  const std::vector<Robot*> all = robots();
  const auto found = std::ranges::find(all, index, &Robot::index);
  if (found != all.end()) {
    (*found)->remove();  // its results show the world with it
    if (windows_ != nullptr && (*found)->screen() != nullptr) {
      windows_->close_panel(*(*found)->screen());
    }
  }
  log_.write(Severity::Info, fmt::format("robot {} is removed", index + 1));
  return world_->leave(index).map([index] { return index; });
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
  watch_signals([](int) { the_fleet->stop(); }, [] { the_fleet->look(); });
  const std::vector<Robot*> robots_at_start = robots();
  control_.emplace([this](const Words& words) { return answer(words); }, log_);
  if (windows_ != nullptr) {
    show_world(*windows_, world_->environment(), this);
  } else {
    tell_of_ignored_pause(world_->environment(), log_);
  }
  const auto start = std::chrono::steady_clock::now();
  for (Robot* const robot : robots_at_start) robot->start_process();  // all interpreters at once
  scheduler_->run(*this, robots_at_start);
  control_->finish();
  while (is_stopped_) pause();  // a signal ends the process
  end();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  Time simulated{0};
  const std::vector<Robot*> all = robots();
  for (Robot* const robot : all) simulated = std::max(simulated, robot->now());
  const std::string told =
      fmt::format("{} robots, {:.2f} s on their clock in {:.2f} s ({:.0f}x), trace {:016x}{}{}",
                  all.size(), to_seconds(simulated), wall.count(),
                  to_seconds(simulated) / wall.count(), world_->hash().value(),
                  config_.is_set("out") ? "; results in " + config_.path("out").string() : "",
                  world_->overruns() == 0
                      ? ""
                      : fmt::format("; the computer was too slow {} times", world_->overruns()));
  tell(told);
  if (windows_ != nullptr) {
    std::fflush(nullptr);  // whoever reads the programs' output does not wait for the person
    windows_->finish("All programs have ended");
  }
  return exit_code();
}

void Fleet::stop() {
  is_stopped_ = true;
  end();
  if (windows_ != nullptr) windows_->complete_files();
}

void Fleet::end() {
  ControlServer::close();
  for (Robot* const robot : robots()) robot->end_session();
  for (Robot* const robot : robots()) robot->make_process_end();
  world_->end();
  if (const std::string lost = world_->lost_results(); !lost.empty() && !has_lost_results_) {
    has_lost_results_ = true;
    log_.write(Severity::Error, lost);
  }
}

void Fleet::look() {
  if (Robot* const robot = broken_robot()) end_without(*robot);
  scheduler_->look();
}

void Fleet::end_without(Robot& broken) {
  // Each step may need a lock that the broken program holds: it has a thread and a limit of its
  // own.
  static std::counting_semaphore<> done(0);
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(3);
  bool have_ended = true;
  const auto try_to = [&](std::function<void()> act) {
    deaf_thread([act = std::move(act)] {
      act();
      done.release();
    }).detach();
    const auto soon = std::chrono::steady_clock::now() + std::chrono::milliseconds(500);
    have_ended = done.try_acquire_until(std::min(soon, end)) && have_ended;
  };
  try_to([] { std::fflush(stdout); });
  for (Robot* const robot : robots()) {
    if (robot != &broken) try_to([robot] { robot->end_session(); });
  }
  try_to([&broken] { broken.end_session(); });
  try_to([this] { world_->end(); });
  for (Robot* const robot : robots()) try_to([robot] { robot->make_process_end(); });
  log_.write(Severity::Error, have_ended ? "the run is ended; results are written"
                                         : "the run is ended; results are missing");
  _exit(exit_code());
}

int Fleet::exit_code() const {
  for (Robot* const robot : robots()) {
    if (robot->exit_code() != 0) return robot->exit_code();
  }
  const bool any_lost = has_lost_results_ || std::ranges::any_of(robots(), [](Robot* robot) {
                          return robot->has_lost_results();
                        });
  return has_refused_ || any_lost ? 1 : 0;
}

}  // namespace eyebridge::robios
