#include "run_program.hpp"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include "start_program.hpp"

namespace eyebridge::testing {
namespace {

constexpr auto kPatience = std::chrono::minutes(5);  // compilers on an emulated processor

/// Reads both pipes until both are closed; false when `deadline` passes first.
bool collect(const std::array<int, 2>& pipes, ProgramRun& run,
             std::chrono::steady_clock::time_point deadline) {
  std::array<pollfd, 2> waiting{pollfd{pipes[0], POLLIN, 0}, pollfd{pipes[1], POLLIN, 0}};
  int open = 2;
  while (open > 0) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
        deadline - std::chrono::steady_clock::now());
    if (left.count() <= 0) return false;
    poll(waiting.data(), waiting.size(), static_cast<int>(left.count()));
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      if (waiting[i].fd < 0 || waiting[i].revents == 0) continue;
      std::array<char, 65536> chunk{};
      const ssize_t n = read(waiting[i].fd, chunk.data(), chunk.size());
      if (n > 0) {
        (i == 0 ? run.out : run.err).append(chunk.data(), static_cast<std::size_t>(n));
      } else {
        waiting[i].fd = -1;
        --open;
      }
    }
  }
  return true;
}

}  // namespace

ProgramRun run_program(const ProgramStart& start) {
  std::array<int, 2> out{};
  std::array<int, 2> err{};
  if (pipe2(out.data(), O_CLOEXEC) != 0 || pipe2(err.data(), O_CLOEXEC) != 0) {
    throw std::runtime_error("pipe");
  }
  const pid_t child = start_program(start, out[1], err[1]);
  close(out[1]);
  close(err[1]);
  ProgramRun run;
  if (child < 0) {
    close(out[0]);
    close(err[0]);
    run.exit_code = 127;
    run.err = "cannot start " + start.command.at(0);
    return run;
  }
  if (!collect({out[0], err[0]}, run, std::chrono::steady_clock::now() + kPatience)) {
    kill(child, SIGKILL);
    run.err += "\n(killed: still running after five minutes)\n";
  }
  close(out[0]);
  close(err[0]);
  int status = 0;
  waitpid(child, &status, 0);
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return run;
}

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "eyebridge-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp " + name);
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string ScratchFolder::write(const std::string& name, const std::string& text) const {
  std::string path = path_ + "/" + name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::map<std::string, std::string> trusted(const std::string& file, const ScratchFolder& folder) {
  std::map<std::string, std::string> own = {{"XDG_DATA_HOME", folder.path() + "/data"}};
  const ProgramRun r = run_program({{EYEBRIDGE_BIN "/eyebridge", "trust", file}, own, ""});
  if (r.exit_code != 0) throw std::runtime_error("eyebridge trust " + file + ": " + r.err);
  return own;
}

std::string file_text(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace eyebridge::testing
