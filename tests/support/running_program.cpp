#include "running_program.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace eyebridge::testing {
namespace {

constexpr int kPatience_ms = 120'000;

/// This process's environment and `more`, as "NAME=VALUE"; and what the leak checker must not blame
/// programs for.
std::vector<std::string> environment_with(std::map<std::string, std::string> more) {
  more.try_emplace("LSAN_OPTIONS",
                   "print_suppressions=0:suppressions=" EYEBRIDGE_LSAN_SUPPRESSIONS);
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (!more.contains(text.substr(0, text.find('=')))) all.push_back(text);
  }
  for (const auto& [name, value] : more) all.push_back(name + "=" + value);
  return all;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

}  // namespace

RunningProgram::RunningProgram(const ProgramStart& start) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("pipe2");
  out_.reset(ends[0]);
  const UniqueFd other(ends[1]);
  std::vector<std::string> words = start.command;
  std::vector<std::string> variables = environment_with(start.environment);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, other.get(), 1);
  posix_spawn_file_actions_adddup2(&actions, other.get(), 2);
  if (!start.directory.empty()) {
    posix_spawn_file_actions_addchdir_np(&actions, start.directory.c_str());
  }
  const int failed = posix_spawnp(&pid_, words.at(0).c_str(), &actions, nullptr,
                                  pointers(words).data(), pointers(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw std::runtime_error("cannot start " + words.at(0));
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
