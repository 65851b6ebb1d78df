#include "running_program.hpp"

#include <array>
#include <csignal>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include "start_program.hpp"

namespace eyebridge::testing {
namespace {

constexpr int kPatience_ms = 120'000;

}  // namespace

RunningProgram::RunningProgram(const ProgramStart& start) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("pipe2");
  out_.reset(ends[0]);
  const UniqueFd other(ends[1]);
  pid_ = start_program(start, other.get(), other.get());
  if (pid_ < 0) throw std::runtime_error("cannot start " + start.command.at(0));
}

RunningProgram::~RunningProgram() {
  if (pid_ > 0) finish(SIGKILL);
}

bool RunningProgram::read_more() {
  pollfd ready{out_.get(), POLLIN, 0};
  if (::poll(&ready, 1, kPatience_ms) <= 0) return false;
  std::array<char, 4096> buffer{};
  const ssize_t got = ::read(out_.get(), buffer.data(), buffer.size());
  if (got <= 0) return false;
  said_.append(buffer.data(), static_cast<std::size_t>(got));
  return true;
}

const std::string& RunningProgram::wait_for(const std::string& text) {
  while (said_.find(text) == std::string::npos && read_more()) {
  }
  return said_;
}

void RunningProgram::signal(int signal) const { ::kill(pid_, signal); }

int RunningProgram::wait() {
  pollfd ready{out_.get(), POLLIN, 0};
  while (read_more()) {
  }
  if (::poll(&ready, 1, 0) == 0) {  // not closed: it is still running
    signal(SIGKILL);
    said_ += "\n(killed: said nothing for two minutes and did not end)\n";
  }
  int status = 0;
  ::waitpid(std::exchange(pid_, -1), &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int RunningProgram::finish(int sent) {
  signal(sent);
  return wait();
}

}  // namespace eyebridge::testing
