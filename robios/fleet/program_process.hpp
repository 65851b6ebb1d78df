#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "child_process.hpp"
#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/hal/backend.hpp"
#include "eyebridge/hal/config.hpp"
#include "eyebridge/hal/shared_world.hpp"
#include "log/stderr_log.hpp"
#include "robot_program.hpp"

namespace eyebridge::robios {

class ProgramProcess;

/// The process that all robots wait for, in virtual time; null when there is none.
using AwaitedProcess = std::atomic<ProgramProcess*>;

/// A robot's program in a process of its own, for what this one cannot load: Python programs,
/// scripts, programs with thread_local variables. There it is a robot that is alone, whose backend
/// is `remote:`; its robot in the world is here.
class ProgramProcess {
 public:
  /// How it ended: its exit code, or 128 + signal; why, in words, when it did not end by itself.
  struct End {
    int code = 0;
    std::string why;
  };

  /// Opens the robot, whose results go to `out`. Throws ConfigError.
  ProgramProcess(RobotProgram program, const hal::Config& config, const hal::WorldSlot& slot,
                 std::filesystem::path out);
  ~ProgramProcess();

  /// Starts the process; its interpreter starts while others do. Twice does nothing, nor once it
  /// has been asked to end. Throws ConfigError when the system refuses.
  void start();
  /// Lets it drive its robot until its end; `arrive` is called when it makes its first call.
  /// `limit` as RobotServer takes it. `awaited`, when not null, is this while the process is waited
  /// for.
  End run(const std::function<void()>& arrive, const Time* limit, AwaitedProcess* awaited);

  /// Asks the process to end, as a person would. Any thread.
  void ask_to_end() noexcept;
  /// Sees to it that it does: within two seconds, then it is killed; its robot stops. Any thread.
  void make_end() noexcept;
  /// Kills it: it has computed for too long. Any thread.
  void kill_hanging() noexcept;
  /// Of the processor, seconds so far. Any thread.
  [[nodiscard]] double processor_time() const;
  /// Its number.
  [[nodiscard]] int pid() const { return process_->pid(); }

  [[nodiscard]] Clock& clock() { return robot_->clock(); }
  [[nodiscard]] LogSink& log() { return log_; }

 private:
  /// From now on it is not started any more. False when it had not been.
  bool begin_to_end() noexcept;
  /// Returns why it had to be killed; "" when it has ended by itself.
  std::string serve(const std::function<void()>& arrive, const Time* limit,
                    AwaitedProcess* awaited);

  const RobotProgram program_;
  std::optional<hal::Config>
      config_;  ///< Until it is started: robots may come and go all day long.
  const std::size_t index_;
  const std::filesystem::path out_;
  StderrLog log_;
  std::unique_ptr<hal::Backend> robot_;
  UniqueFd line_;
  std::unique_ptr<ChildProcess> process_;
  std::mutex starting_;                   ///< Held while it is started, and while its end begins.
  std::atomic<bool> is_started_ = false;  ///< For other threads: process_ is there.
  std::atomic<bool> is_ending_ = false;
  std::atomic<bool> hangs_ = false;
};

}  // namespace eyebridge::robios
