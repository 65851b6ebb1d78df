#include "library_threads.hpp"

#include <filesystem>
#include <fstream>
#include <string>

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

}  // namespace

bool only_library_threads_left() {
  const std::filesystem::path tasks = "/proc/self/task";
  // A main thread that left by pthread_exit() stays as a zombie until the process ends.
  if (read_task(tasks / std::to_string(getpid())).state != 'Z') return false;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(tasks, error)) {
    const Task task = read_task(entry.path());
    if (task.state != 'Z' && !task.name.empty() && !task.name.starts_with(kLibraryThread)) {
      return false;
    }
  }
  return !error;
}

}  // namespace eyebridge::robios
