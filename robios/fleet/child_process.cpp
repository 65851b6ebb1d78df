#include "child_process.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "eyebridge/base/exec_words.hpp"

namespace eyebridge::robios {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// In the child of fork(), where other threads may have left anything locked: system calls only.
/// What the system refuses is told by `report`.
[[noreturn]] void become(char* const* words, char* const* environment, int descriptor, int report,
                         pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  // Ctrl-C at the terminal comes to all: who started us ends us in order.
  ::signal(SIGINT, SIG_IGN);
  fcntl(descriptor, F_SETFD, 0);
  execute(words, environment);
  const int error = errno;
  [[maybe_unused]] const auto written = write(report, &error, sizeof error);
  _exit(127);
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& words,
                           const std::vector<std::string>& environment, int descriptor) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) refuse("a pipe");
  const UniqueFd reading(ends[0]);
  UniqueFd writing(ends[1]);
  const std::vector<char*> argv = pointers_to(words);
  const std::vector<char*> variables = pointers_to(environment);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ < 0) refuse("a process for a robot's program");
  if (pid_ == 0) become(argv.data(), variables.data(), descriptor, writing.get(), parent);
  life_.reset(static_cast<int>(syscall(SYS_pidfd_open, pid_, 0)));
  writing.reset();
  int error = life_.valid() ? 0 : errno;
  ssize_t count = 0;
  do {
    count = read(reading.get(), &error, sizeof error);
  } while (count < 0 && errno == EINTR);
  if (error == 0) return;
  kill(pid_, SIGKILL);
  wait();
  errno = error;
  refuse(words.front() + " cannot be started");
}

ChildProcess::~ChildProcess() {
  if (is_over_) return;
  signal(SIGKILL);
  wait();
}

bool ChildProcess::ends_within(double seconds) const {
  pollfd life{life_.get(), POLLIN, 0};
  int ready = 0;
  do {
    ready = poll(&life, 1, static_cast<int>(seconds * 1e3));
  } while (ready < 0 && errno == EINTR);
  return ready > 0;
}

void ChildProcess::signal(int signal) const {
  syscall(SYS_pidfd_send_signal, life_.get(), signal, nullptr, 0);
}

int ChildProcess::wait() {
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  is_over_ = true;
  return status;
}

void ChildProcess::forget() const {
  siginfo_t how{};
  waitid(P_PID, static_cast<id_t>(pid_), &how, WEXITED | WNOHANG);
}

double ChildProcess::processor_time() const {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(pid_, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0.0;
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

}  // namespace eyebridge::robios
