#include "program_process.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>

#include "eyebridge/base/exec_words.hpp"
#include "eyebridge/base/robot_program.hpp"
#include "eyebridge/hal/registry.hpp"
#include "eyebridge/hal/robot_server.hpp"
#include "session_parts.hpp"

namespace eyebridge::robios {
namespace {

namespace fs = std::filesystem;

constexpr double kEndPatience_s = 2.0;

/// The robot as it is: faults are put in front of it where its program is.
std::unique_ptr<hal::Backend> open_robot(const hal::Config& config, LogSink& log,
                                         const hal::WorldSlot& slot) {
  const hal::Config faultless = config.with("faults", {"", config.value("faults").where});
  return hal::open_backend({faultless, log, &slot});
}

/// The variables of a process that runs the program of robot `index`, whose line to its server is
/// `descriptor` there: this process's, with the settings `config` as they count here, except those
/// of one robot alone. Its results go to `out`; "" for none.
std::vector<std::string> environment_of(const hal::Config& config, std::size_t index,
                                        int descriptor, const fs::path& out) {
  hal::Config own = config;
  const auto put = [&own](std::string_view key, const std::string& text) {
    own = own.with(key, {text, {hal::Config::flag_name(key)}});
  };
  // The program may change its working folder before its first call.
  for (const hal::Setting& setting : hal::settings()) {
    if (setting.kind != hal::Setting::Kind::Path || !config.is_set(setting.key)) continue;
    const fs::path path = fs::absolute(config.path(setting.key));
    own = own.with(setting.key, {path.string(), config.value(setting.key).where});
  }
  put("hal", fmt::format("remote:{}?robot={}", descriptor, index + 1));
  put("robots", "1");
  put("out", out.empty() ? "" : fs::absolute(out).string());
  put("report", "");  // of the world
  put("panel", "none");
  std::map<std::string, std::string> variables = python_variables();
  // Sealed: a file beside the program must not change what all robots live by.
  variables[hal::kPlanVariable] = own.sealed_plan();
  variables["EYEBRIDGE_ROBOTS"] = "1";
  return environment_with(variables);
}

/// While it lives, all wait for `process`.
class Awaiting {
 public:
  Awaiting(AwaitedProcess* place, ProgramProcess* process) : place_(place) {
    if (place_ != nullptr) *place_ = process;
  }
  ~Awaiting() {
    if (place_ != nullptr) *place_ = nullptr;
  }
  Awaiting(const Awaiting&) = delete;
  Awaiting& operator=(const Awaiting&) = delete;

 private:
  AwaitedProcess* const place_;
};

}  // namespace

ProgramProcess::ProgramProcess(RobotProgram program, const hal::Config& config,
                               const hal::WorldSlot& slot, std::filesystem::path out)
    : program_(std::move(program)),
      config_(config),
      index_(slot.robot),
      out_(std::move(out)),
      log_(lowest_severity(config), fmt::format("robot {}", slot.robot + 1)),
      robot_(open_robot(config, log_, slot)) {}

ProgramProcess::~ProgramProcess() = default;

void ProgramProcess::start() {
  const std::lock_guard lock(starting_);
  if (is_started_ || is_ending_) return;
  std::array<int, 2> ends{};
  try {
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
      throw std::system_error(errno, std::generic_category(), "a line to a robot's program");
    }
    line_.reset(ends[0]);
    // To look every so often whether the process lives.
    const timeval patience{0, 200'000};
    setsockopt(ends[0], SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    const UniqueFd theirs(ends[1]);
    process_ = std::make_unique<ChildProcess>(words_to_start(program_.file, program_.arguments),
                                              environment_of(*config_, index_, theirs.get(), out_),
                                              theirs.get());
  } catch (const std::system_error& error) {
    throw ConfigError({program_.file.string()}, error.what());
  }
  config_.reset();
  is_started_ = true;
}

ProgramProcess::End ProgramProcess::run(const std::function<void()>& arrive, const Time* limit,
                                        AwaitedProcess* awaited) {
  if (!is_started_) return {128 + SIGTERM, ""};  // it was removed as soon as it came
  std::string why = serve(arrive, limit, awaited);
  // It has ended, or closed its line.
  if (!why.empty() || !process_->ends_within(kEndPatience_s)) process_->signal(SIGKILL);
  const int status = process_->wait();
  robot_->stop();
  if (!why.empty()) return {1, why};
  if (hangs_) {
    return {124, "the program has made no call for too long and is ended; the others go on"};
  }
  if (!WIFSIGNALED(status)) return {WEXITSTATUS(status), ""};
  const int signal = WTERMSIG(status);
  if (is_ending_) return {128 + signal, ""};
  return {128 + signal, fmt::format("the program was ended by a signal: {}; the others go on",
                                    strsignal(signal))};
}

std::string ProgramProcess::serve(const std::function<void()>& arrive, const Time* limit,
                                  AwaitedProcess* awaited) {
  std::optional<hal::RobotServer> server;
  try {
    server.emplace(*robot_, limit, line_.get(), arrive);
  } catch (const std::system_error& error) {
    return error.what();
  }
  const auto next = [&] {
    const Awaiting all_wait(awaited, this);
    return server->receive();
  };
  for (;;) {
    Result<void> done = next();
    if (done) done = server->answer();
    if (done) continue;
    const Error& error = done.error();
    if (error.code == Errc::Corrupt) return error.what + "; its program is ended, the others go on";
    // Its children may still have the line.
    if (error.code != Errc::Timeout || process_->ends_within(0.0)) return "";
  }
}

bool ProgramProcess::begin_to_end() noexcept {
  const std::lock_guard lock(starting_);
  is_ending_ = true;
  return is_started_;
}

void ProgramProcess::ask_to_end() noexcept {
  if (begin_to_end()) process_->signal(SIGTERM);
}

void ProgramProcess::make_end() noexcept {
  if (!begin_to_end()) return;
  const bool has_ended = process_->ends_within(kEndPatience_s / 4);
  // It may be waiting for a turn that never comes; or it is gone, and its children have the line.
  shutdown(line_.get(), SHUT_RDWR);
  if (!has_ended && !process_->ends_within(kEndPatience_s)) {
    process_->signal(SIGKILL);
    static_cast<void>(process_->ends_within(kEndPatience_s));
  }
  robot_->stop();
  process_->forget();
}

void ProgramProcess::kill_hanging() noexcept {
  hangs_ = true;
  process_->signal(SIGKILL);
}

double ProgramProcess::processor_time() const { return process_->processor_time(); }

}  // namespace eyebridge::robios
