#include "session.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <pthread.h>
#include <unistd.h>

#include "analog_recorder.hpp"
#include "camera_port.hpp"
#include "costs.hpp"
#include "eyebridge/camera/frame_sink.hpp"
#include "eyebridge/camera/prepare_process.hpp"
#include "eyebridge/camera/view.hpp"
#include "eyebridge/hal/registry.hpp"
#include "failures.hpp"
#include "host.hpp"
#include "keys.hpp"
#include "library_threads.hpp"
#include "open_panel.hpp"
#include "radio_messages.hpp"
#include "run_output.hpp"
#include "screen.hpp"
#include "signals.hpp"
#include "stderr_log.hpp"
#include "terminal/terminal_mode.hpp"
#include "terminal/terminal_panel.hpp"
#include "timers.hpp"

namespace eyebridge::robios {
namespace {

enum class Stage { Running, Ended, Forked };

// For the handlers of fork(), which may come at any time.
std::atomic<Session*> the_session = nullptr;

Severity lowest_severity(const hal::Config& config) {
  Severity severity = Severity::Warning;
  if (!parse_severity(config.text("log"), severity)) {
    throw ConfigError(config.value("log").where,
                      fmt::format("'{}' is no log level; expected debug, info, warning or error",
                                  config.text("log")));
  }
  return severity;
}

hal::Config read_config() {
  camera::prepare_process();  // before the session's threads
  return hal::Config::from_process(program_file());
}

/// The rows of the screen, and a last one with the labels of the soft keys in brackets, their line
/// ends as '/'.
std::string text_of(const Screen& screen) {
  std::string text;
  for (const std::string& row : screen.text_rows()) text += row + '\n';
  for (std::string label : screen.menu_labels()) {
    std::ranges::replace(label, '\n', '/');
    text += '[' + label + ']';
  }
  return text + '\n';
}

/// What `use` makes of the setting `name`; a mistake in it is reported where the setting was made.
template <class Use>
auto from_setting(const hal::Config& config, const char* name, Use&& use) {
  const hal::ConfigValue& value = config.value(name);
  try {
    return use(value.text);
  } catch (const ConfigError& error) {
    throw hal::error_in(value, error);
  }
}

std::unique_ptr<Keys> make_keys(const hal::Config& config, Clock& clock, Screen& screen,
                                const TerminalPanel* panel) {
  auto script = from_setting(config, "keys", parse_key_script);
  std::unique_ptr<KeyInput> input = terminal_keys();
  if (panel != nullptr) {
    input = std::make_unique<TerminalKeys>(
        panel->descriptor(), [panel](int column, int row) { return panel->pixel_at(column, row); });
  }
  auto keys = std::make_unique<Keys>(clock, std::move(script), std::move(input));
  keys->set_touch_map([&screen](int x, int y) { return screen.key_at(x, y); });
  return keys;
}

/// A camera that the user asked for must be possible; one that nobody mentioned may be missing
/// until the program wants it.
void check_camera(const hal::Config& config, const camera::SourceContext& context) {
  const hal::ConfigValue& value = config.value("camera");
  if (value.text == "none" || (value.is_default() && context.view == nullptr)) return;
  from_setting(config, "camera",
               [&](const std::string& url) { camera::check_source(url, context); });
}

}  // namespace

struct Session::Impl {
  Impl()
      : config(read_config()),
        log(lowest_severity(config)),
        backend(hal::open_backend({config, log})),
        clock(backend->clock()),
        screen(make_screen(config)),
        panel(open_panel(config, *screen)),
        keys(make_keys(config, clock, *screen, panel.get())),
        camera(config.text("camera"), {&clock, backend->camera_view(), &log},
               backend->camera_source()),
        timers(clock),
        recorder(clock, timers),
        cost_scale(config.number("cost_scale")) {
    check_camera(config, {&clock, backend->camera_view(), &log});
    if (config.is_set("time_limit")) limit = from_seconds(config.number("time_limit"));
    if (config.is_set("out")) {
      from_setting(config, "out", [&](const std::string&) {
        output.emplace(config.path("out"), config.integer("save_frames"));
      });
      backend->trace_to(&*output);
    }
    camera.on_frame([this, sink = backend->frame_sink()](const camera::Frame& frame) {
      if (output) output->frame(frame);
      if (sink != nullptr) sink->take(frame);
    });
  }

