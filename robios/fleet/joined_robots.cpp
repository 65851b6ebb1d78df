#include "joined_robots.hpp"

#include <algorithm>
#include <exception>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <pthread.h>

#include "eyebridge/base/deaf_thread.hpp"
#include "flow.hpp"
#include "robot_programs.hpp"
#include "session_parts.hpp"
#include "thread_state.hpp"

namespace eyebridge::robios {
namespace {

std::string name_of(std::size_t index) { return fmt::format("robot {}", index + 1); }

}  // namespace

std::unique_ptr<Joining> make_joining(const hal::Config& config) {
  return std::make_unique<JoinedRobots>(config);
}

JoinedRobots::JoinedRobots(const hal::Config& config)
    : config_(config),
      is_virtual_(config.boolean("fast")),
      log_(lowest_severity(config)),
      watchdog_([this] { return turns_taken_.load(); },
                [this](double seconds) { tell_of_hang(seconds); },
                [this] {
                  if (ProgramProcess* const process = awaited_) process->kill_hanging();
                },
                config.number("hang_limit")),
      waiting_([this] { return turns_taken_.load(); },
               [this](double seconds) { tell_of_hang(seconds); }, [] {},
               config.number("hang_limit")) {}

void JoinedRobots::open(std::shared_ptr<hal::SharedWorld> world) {
  world_ = std::move(world);
  control_.emplace(
      [this](const Words& words) -> Result<std::size_t> {
        if (words.empty() || words.front() != kRemove) return add(words);
        try {
          const std::size_t index = read_leaver(words);
          return remove(index).map([index] { return index; });
        } catch (const ConfigError& error) {
          return fail(Errc::OutOfRange, error.what());
        }
      },
      log_);
}

Result<std::size_t> JoinedRobots::add(const Words& words) {
  const InCall in_call;  // the threads that begin here are ours
  try {
    hal::check_can_join(config_);
    if (world_ == nullptr) return fail(Errc::Unsupported, "no robot can be added to this run");
    return change([this, newcomer = read_newcomer(words, *world_)] { return enter(newcomer); });
  } catch (const std::exception& error) {
    return fail(Errc::OutOfRange, error.what());
  }
}

Result<void> JoinedRobots::remove(std::size_t index) {
  const InCall in_call;
  if (world_ == nullptr) return fail(Errc::Unsupported, "no robot can be removed from this run");
  return change([this, index] { return leave(index); }).map([](std::size_t) {});
}

Result<std::size_t> JoinedRobots::change(Arrivals::Act act) {
  {
    const std::lock_guard lock(mutex_);
    if (is_closed_) return Arrivals::too_late();
    ++count_;  // the run does not end meanwhile
  }
  auto done = [&] {
    if (is_virtual_) return arrivals_.ask(std::move(act));
    const std::lock_guard one(changing_);
    return act();
  }();
  const std::lock_guard lock(mutex_);
  --count_;
  changed_.notify_all();
  return done;
}

Result<std::size_t> JoinedRobots::enter(const hal::Newcomer& newcomer) {
  return world_->enter(newcomer).and_then([&](std::size_t index) -> Result<std::size_t> {
    if (newcomer.program.empty()) return index;
    try {
      const std::filesystem::path scenario =
          config_.is_set("world") ? config_.path("world") : std::filesystem::path("the empty room");
      start(index,
            programs_of({{newcomer.model.name, newcomer.program, newcomer.arguments}}, {}, scenario)
                .front());
      return index;
    } catch (const std::exception& error) {  // it stands there without a program
      return fail(Errc::Unsupported, fmt::format("{}: {}", name_of(index), error.what()));
    }
  });
}

void JoinedRobots::start(std::size_t index, RobotProgram program) {
  Joined* robot = nullptr;
  {
    const std::lock_guard lock(mutex_);
    if (is_interrupted_) throw ConfigError({"robot"}, "the run is ending");
    robot = robots_.emplace_back(std::make_unique<Joined>(index, world_->now())).get();
    ++count_;
  }
  const auto out = config_.is_set("out") ? config_.path("out") / fmt::format("robot-{}", index + 1)
                                         : std::filesystem::path();
  try {
    robot->process = std::make_unique<ProgramProcess>(std::move(program), config_,
                                                      hal::WorldSlot{world_, index}, out);
    // Its process lives no longer than the thread that starts it.
    deaf_thread([this, robot] { run(*robot); }).detach();
  } catch (const std::exception&) {
    finish(*robot, 0);
    throw;
  }
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [robot] { return robot->has_started || robot->has_ended; });
  if (!robot->has_started) throw ConfigError({"robot"}, "its program cannot be started");
}

void JoinedRobots::run(Joined& robot) {
  pthread_setname_np(pthread_self(), "eb:robot");
  LogSink& log = robot.process->log();
  ProgramProcess::End end;
  try {
    robot.process->start();
    bool goes = true;
    {
      std::unique_lock lock(mutex_);
      robot.has_started = true;
      changed_.notify_all();
      if (is_virtual_) changed_.wait(lock, [&] { return robot.has_turn || robot.is_leaving; });
      goes = !robot.is_leaving;
    }
    if (goes) {
      end = robot.process->run({}, is_virtual_ ? &robot.limit : nullptr,
                               is_virtual_ ? &awaited_ : nullptr);
    }
  } catch (const ConfigError& error) {
    end = {kCannotRun, error.what()};
  }
  const bool was_asked_to_end = [&] {
    const std::lock_guard lock(mutex_);
    return robot.is_leaving;
  }();
  if (!end.why.empty()) {
    log.write(Severity::Error, end.why);
  } else if (end.code != 0 && !was_asked_to_end) {
    log.write(Severity::Warning, fmt::format("the program ended with exit code {}", end.code));
  }
  finish(robot, end.code);
}

