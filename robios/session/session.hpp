#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "costs.hpp"
#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/backend.hpp"
#include "eyebridge/hal/config.hpp"
#include "flow.hpp"

namespace eyebridge::robios {

class AnalogRecorder;
class CameraPort;
class Keys;
class Lcd;
class RadioMessages;
class Runner;
class Screen;
class Timers;
struct SessionStart;

/// What a session keeps for a family of calls.
struct OwnPart {
  OwnPart() = default;
  OwnPart(const OwnPart&) = delete;
  OwnPart& operator=(const OwnPart&) = delete;
  virtual ~OwnPart() = default;
};

/// What one robot program has: its backend, panel, camera and timers. One per process, or one for
/// each robot of several (robios/fleet).
///
/// Any thread of the program may call; each part locks for itself.
class Session {
 public:
  /// The session of the calling thread's robot; else that of this process. The latter's first call
  /// starts it: configuration, backend, panel. A ConfigError is printed and ends the process with
  /// exit code 2, before the call returns.
  static Session& instance() { return here() != nullptr ? *here() : only(); }

  /// The program of this process ends by itself, with `status`, and no exit handler has run yet:
  /// ends the session, and returns when the person at the windows has closed them.
  static void program_ends(int status) noexcept;

  /// True once the first call has started it.
  static bool has_begun();

  /// The session when it runs and its clock is not the wall clock; else null. Starts nothing.
  static Session* with_own_time();

  /// Begins the session of one of several robots. It is never destroyed. Throws ConfigError.
  static Session* begin(SessionStart start);
  /// The robot whose program the calling thread runs; null when that is the process's only one.
  [[nodiscard]] static Session* here() { return flow.session; }
  static void set_here(Session* session) { flow.session = session; }

  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  [[nodiscard]] const hal::Config& config() const;
  [[nodiscard]] hal::Backend& backend();
  [[nodiscard]] Clock& clock();
  /// What make_screen() made.
  [[nodiscard]] Screen& screen();
  /// The same as the screen of RoBIOS-7, which defines this.
  [[nodiscard]] Lcd& lcd();
  [[nodiscard]] Keys& keys();
  [[nodiscard]] CameraPort& camera();
  [[nodiscard]] Timers& timers();
  [[nodiscard]] AnalogRecorder& recorder();
  [[nodiscard]] RadioMessages& messages();
  [[nodiscard]] LogSink& log();

  /// Charges what `call` costs on a real robot, and runs the timers that came due meanwhile.
  void charge(const Call& call);
  /// How many calls it has charged: changes while the program calls. Any thread.
  [[nodiscard]] std::uint64_t calls() const;
  /// Ends the program when its time limit has come.
  void check_limit();
  /// What the program sees on the C library's clocks. The look is charged later, with others: it
  /// may come from anywhere, as from what counts memory.
  Time look_at_clock();
  /// Waits until `deadline` on the robot's clock; timers run meanwhile.
  void wait_until(Time deadline);

  /// When something happens in virtual time that the program did not wait for: a timer, the time
  /// limit.
  [[nodiscard]] std::optional<Time> next_event() const;
  /// Lets happen what is due.
  void run_events();

  /// False once the run has ended: threads that still call must not start the motors again. Ends a
  /// forked process with a message: a robot has one program.
  [[nodiscard]] bool may_call(std::string_view call) const;
  /// In virtual time: the program has made no call yet, though its time passes.
  [[nodiscard]] bool is_before_first_call() const;

  /// The process is a child of fork(): this robot is its parent's.
  void note_fork();

  /// What this robot has of a family's: made at the first use, of this session where its
  /// constructor takes one; never destroyed before the session.
  template <class Value>
  Value& own() {
    struct Part : OwnPart {
      explicit Part(Session& session) : value(made(session)) {}
      static Value made([[maybe_unused]] Session& session) {
        if constexpr (std::is_constructible_v<Value, Session&>) {
          return Value(session);
        } else {
          return Value{};
        }
      }
      Value value;
    };
    static const std::size_t place = next_own_place();
    OwnPart& part = own_part(place, [](Session& session) -> std::unique_ptr<OwnPart> {
      return std::make_unique<Part>(session);
    });
    return static_cast<Part&>(part).value;
  }
  /// Where this robot's program has its copy of the variable `name` of ours; null when the
  /// process's own counts.
  [[nodiscard]] void* variable(const char* name) const;

  /// Who runs the program of one of several robots; else null.
  [[nodiscard]] Runner* runner() const;
  /// `function` as the robot's timers call it: in one of the robot's own threads.
  [[nodiscard]] std::function<void()> bound(void (*function)());

  /// Ends the program with this exit code.
  [[noreturn]] void leave(int code);

  /// Ends the program with exit code 1 and this message: it cannot go on in any sensible way.
  [[noreturn]] void abort_run(const Error& error);

  /// Book-keeping of guarded().
  void succeeded(std::string_view call);
  void failed(std::string_view call, const Error& error);
  /// The last failure of any call, or "".
  [[nodiscard]] std::string last_error() const;

  /// Stops the motors and writes the results to --out. Idempotent; never throws.
  void end() noexcept;
  /// After end(): a result that was asked for could not be written in full. It has been said.
  [[nodiscard]] bool has_lost_results() const;
  /// Returns in the thread that ends the process: the one that called end() first. In any other it
  /// waits for the process to end, so that the exit code is that of the one reason for the end.
  void await_end();

 private:
  struct Impl;
  explicit Session(std::unique_ptr<Impl> impl);
  ~Session();
  static Session& only();
  /// Index for a new kind of part.
  static std::size_t next_own_place();
  OwnPart& own_part(std::size_t place, std::unique_ptr<OwnPart> (*make)(Session&));
  void look_around();
  void tell_of_overruns();
  void tell_of_lateness();
  void confirm(const Result<void>& stopped);
  int await_joined();
  void end_stuck();
  void go_on_without_calls();
  void run_timers_of_waiting(std::uint64_t calls);
  void end_hanging(double computed_s);
  static void watch_forks();

  std::unique_ptr<Impl> impl_;
};

/// Sets the variables that a skin shows to programs and that depend on the robot. Defined by the
/// skin; called once, when the session has begun.
void publish_globals(Session& session);

/// The robot's screen, as big as `config` says. Defined by the skin; called once. Throws
/// ConfigError.
std::unique_ptr<Screen> make_screen(const hal::Config& config);

}  // namespace eyebridge::robios