  hal::Config config;
  StderrLog log;
  std::unique_ptr<hal::Backend> backend;
  Clock& clock;
  std::unique_ptr<Screen> screen;
  std::unique_ptr<TerminalPanel> panel;  ///< Null for none.
  std::unique_ptr<Keys> keys;
  CameraPort camera;
  Timers timers;
  AnalogRecorder recorder;
  RadioMessages messages;
  double cost_scale;
  std::optional<Time> limit;
  std::optional<RunOutput> output;
  const std::chrono::steady_clock::time_point wall_start = std::chrono::steady_clock::now();
  std::once_flag ended;
  bool results_lost = false;

  Failures failures;
  std::atomic<Stage> stage = Stage::Running;
  std::atomic<std::thread::id> ending_thread{};
  std::atomic<std::uint64_t> calls = 0;  ///< Of the program, but for its timers'.
  std::uint64_t calls_seen = 0;
  std::clock_t processor_seen = 0;

  /// exit() must be called by one thread only. True when that is the caller, now or before.
  bool claim_end() {
    std::thread::id nobody{};
    const std::thread::id me = std::this_thread::get_id();
    return ending_thread.compare_exchange_strong(nobody, me) || nobody == me;
  }

  /// Throws std::runtime_error when something could not be written.
  void finish() {
    const Time simulated = clock.now();
    if (!output) return;
    camera::View* view = backend->camera_view();
    std::optional<world::Scene> scene;
    if (view != nullptr) scene = view->scene();
    output->finish(scene ? &*scene : nullptr, screen->snapshot(), text_of(*screen));
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - wall_start;
    fmt::print(stderr,
               "eyebridge: {:.2f} s on the robot's clock in {:.2f} s ({:.0f}x); results in {}\n",
               to_seconds(simulated), wall.count(), to_seconds(simulated) / wall.count(),
               config.path("out").string());
  }
};

Session& Session::instance() {
  // Never destroyed: threads and exit handlers of the program may still call. It ends by end().
  static Session* const session = [] {
    try {
      auto* made = new Session;
      the_session = made;
      publish_globals(*made);
      // Not atexit(): a run whose results are missing must not end as one that succeeded.
      on_exit(
          [](int status, void*) {
            instance().end();
            if (status != 0 || !instance().impl_->results_lost) return;
            std::fflush(nullptr);
            _exit(1);
          },
          nullptr);
      watch_forks();
      watch_signals([](int) { instance().end(); }, [] { instance().look_around(); });
      if (made->impl_->panel) made->impl_->panel->start();
      return made;
    } catch (const ConfigError& error) {
      fmt::print(stderr, "eyebridge: {}\n", error.what());
      std::exit(2);
    } catch (const std::exception& error) {
      fmt::print(stderr, "eyebridge: the robot cannot be started: {}\n", error.what());
      std::exit(1);
    }
  }();
  return *session;
}

bool Session::has_begun() { return the_session != nullptr; }

Session* Session::with_own_time() {
  Session* session = the_session;
  if (session == nullptr || session->impl_->stage != Stage::Running) return nullptr;
  const bool wall = !session->clock().is_virtual() && session->config().number("factor") == 1.0;
  return wall ? nullptr : session;
}

Session::Session() : impl_(std::make_unique<Impl>()) {}
Session::~Session() = default;

const hal::Config& Session::config() const { return impl_->config; }
hal::Backend& Session::backend() { return *impl_->backend; }
Clock& Session::clock() { return impl_->clock; }
Screen& Session::screen() { return *impl_->screen; }
Keys& Session::keys() { return *impl_->keys; }
CameraPort& Session::camera() { return impl_->camera; }
Timers& Session::timers() { return impl_->timers; }
AnalogRecorder& Session::recorder() { return impl_->recorder; }
RadioMessages& Session::messages() { return impl_->messages; }
LogSink& Session::log() { return impl_->log; }

void Session::charge(std::string_view call) {
  if (impl_->clock.is_virtual()) {
    if (!Timers::is_calling()) impl_->calls.fetch_add(1, std::memory_order_relaxed);
    const double cost = static_cast<double>(cost_of(call).count()) * impl_->cost_scale;
    impl_->clock.spend(Time(static_cast<Time::rep>(cost)));
    impl_->timers.run_due();
  }
  check_limit();
}

void Session::wait_until(Time deadline) {
  for (;;) {
    const Time until = impl_->limit ? std::min(deadline, *impl_->limit) : deadline;
    const std::optional<Time> timer = impl_->timers.next_due();
    impl_->clock.wait_until(timer ? std::min(*timer, until) : until);
    impl_->timers.run_due();
    check_limit();
    if (impl_->clock.now() >= deadline || impl_->stage != Stage::Running) return;
  }
}

void Session::check_limit() {
  if (!impl_->limit || impl_->clock.now() < *impl_->limit) return;
  if (impl_->stage != Stage::Running || !impl_->claim_end()) return;
  impl_->log.write(Severity::Info,
                   fmt::format("the time limit of {} s is reached", to_seconds(*impl_->limit)));
  std::exit(0);
}

// Programs that wait for something else than the robot, or have only threads of ours left.
void Session::look_around() {
  if (impl_->stage != Stage::Running) return;
  if (impl_->clock.is_virtual()) {
    go_on_without_calls();
  } else {
    check_limit();
  }
  if (only_library_threads_left() && impl_->claim_end()) std::exit(0);
}

// A program that waits in an empty loop for what its timer changes makes no call with which virtual
// time would pass. When it has only computed for a second, time goes on from timer to timer;
// slowly, so that not many more are called than it waits for.
void Session::go_on_without_calls() {
  constexpr int kTimersAtOnce = 50;  // then signals are looked after, too
  const std::uint64_t calls = impl_->calls;
  const std::clock_t processor = std::clock();
  if (std::exchange(impl_->calls_seen, calls) != calls) impl_->processor_seen = processor;
  if (processor - impl_->processor_seen < CLOCKS_PER_SEC) return;
  for (int i = 0; i < kTimersAtOnce && impl_->calls == calls; ++i) {
    const std::optional<Time> due = impl_->timers.next_due();
    if (!due || impl_->stage != Stage::Running) return;
    impl_->clock.wait_until(*due);
    impl_->timers.run_due();
    check_limit();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

bool Session::may_call(std::string_view call) const {
  const Stage stage = impl_->stage;
  if (stage == Stage::Forked) {
    fmt::print(stderr,
               "eyebridge: error: {}: called in a forked process; only the process that "
               "started the robot can use it\n",
               call);
    _exit(1);
  }
  return stage == Stage::Running;
}

void Session::watch_forks() {
  static constexpr auto visit = [](auto&& act) {
    auto& output = the_session.load()->impl_->output;
    if (output) act(*output);
  };
  pthread_atfork([] { visit([](RunOutput& output) { output.before_fork(); }); },
                 [] { visit([](RunOutput& output) { output.after_fork(); }); },
                 [] {
                   visit([](RunOutput& output) { output.after_fork(); });
                   the_session.load()->impl_->stage = Stage::Forked;
                   leave_signals_alone();
                 });
}

void Session::await_end() {
  while (!impl_->claim_end()) pause();
}

void Session::abort_run(const Error& error) {
  await_end();  // another thread may be ending the process already
  impl_->log.write(Severity::Error, error.what);
  std::exit(1);
}

void Session::succeeded(std::string_view call) { impl_->failures.succeeded(call); }

void Session::failed(std::string_view call, const Error& error) {
  if (!impl_->failures.add(call, error)) return;
  impl_->log.write(Severity::Warning, fmt::format("{}: {}", call, error.what));
}

std::string Session::last_error() const { return impl_->failures.last(); }

void Session::end() noexcept {
  if (impl_->stage == Stage::Forked) return;
  std::call_once(impl_->ended, [this] {
    impl_->claim_end();
    impl_->stage = Stage::Ended;
    impl_->timers.stop();
    impl_->recorder.stop();
    impl_->backend->stop();
    if (impl_->panel) impl_->panel->stop();
    release_terminal();
    host_ending();
    impl_->backend->trace_to(nullptr);
    try {
      impl_->finish();
    } catch (const std::exception& error) {
      impl_->results_lost = true;
      impl_->log.write(Severity::Error, error.what());
    }
    impl_->backend->stop();  // again: a call of another thread may have been under way
  });
}

}  // namespace eyebridge::robios
