#include "sweep/cell_process.hpp"

#include <cerrno>
#include <csignal>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "eyebridge/base/exec_words.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/hal/config.hpp"

namespace eyebridge::apps {
namespace {

constexpr auto kGrace = std::chrono::seconds(2);  // between asking to end and ending
constexpr rlim_t kLargestFile = rlim_t{1} << 30U;
constexpr int kNotStarted = 127;

std::vector<std::string> command_line(const Cell& cell, const std::filesystem::path& folder,
                                      const RunSettings& settings) {
  std::map<std::string, std::string> flags = settings.base;
  for (const auto& [key, text] : cell.settings) flags[key] = text;
  flags["report"] = (folder / "report.txt").string();
  flags["panel"] = "none";
  std::vector<std::string> words = {settings.command.string(), "run"};
  for (const auto& [key, text] : flags) words.push_back(hal::Config::flag_name(key) + "=" + text);
  words.push_back(cell.program);
  words.insert(words.end(), cell.arguments.begin(), cell.arguments.end());
  return words;
}

bool redirect(const char* path, int flags, int to) {
  const int file = open(path, flags, 0666);
  return file >= 0 && dup2(file, to) >= 0;
}

/// In the child of fork(): becomes the run, or ends with kNotStarted. System calls only: any lock
/// of another thread stays locked in the child.
[[noreturn]] void become_run(char* const* words, char* const* environment, const char* folder,
                             pid_t parent) {
  setpgid(0, 0);
  // Whoever kills a sweep has ended its runs, too.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kNotStarted);
  const rlimit largest{kLargestFile, kLargestFile};
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_FSIZE, &largest);
  setrlimit(RLIMIT_CORE, &no_core);
  constexpr int kNew = O_WRONLY | O_CREAT | O_TRUNC;
  if (chdir(folder) == 0 && redirect("/dev/null", O_RDONLY, 0) && redirect("out.txt", kNew, 1) &&
      redirect("err.txt", kNew, 2)) {
    execve(words[0], words, environment);
  }
  _exit(kNotStarted);
}

double time_limit_of(const Cell& cell, const RunSettings& settings) {
  for (const auto* flags : {&cell.settings, &settings.base}) {
    const auto found = flags->find("time_limit");
    if (found != flags->end()) return parse_duration(found->second, {"time_limit"});
  }
  return 0.0;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

}  // namespace

CellProcess::CellProcess(const Cell& cell, std::size_t number, const RunSettings& settings)
    : folder_(settings.folder / std::to_string(number)),
      wall_limit_(settings.wall_limit),
      time_limit_(time_limit_of(cell, settings)),
      keep_files_(settings.keep_files),
      began_(std::chrono::steady_clock::now()),
      due_(began_ + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                        std::chrono::duration<double>(settings.wall_limit))) {
  std::filesystem::remove_all(folder_);  // of an earlier sweep that was killed
  std::filesystem::create_directories(folder_);
  const std::vector<std::string> words = command_line(cell, folder_, settings);
  const std::vector<std::string> variables = environment_with(cell.environment);
  const std::vector<char*> argv = pointers_to(words);
  const std::vector<char*> environment = pointers_to(variables);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) become_run(argv.data(), environment.data(), folder_.c_str(), parent);
  if (pid_ < 0) throw std::system_error(errno, std::generic_category(), "starting a run");
  setpgid(pid_, pid_);  // both do it, whoever is first
  // Not pidfd_open(): the header of glibc 2.36 does not say that it is a function of C.
  pidfd_.reset(static_cast<int>(syscall(SYS_pidfd_open, pid_, 0)));
  if (!pidfd_.valid()) throw std::system_error(errno, std::generic_category(), "watching a run");
}

CellProcess::~CellProcess() {
  if (reaped_ || pid_ <= 0) return;
  kill(-pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

void CellProcess::check_time(Moment now) {
  if (now < due_) return;
  kill(-pid_, asked_ ? SIGKILL : SIGTERM);
  asked_ = true;
  due_ = now + kGrace;
}

Outcome CellProcess::reap() {
  kill(-pid_, SIGKILL);  // what it started and left behind; itself it cannot meet any more
  int status = 0;
  rusage used{};
  if (wait4(pid_, &status, 0, &used) < 0) {
    throw std::system_error(errno, std::generic_category(), "waiting for a run");
  }
  reaped_ = true;
  Outcome outcome;
  outcome.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  outcome.cpu = seconds(used.ru_utime) + seconds(used.ru_stime);
  read_files(outcome, folder_ / "report.txt", folder_ / "out.txt");
  judge(outcome, status);
  if (outcome.well() && !keep_files_) std::filesystem::remove_all(folder_);
  return outcome;
}

void CellProcess::judge(Outcome& outcome, int status) const {
  const std::string said = last_line(folder_ / "err.txt");
  const std::string because = said.empty() ? "" : ": " + said;
  if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
  if (asked_) {
    outcome.how = "hung";
    outcome.reason = fmt::format("no end after {:g} s of real time{}", wall_limit_, because);
  } else if (outcome.signal) {
    outcome.how = "crashed";
    outcome.reason = signal_name(*outcome.signal) + because;
  } else if (outcome.exit_code == kNotStarted && said.empty()) {
    outcome.how = "not started";
    outcome.reason = "the system refused to start it";
  } else if (outcome.exit_code != 0) {
    outcome.how = "failed";
    outcome.reason = fmt::format("exit code {}{}", *outcome.exit_code, because);
  } else if (time_limit_ > 0 && outcome.time && *outcome.time >= time_limit_ - 1e-9) {
    outcome.how = "time limit";
  } else {
    outcome.how = "ended";
  }
}

}  // namespace eyebridge::apps
