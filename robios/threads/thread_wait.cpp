#include "thread_wait.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge::robios {
namespace {

struct Call {
  long number;
  const char* name;
  bool has_descriptor;  ///< Its first argument is one.
};

constexpr std::array kCalls = {
    Call{SYS_read, "read()", true},
    Call{SYS_readv, "readv()", true},
    Call{SYS_write, "write()", true},
    Call{SYS_writev, "writev()", true},
    Call{SYS_recvfrom, "recv()", true},
    Call{SYS_recvmsg, "recvmsg()", true},
    Call{SYS_sendto, "send()", true},
    Call{SYS_accept, "accept()", true},
    Call{SYS_accept4, "accept()", true},
    Call{SYS_connect, "connect()", true},
    Call{SYS_openat, "open()", false},
    Call{SYS_flock, "flock()", true},
    Call{SYS_fcntl, "fcntl()", true},
    Call{SYS_ppoll, "poll()", false},
    Call{SYS_pselect6, "select()", false},
    Call{SYS_epoll_pwait, "epoll_wait()", false},
    Call{SYS_wait4, "wait()", false},
    Call{SYS_waitid, "wait()", false},
    Call{SYS_nanosleep, "sleep()", false},
    Call{SYS_clock_nanosleep, "sleep()", false},
    Call{SYS_rt_sigsuspend, "sigsuspend()", false},
    Call{SYS_rt_sigtimedwait, "sigwait()", false},
    Call{SYS_futex, "a lock", false},
#if defined(__x86_64__)  // the others have one call for these and what is above
    Call{SYS_pause, "pause()", false},
    Call{SYS_poll, "poll()", false},
    Call{SYS_select, "select()", false},
    Call{SYS_epoll_wait, "epoll_wait()", false},
    Call{SYS_open, "open()", false},
#endif
};

bool is_terminal_of(int pid, int descriptor) {
  std::array<char, 64> path{};
  std::snprintf(path.data(), path.size(), "/proc/%d/fd/%d", pid, descriptor);
  std::array<char, 256> target{};
  const ssize_t length = readlink(path.data(), target.data(), target.size());
  const std::string_view name(target.data(),
                              static_cast<std::size_t>(std::max(length, ssize_t{0})));
  return name.starts_with("/dev/pts/") || name.starts_with("/dev/tty") || name == "/dev/console";
}

}  // namespace

ThreadWait read_thread_wait(const char* text, const std::function<bool(int)>& is_terminal) {
  char* end = nullptr;
  const long number = std::strtol(text, &end, 10);
  const auto* const call = std::ranges::find(kCalls, number, &Call::number);
  if (end == text || call == kCalls.end()) return {"a call of the system"};
  const long descriptor = std::strtol(end, nullptr, 16);
  return {call->name, call->has_descriptor && is_terminal(static_cast<int>(descriptor))};
}

ThreadWait look_at_wait(int pid, int tid) {
  std::array<char, 64> path{};
  std::snprintf(path.data(), path.size(), "/proc/%d/task/%d/syscall", pid, tid);
  const UniqueFd file(::open(path.data(), O_RDONLY | O_CLOEXEC));
  std::array<char, 256> text{};
  const ssize_t length = file.valid() ? ::read(file.get(), text.data(), text.size() - 1) : 0;
  return read_thread_wait(length > 0 ? text.data() : "",
                          [pid](int descriptor) { return is_terminal_of(pid, descriptor); });
}

}  // namespace eyebridge::robios
