#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <ctime>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "analog_recorder.hpp"
#include "camera_port.hpp"
#include "eyebridge/camera/latest_frame.hpp"
#include "eyebridge/hal/device_notes.hpp"
#include "failures.hpp"
#include "joining.hpp"
#include "keys.hpp"
#include "lateness.hpp"
#include "log/stderr_log.hpp"
#include "program_threads.hpp"
#include "radio_messages.hpp"
#include "run_output.hpp"
#include "screen.hpp"
#include "session.hpp"
#include "session_start.hpp"
#include "terminal/terminal_panel.hpp"
#include "timers.hpp"
#include "windows/windows.hpp"

namespace eyebridge::robios {

/// What a session has. The order is that in which the parts need each other.
struct Session::Impl {
  /// Beginning: until the program's first call. Its time passes then, too, when it is virtual.
  enum class Stage { Beginning, Running, Ended, Forked };

  /// The session of a process's only robot.
  explicit Impl(hal::Config configuration);
  /// That of one of several.
  explicit Impl(SessionStart start);

  /// Opens the robot's windows, if it has any: when everything else is there, before the program
  /// goes on.
  void open_windows();
  [[nodiscard]] bool is_running() const {
    const Stage now = stage;
    return now == Stage::Running || (now == Stage::Beginning && is_virtual);
  }
  /// exit() must be called by one thread only. True when that is the caller, now or before.
  bool claim_end();
  /// Throws std::runtime_error when something could not be written.
  void finish();

  hal::Config config;
  Runner* runner = nullptr;  ///< Of one of several robots; else null.
  const std::string name;    ///< Of one of several robots; else "".
  StderrLog log;

  // What every call looks at lies together: with a hundred robots the processor waits for memory.
  Windows* windows;                  ///< Of the process; null for none.
  std::unique_ptr<Joining> joining;  ///< Of a process's only robot in a simulated world; else null.
  std::unique_ptr<hal::Backend> backend;
  std::optional<TurnClock> turn_clock;  ///< Of an only robot in virtual time.
  Clock& clock;
  const bool is_virtual;
  std::atomic<Stage> stage = Stage::Beginning;
  double cost_scale;
  std::optional<Time> limit;
  std::atomic<std::uint64_t> calls = 0;  ///< Of the program, but for its timers'.
  Failures failures;
  Lateness lateness;
  Timers timers;

  std::unique_ptr<Screen> screen;
  std::unique_ptr<TerminalPanel> panel;  ///< Null for none.
  std::unique_ptr<Keys> keys;
  camera::LatestFrame latest_frame;         ///< Where there are windows.
  std::shared_ptr<hal::DeviceNotes> notes;  ///< Likewise; else null.
  CameraPort camera;
  AnalogRecorder recorder;
  RadioMessages messages;
  std::filesystem::path out;
  std::optional<RunOutput> output;
  const std::chrono::steady_clock::time_point wall_start = std::chrono::steady_clock::now();
  std::once_flag ended;
  bool results_lost = false;
  bool is_left_moving = false;  ///< As far as we know.

  std::atomic<std::thread::id> ending_thread{};
  std::uint64_t calls_seen = 0;
  Time time_seen{};
  std::clock_t processor_seen = 0;
  int looks_stuck = 0;  ///< So often one after the other all threads waited for each other.
  bool has_told_of_hang = false;

  /// Of own(), by next_own_place(). A call looks for its part without a lock.
  std::array<std::atomic<OwnPart*>, 32> own_parts{};
  std::mutex own_mutex;  ///< For `own`.
  std::vector<std::unique_ptr<OwnPart>> own;

 private:
  Impl(SessionStart* start, hal::Config configuration);
};

}  // namespace eyebridge::robios
