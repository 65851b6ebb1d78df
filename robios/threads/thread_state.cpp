#include "thread_state.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge::robios {

ThreadState read_thread_state(const char* text) {
  constexpr ThreadState kGone{ThreadState::Kind::Gone};
  // The name, in brackets, may have brackets in it.
  const char* const end_of_name = std::strrchr(text, ')');
  if (end_of_name == nullptr) return kGone;
  char state = '?';
  unsigned long user = 0;
  unsigned long kernel = 0;
  // Fields 3, 14 and 15: state, utime, stime.
  // NOLINTNEXTLINE(cert-err34-c): the kernel's numbers fit
  const int read =
      std::sscanf(end_of_name + 1, " %c %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %lu %lu", &state,
                  &user, &kernel);
  if (read != 3 || state == 'Z' || state == 'X' || state == 'x') return kGone;
  static const auto ticks_per_second = static_cast<double>(sysconf(_SC_CLK_TCK));
  return {state == 'S' ? ThreadState::Kind::Sleeps : ThreadState::Kind::Computes,
          static_cast<double>(user + kernel) / ticks_per_second};
}

namespace {

ThreadState look_at(const char* path) {
  // Not kept open: a program may close all files.
  const UniqueFd file(::open(path, O_RDONLY | O_CLOEXEC));
  if (!file.valid()) {
    return {errno == ENOENT ? ThreadState::Kind::Gone : ThreadState::Kind::Sleeps};
  }
  std::array<char, 1024> text{};
  const ssize_t length = ::read(file.get(), text.data(), text.size() - 1);
  return read_thread_state(length > 0 ? text.data() : "");
}

}  // namespace

ThreadState look_at_thread(int tid) {
  std::array<char, 64> path{};
  std::snprintf(path.data(), path.size(), "/proc/self/task/%d/stat", tid);
  return look_at(path.data());
}

ThreadState look_at_process(int pid) {
  std::array<char, 64> path{};
  std::snprintf(path.data(), path.size(), "/proc/%d/task/%d/stat", pid, pid);
  return look_at(path.data());
}

}  // namespace eyebridge::robios
