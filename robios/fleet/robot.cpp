#include "robot.hpp"

#include <cstdio>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "eyebridge/base/robot_program.hpp"
#include "flow.hpp"
#include "launcher_calls.h"
#include "robot_programs.hpp"

namespace eyebridge::robios {
Robot::Robot(std::size_t index, RobotProgram program)
    : index_(index), program_(std::move(program)), process_id_(getpid()) {}

void Robot::begin(const hal::Config& config, const hal::WorldSlot& slot,
                  const std::filesystem::path& out) {
  const std::filesystem::path own_out =
      out.empty() ? out : out / fmt::format("robot-{}", index_ + 1);
  if (needs_process(program_.file, config)) {
    process_ = std::make_unique<ProgramProcess>(program_, config, slot, own_out);
    return;
  }
  session_ = Session::begin({config, slot, this, fmt::format("robot {}", index_ + 1), own_out});
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
  try {
    // Runs constructors: the robot's first code.
    image_ = session_->config().boolean("shared_globals") ? ProgramImage::load_shared(program_.file)
                                                          : ProgramImage::load(program_.file);
    uses_image_ = true;
  } catch (const ConfigError& error) {
    fail(error.what(), kCannotRun);
  }
  std::vector<std::string> words{program_.file.string()};
  words.insert(words.end(), program_.arguments.begin(), program_.arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  exit(image_->main()(static_cast<int>(words.size()), argv.data(), environ), EYEBRIDGE_EXIT);
  __builtin_unreachable();  // g++ forgets what a virtual function promises
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
  tell(end.code);
  drop(end.code);
  __builtin_unreachable();  // as in run()
}

void Robot::leave(int code) {
  if (flow.calls == 0) exit(code, EYEBRIDGE_EXIT);
  session_->end();
  {
    const OutOfCall program;
    finish_image(false, code);
  }
  drop(code);
  __builtin_unreachable();
}

void Robot::exit(int code, int how) {
  code &= 0xff;  // what a process would end with
  if (!has_ended() && how != EYEBRIDGE_AT_ONCE) finish_image(how == EYEBRIDGE_QUICK_EXIT, code);
  if (getpid() != process_id_) {  // a child of fork(): the robot is its parent's
    // Its output; not the robots' results, which are the parent's.
    if (how == EYEBRIDGE_EXIT) std::fflush(stdout);
    _exit(code);
  }
  tell(code);
  drop(code);
  __builtin_unreachable();
}

void Robot::tell(int code) {
  if (code == 0 || has_ended() || has_told_.exchange(true)) return;
  std::fflush(stdout);  // what it printed before comes before
  log().write(Severity::Warning, fmt::format("the program ended with exit code {}", code));
}

/// True when nobody else uses its image.
bool Robot::leave_image() { return uses_image_.exchange(false) && image_->leave(); }

void Robot::finish_image(bool is_quick, int code) {
  if (leave_image()) finishes_image_ = true;
  if (finishes_image_) image_->finish(is_quick, code);
}

void* Robot::state(std::size_t size) {
  std::call_once(has_state_, [&] { state_ = std::make_unique<std::byte[]>(size); });
  return state_.get();
}

bool Robot::runs(const void* address) const {
  // In a constructor the image is still to come.
  return process_ == nullptr && ProgramImage::around(address) != nullptr;
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

void Robot::fail(const std::string& how, int code) {
  std::fflush(stdout);  // what it printed before comes before
  log().write(Severity::Error, how);
  drop(code);
  __builtin_unreachable();
}

void Robot::break_off(int code) {
  if (!ended_.exchange(true)) exit_code_ = code;
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

Robot* Robot::current() {
  Session* const session = Session::here();
  return session == nullptr ? nullptr : static_cast<Robot*>(session->runner());
}

bool Robot::end(int code) {
  if (ended_.exchange(true)) return false;
  exit_code_ = code;
  leave_image();
  if (process_ == nullptr) session_->end();  // else it has ended there
  return true;
}

}  // namespace eyebridge::robios
