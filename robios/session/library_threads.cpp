#include "library_threads.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include <signal.h>
#include <unistd.h>

namespace eyebridge::robios {
namespace {

struct Task {
  std::string name;
  char state = '?';
};

/// Of proc(5), /proc/PID/task/TID/stat: the name stands in brackets, the state follows.
Task read_task(const std::filesystem::path& folder) {
  std::ifstream file(folder / "stat");
  std::string line;
  std::getline(file, line);
  const std::size_t open = line.find('(');
  const std::size_t close = line.rfind(')');
  if (open == std::string::npos || close == std::string::npos || close + 2 >= line.size())
    return {};
  return {line.substr(open + 1, close - open - 1), line[close + 2]};
}

/// Of proc(5), /proc/PID/task/TID/status: the mask of blocked signals, in hexadecimal.
bool blocks_signals(const std::filesystem::path& folder) {
  std::ifstream file(folder / "status");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("SigBlk:")) continue;
    const std::uint64_t blocked = std::stoull(line.substr(7), nullptr, 16);
    // Not quite everything: Mesa lets SIGSEGV through.
    const std::uint64_t usual = 1U << (SIGFPE - 1) | 1U << (SIGALRM - 1) | 1U << (SIGTERM - 1);
    return (blocked & usual) == usual;
  }
  return false;
}

// Not a path: the thread that looks here outlives what exit() destroys.
constexpr const char* kTasks = "/proc/self/task";

/// A main thread that left by pthread_exit() stays as a zombie until the process ends.
Task main_task() { return read_task(std::filesystem::path(kTasks) / std::to_string(getpid())); }

}  // namespace

bool main_thread_has_left() { return main_task().state == 'Z'; }

bool only_library_threads_left() {
  const Task main = main_task();
  if (main.state != 'Z') return false;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(kTasks, error)) {
    const Task task = read_task(entry.path());
    if (task.state == 'Z' || task.name.empty() || task.name.starts_with(kLibraryThread)) continue;
    if (task.name == main.name || !blocks_signals(entry.path())) return false;
  }
  return !error;
}

}  // namespace eyebridge::robios
