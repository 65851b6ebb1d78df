#include "running_program.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace eyebridge::testing {
namespace {

constexpr int kPatience_ms = 60'000;

[[noreturn]] void become(const ProgramStart& start, int out) {
  dup2(out, 1);
  if (!start.directory.empty() && chdir(start.directory.c_str()) != 0) _exit(127);
  for (const auto& [name, value] : start.environment) setenv(name.c_str(), value.c_str(), 1);
  std::vector<char*> argv;
  for (const std::string& word : start.command) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  execvp(argv[0], argv.data());
  _exit(127);
}

}  // namespace

RunningProgram::RunningProgram(const ProgramStart& start) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("pipe");
  out_.reset(ends[0]);
  const UniqueFd other(ends[1]);
  pid_ = fork();
  if (pid_ == 0) become(start, other.get());
}

RunningProgram::~RunningProgram() {
  if (pid_ > 0) finish(SIGKILL);
}

std::string RunningProgram::wait_for(const std::string& text) {
  pollfd ready{out_.get(), POLLIN, 0};
  std::array<char, 256> buffer{};
  while (said_.find(text) == std::string::npos && poll(&ready, 1, kPatience_ms) > 0) {
    const ssize_t got = read(out_.get(), buffer.data(), buffer.size());
    if (got <= 0) break;
    said_.append(buffer.data(), static_cast<std::size_t>(got));
  }
  return said_;
}

int RunningProgram::finish(int signal) {
  int status = 0;
  kill(pid_, signal);
  waitpid(std::exchange(pid_, -1), &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace eyebridge::testing