void JoinedRobots::finish(Joined& robot, int code) {
  const std::lock_guard lock(mutex_);
  robot.has_ended = true;
  robot.has_turn = false;
  if (!robot.is_leaving) robot.exit_code = code;
  --count_;
  changed_.notify_all();
}

Result<std::size_t> JoinedRobots::leave(std::size_t index) {
  if (const auto possible = world_->can_leave(index); !possible) {
    return tl::unexpected(possible.error());
  }
  if (index == 0 && !first_has_ended_) {
    return fail(Errc::Unsupported,
                "robot 1 cannot be removed: the world of this run is in its program's process. End "
                "that program, or the run (Ctrl-C); in a run with --robots 2 or more any robot can "
                "be removed");
  }
  Joined* robot = nullptr;
  {
    const std::lock_guard lock(mutex_);
    robot = find(index);
  }
  if (robot != nullptr) end_programs({robot});
  log_.write(Severity::Info, fmt::format("{} is removed", name_of(index)));
  return world_->leave(index).map([index] { return index; });
}

const Time& JoinedRobots::limit_of(std::size_t robot) const {
  const std::lock_guard lock(mutex_);
  return find(robot)->limit;
}

void JoinedRobots::wait(std::size_t robot, Time time) {
  std::unique_lock lock(mutex_);
  Joined& me = *find(robot);
  if (me.is_leaving) return;
  me.wanted = time;
  me.has_turn = false;
  ++turns_taken_;
  changed_.notify_all();
  changed_.wait(lock, [&] { return me.is_leaving || (me.has_turn && time < me.limit); });
}

void JoinedRobots::before_step(Time end) {
  std::unique_lock lock(mutex_);
  for (const auto& each : robots_) {
    Joined& robot = *each;
    if (robot.has_ended || robot.is_leaving || robot.wanted >= end) continue;
    robot.limit = end;
    robot.has_turn = true;
    changed_.notify_all();
    changed_.wait(lock, [&] { return !robot.has_turn || robot.is_leaving; });
  }
  ++turns_taken_;
}

int JoinedRobots::await_end() {
  const InCall in_call;
  first_has_ended_ = true;
  std::unique_lock lock(mutex_);
  if (is_virtual_) {
    while (is_busy()) {
      lock.unlock();
      world_->step();
      lock.lock();
    }
  } else if (config_.is_set("time_limit")) {
    // Programs end by themselves at the limit; one that makes no calls does not.
    const Time limit = from_seconds(config_.number("time_limit")) + std::chrono::seconds(1);
    while (!changed_.wait_for(lock, std::chrono::milliseconds(100), [&] { return !is_busy(); })) {
      lock.unlock();
      if (world_->now() >= limit) end_programs(all());
      lock.lock();
    }
  } else {
    changed_.wait(lock, [&] { return !is_busy(); });
  }
  is_closed_ = true;
  ControlServer::close();
  changed_.wait(lock, [&] { return !is_interrupted_; });  // else a signal ends the process
  if (!robots_.empty()) world_->end();
  const auto failed =
      std::ranges::find_if(robots_, [](const auto& robot) { return robot->exit_code != 0; });
  return failed == robots_.end() ? 0 : (*failed)->exit_code;
}

void JoinedRobots::end() noexcept {
  ControlServer::close();
  {
    const std::lock_guard lock(mutex_);
    is_interrupted_ = true;
  }
  const std::vector<Joined*> robots = all();
  end_programs(robots);
  if (!robots.empty()) world_->end();
}

void JoinedRobots::end_programs(const std::vector<Joined*>& robots) noexcept {
  {
    const std::lock_guard lock(mutex_);
    for (Joined* const robot : robots) robot->is_leaving = true;
    changed_.notify_all();
  }
  for (Joined* const robot : robots) {
    if (robot->process != nullptr) robot->process->ask_to_end();
  }
  for (Joined* const robot : robots) {
    if (robot->process != nullptr) robot->process->make_end();
  }
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return std::ranges::all_of(robots, &Joined::has_ended); });
}

std::vector<JoinedRobots::Joined*> JoinedRobots::all() const {
  const std::lock_guard lock(mutex_);
  std::vector<Joined*> out;
  for (const auto& robot : robots_) out.push_back(robot.get());
  return out;
}

JoinedRobots::Joined* JoinedRobots::find(std::size_t index) const {
  for (const auto& robot : robots_) {
    if (robot->index == index) return robot.get();
  }
  return nullptr;
}

void JoinedRobots::look() {
  ProgramProcess* const process = awaited_;
  if (process == nullptr) return;
  constexpr double kPeriod_s = 0.1;
  const bool sleeps = look_at_process(process->pid()).kind == ThreadState::Kind::Sleeps;
  hold_up_.look(process->processor_time(), sleeps, kPeriod_s);
  // A program that waits, perhaps for a person, gets a warning and is not ended.
  if (hold_up_.is_waiting()) waited_s_ += kPeriod_s;
  watchdog_.look(hold_up_.processor_s());
  waiting_.look(waited_s_);
}

void JoinedRobots::tell_of_hang(double seconds) const {
  ProgramProcess* const process = awaited_;
  if (process == nullptr) return;
  process->log().write(Severity::Warning,
                       fmt::format("the program has {} for {:g} s without a call with which its "
                                   "time passes; all robots wait for it",
                                   hold_up_.is_waiting() ? "waited" : "computed", seconds));
}

}  // namespace eyebridge::robios
