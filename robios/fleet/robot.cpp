#include "robot.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <utility>

#include <fmt/format.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "flow.hpp"
#include "robot_programs.hpp"

namespace eyebridge::robios {
namespace {

constexpr int kCannotRun = 126;  // as shells say it

}  // namespace

void Robot::begin(const hal::Config& config, const hal::Seat& seat,
                  const std::filesystem::path& out) {
  world_ = seat.world;
  const std::filesystem::path own_out =
      out.empty() ? out : out / fmt::format("robot-{}", index_ + 1);
  if (needs_process(program_.file)) {
    process_ = std::make_unique<ProgramProcess>(program_, config, seat, own_out);
    return;
  }
  session_ = Session::begin({config, seat, this, fmt::format("robot {}", index_ + 1), own_out});
}

void Robot::start_process() {
  if (process_ == nullptr || has_ended()) return;
  try {
    process_->start();
  } catch (const ConfigError&) {
    // run() says so.
  }
}

void Robot::run() {
  Session::set_here(session_);
  if (const std::string why = trouble_with(program_.file); !why.empty()) {
    fail(program_.file.string() + ": " + why, kCannotRun);
  }
  if (process_ != nullptr) run_process();
  flow.stack_mark = __builtin_frame_address(0);
  try {
    // Runs constructors: the robot's first code.
    image_ = session_->config().boolean("shared_globals") ? ProgramImage::load_shared(program_.file)
                                                          : ProgramImage::load(program_.file);
  } catch (const ConfigError& error) {
    fail(error.what(), kCannotRun);
  }
  std::vector<std::string> words{program_.file.string()};
  words.insert(words.end(), program_.arguments.begin(), program_.arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  quit(image_->main()(static_cast<int>(words.size()), argv.data(), environ));
}

void Robot::run_process() {
  ProgramProcess::End end;
  try {
    process_->start();
    end = process_->run([this] { arrive(); }, limit(), awaited());
  } catch (const ConfigError& error) {
    end = {kCannotRun, error.what()};
  }
  if (!end.why.empty()) fail(end.why, end.code);
  quit(end.code);
}

Clock& Robot::clock() const { return process_ != nullptr ? process_->clock() : session_->clock(); }

Time Robot::now() const { return clock().now(); }

LogSink& Robot::log() const { return process_ != nullptr ? process_->log() : session_->log(); }

void Robot::end_session() noexcept {
  if (process_ != nullptr) {
    process_->ask_to_end();
  } else {
    session_->end();
  }
}

void Robot::make_process_end() noexcept {
  if (process_ != nullptr) process_->make_end();
}

void* Robot::variable(const char* name) {
  return image_ != nullptr ? image_->variable(name) : nullptr;
}

void Robot::quit(int code) {
  if (code != 0) {
    std::fflush(stdout);  // what it printed before comes before
    log().write(Severity::Warning, "the program ended with exit code " + std::to_string(code));
  }
  leave(code);
  __builtin_unreachable();  // g++ forgets what a virtual function promises
}

void Robot::fail(const std::string& how, int code) {
  is_abandoned_ = flow.calls > 0;
  flow.calls = 0;
  std::fflush(stdout);  // what it printed before comes before
  log().write(Severity::Error, is_abandoned_ ? how + " (inside a RoBIOS call)" : how);
  leave(code);
  __builtin_unreachable();
}

void Robot::break_off(int code) {
  if (!ended_.exchange(true)) exit_code_ = code;
}

void Robot::end_stuck() {
  if (ended_) return;
  log().write(Severity::Error,
              "all threads of the program wait for each other, and nobody else can wake one of "
              "them; it ends");
  end(1);
}

void Robot::remove(int code, const std::string& why) {
  if (end(code)) {
    if (!why.empty()) log().write(Severity::Warning, why);
    if (process_ != nullptr) process_->ask_to_end();
    forget();
  }
  make_process_end();
}

const Screen* Robot::screen() const { return session_ != nullptr ? &session_->screen() : nullptr; }

bool Robot::may_be_stopped() const {
  if (flow.calls == 0) return true;
  // Others hold the world for microseconds; a tenth of a second is for ever.
  for (int i = 0; i < 100; ++i) {
    if (!world_->is_locked()) return true;
    const timespec pause{0, 1'000'000};
    syscall(SYS_nanosleep, &pause, nullptr);
  }
  return false;
}

Robot* Robot::current() {
  Session* const session = Session::here();
  return session == nullptr ? nullptr : static_cast<Robot*>(session->runner());
}

bool Robot::end(int code) {
  if (ended_.exchange(true)) return false;
  exit_code_ = code;
  if (process_ != nullptr) return true;  // it has ended there
  if (is_abandoned_) {
    session_->abandon();
  } else {
    session_->end();
  }
  return true;
}

}  // namespace eyebridge::robios
