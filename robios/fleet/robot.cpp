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
  session_ = Session::begin({config, seat, this, fmt::format("robot {}", index_ + 1),
                             out.empty() ? out : out / fmt::format("robot-{}", index_ + 1)});
}

void Robot::run() {
  Session::set_here(session_);
  flow.stack_mark = __builtin_frame_address(0);
  if (const std::string why = trouble_with(program_.file); !why.empty()) {
    fail(program_.file.string() + ": " + why, kCannotRun);
  }
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
  leave(image_->main()(static_cast<int>(words.size()), argv.data(), environ));
  __builtin_unreachable();  // g++ forgets what a virtual function promises
}

void* Robot::variable(const char* name) {
  return image_ != nullptr ? image_->variable(name) : nullptr;
}

void Robot::fail(const std::string& how, int code) {
  is_abandoned_ = flow.calls > 0;
  flow.calls = 0;
  std::fflush(stdout);  // what it printed before comes before
  session_->log().write(Severity::Error, is_abandoned_ ? how + " (inside a RoBIOS call)" : how);
  leave(code);
  __builtin_unreachable();
}

void Robot::end_stuck() {
  if (ended_) return;
  session_->log().write(Severity::Error,
                        "all threads of the program wait for each other, and nobody else can wake "
                        "one of them; it ends");
  end(1);
}

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
  if (is_abandoned_) {
    session_->abandon();
  } else {
    session_->end();
  }
  return true;
}

}  // namespace eyebridge::robios
