#pragma once

#include <array>
#include <csignal>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "eyebridge/base/unique_fd.hpp"

extern char** environ;

namespace eyebridge::firmware {

inline constexpr int kPatience_ms = 60'000;
inline const std::string kCommand = EYEBRIDGE_BIN "/eyebridge";

/// `eyebridge firmware …`, running; killed at the end unless it was waited for.
class RunningFirmware {
 public:
  RunningFirmware(std::vector<std::string> arguments, const std::string& folder) {
    int pipe_ends[2];
    if (::pipe2(pipe_ends, O_CLOEXEC) != 0) return;
    out_.reset(pipe_ends[0]);
    const UniqueFd other(pipe_ends[1]);
    arguments.insert(arguments.begin(), {kCommand, "firmware"});
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, other.get(), 1);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    posix_spawn(&pid_, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
  }
  ~RunningFirmware() {
    if (pid_ > 0) finish(SIGKILL);
  }
  RunningFirmware(const RunningFirmware&) = delete;
  RunningFirmware& operator=(const RunningFirmware&) = delete;

  /// Standard output up to and with `text`.
  std::string wait_for(const std::string& text) {
    pollfd ready{out_.get(), POLLIN, 0};
    std::array<char, 256> buffer{};
    while (said_.find(text) == std::string::npos && ::poll(&ready, 1, kPatience_ms) > 0) {
      const ssize_t got = ::read(out_.get(), buffer.data(), buffer.size());
      if (got <= 0) break;
      said_.append(buffer.data(), static_cast<std::size_t>(got));
    }
    return said_;
  }
  [[nodiscard]] pid_t pid() const { return pid_; }
  /// Sends `signal` and returns the exit code, or 128 + the signal that ended it.
  int finish(int signal) {
    ::kill(pid_, signal);
    return finish();
  }
  /// Waits for its end.
  int finish() {
    int status = 0;
    ::waitpid(std::exchange(pid_, -1), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  UniqueFd out_;
  pid_t pid_ = -1;
  std::string said_;
};

}  // namespace eyebridge::firmware
