#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "program_image.hpp"
#include "program_process.hpp"
#include "program_signals.hpp"
#include "robot_program.hpp"
#include "session.hpp"
#include "session_start.hpp"

namespace eyebridge::robios {

/// One of several robots: its program, its copy of it, its session; or the process that has these.
///
/// Who schedules robots derives from it: a fiber's robot or a thread's.
class Robot : public Runner {
 public:
  Robot(std::size_t index, RobotProgram program);
  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;

  /// Begins the session; before run(). Throws ConfigError.
  void begin(const hal::Config& config, const hal::WorldSlot& slot,
             const std::filesystem::path& out);
  /// True once begin() has been successful.
  [[nodiscard]] bool has_begun() const { return session_ != nullptr || process_ != nullptr; }
  /// Starts the program's process, if it needs one, before run() would. Twice does nothing.
  void start_process();
  /// Loads the program and runs it to its end, in the calling flow, which is the robot's from now
  /// on. Returns never: it leave()s.
  [[noreturn]] void run();

  void* variable(const char* name) override;
  /// Ends it at its time limit, or because it cannot go on: its exit handlers find that its session
  /// has ended. Outside of any call: as exit().
  [[noreturn]] void leave(int code) final;
  /// Its program ends by itself: calls its exit handlers, as EYEBRIDGE_EXIT and the others say
  /// (launcher_calls.h), tells of an exit code that is not 0, and leaves. In the robot's flow.
  [[noreturn]] void exit(int code, int how);
  /// `size` bytes, always the same, that are zero at first. Any thread.
  void* state(std::size_t size);
  [[nodiscard]] ProgramSignals& signals() { return signals_; }
  /// True when `address` lies in its program.
  [[nodiscard]] bool runs(const void* address) const;
  /// The robot's program cannot go on in the calling flow: tells so and leaves.
  [[noreturn]] void fail(const std::string& how, int code);
  /// Its program crashed or hangs, and ends no session: that is what it ends with. Any thread.
  void break_off(int code);
  /// Ends it from outside of its flow, which goes no further: a person takes it out of the run, or,
  /// with `why`, told as a warning, it has to end. Returns when its process has ended, too, if it
  /// has one.
  void remove(int code = 0, const std::string& why = "");
  /// Its panel's screen; null where a process has it.
  [[nodiscard]] const Screen* screen() const;

  [[nodiscard]] std::size_t index() const { return index_; }
  /// On its clock.
  [[nodiscard]] Time now() const;
  /// Ends its session from outside of the program: motors stop, results are written. A process
  /// only begins to end; make_process_end() waits for it. Any thread.
  void end_session() noexcept;
  void make_process_end() noexcept;
  /// Changes while the program calls; where it has a process of its own nobody counts. Any thread.
  [[nodiscard]] std::uint64_t calls() const { return session_ != nullptr ? session_->calls() : 0; }
  [[nodiscard]] bool has_ended() const { return ended_; }
  [[nodiscard]] int exit_code() const { return exit_code_; }
  /// Of a session in this process; another one says it by its exit code.
  [[nodiscard]] bool has_lost_results() const {
    return session_ != nullptr && session_->has_lost_results();
  }

  /// The robot of the calling flow; null when it is none's.
  static Robot* current();

 protected:
  /// Its program is in a process of its own.
  [[nodiscard]] bool has_process() const { return process_ != nullptr; }
  [[nodiscard]] Clock& clock() const;
  /// In virtual time: up to where its clock may go by itself, lent; and who is told that all wait
  /// for its process. Null in real time.
  [[nodiscard]] virtual const Time* limit() const { return nullptr; }
  virtual AwaitedProcess* awaited() { return nullptr; }

  /// Ends the session, if that has not been done, and the calling flow.
  [[noreturn]] virtual void drop(int code) = 0;
  /// The program has been ended from outside; whoever schedules robots forgets it.
  virtual void forget() = 0;
  /// Ends the session; false when another flow of the robot has done so before.
  bool end(int code);

 private:
  [[nodiscard]] LogSink& log() const;
  [[noreturn]] void run_process();
  void tell(int code);
  bool leave_image();
  void finish_image(bool is_quick, int code);

  const std::size_t index_;
  const RobotProgram program_;
  std::shared_ptr<ProgramImage> image_;
  Session* session_ = nullptr;               ///< Null where a process has it.
  std::unique_ptr<ProgramProcess> process_;  ///< Else null.
  std::atomic<bool> ended_ = false;
  std::atomic<bool> uses_image_ = false;
  std::atomic<bool> finishes_image_ = false;  ///< It is, or was, the last one to use it.
  std::atomic<bool> has_told_ = false;        ///< Of its exit code.
  std::once_flag has_state_;
  std::unique_ptr<std::byte[]> state_;
  ProgramSignals signals_;
  const int process_id_;
  int exit_code_ = 0;
};

}  // namespace eyebridge::robios
