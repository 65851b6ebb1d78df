#include "session_impl.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "eyebridge/camera/frame_sink.hpp"
#include "eyebridge/camera/view.hpp"
#include "eyebridge/hal/environment.hpp"
#include "eyebridge/hal/hand.hpp"
#include "eyebridge/hal/registry.hpp"
#include "host.hpp"
#include "open_panel.hpp"
#include "session_parts.hpp"
#include "session_windows.hpp"
#include "windows/first_use.hpp"
#include "windows/open_windows.hpp"

namespace eyebridge::robios {
namespace {

std::unique_ptr<Joining> joining_of(const hal::Config& config, const SessionStart* start) {
  return start == nullptr && config.text("hal") == "sim" ? make_joining(config) : nullptr;
}

hal::BackendContext context_of(const hal::Config& config, LogSink& log, const SessionStart* start,
                               Joining* joining) {
  return {config, log, start != nullptr ? &start->slot : nullptr,
          joining != nullptr ? &joining->turns() : nullptr};
}

void tell_of_pause(const hal::Environment* environment, const Windows* windows,
                   const std::string& name, LogSink& log) {
  if (environment == nullptr || windows != nullptr) return;
  if (name.empty()) tell_of_ignored_pause(*environment, log);  // who runs several tells once
}

/// The clock that the program's threads see.
Clock& shared_clock(Clock& clock, const SessionStart* start, std::optional<TurnClock>& turns) {
  // Several robots have turns of their own.
  if (!clock.is_virtual() || start != nullptr) return clock;
  program_threads().begin(clock);
  return turns.emplace(clock, program_threads());
}

/// Where results go; empty when none are wanted.
std::filesystem::path results_folder(const hal::Config& config, const SessionStart* start) {
  if (start != nullptr) return start->out;
  return config.is_set("out") ? config.path("out") : std::filesystem::path();
}

}  // namespace

Session::Impl::Impl(hal::Config configuration) : Impl(nullptr, std::move(configuration)) {}
Session::Impl::Impl(SessionStart start) : Impl(&start, start.config) {}

Session::Impl::Impl(SessionStart* start, hal::Config configuration)
    : config(std::move(configuration)),
      runner(start != nullptr ? start->runner : nullptr),
      name(start != nullptr ? start->name : name_among_several(config)),
      log(lowest_severity(config), name),
      windows(open_session_windows(config, log)),
      joining(joining_of(config, start)),
      backend(hal::open_backend(context_of(config, log, start, joining.get()))),
      clock(shared_clock(backend->clock(), start, turn_clock)),
      is_virtual(clock.is_virtual()),
      cost_scale(config.number("cost_scale")),
      timers(clock),
      screen(make_screen(config)),
      // One terminal shows one robot.
      panel(!name.empty() ? nullptr : open_panel(config, *screen, windows != nullptr)),
      keys(make_keys(config, backend->robot_id(), clock, *screen,
                     !name.empty() ? nullptr : person_at(panel.get()))),
      camera(config.text("camera"), {&clock, backend->camera_view(), &log},
             backend->camera_source()),
      recorder(clock, timers),
      out(results_folder(config, start)) {
  tell_of_pause(backend->environment(), windows, name, log);
  hal::check_camera(config, backend.get(), log);
  if (config.is_set("time_limit")) limit = from_seconds(config.number("time_limit"));
  if (!out.empty()) {
    hal::from_setting(config, "out", [&](const std::string&) {
      output.emplace(out, config.integer("save_frames"));
    });
    backend->trace_to(&*output);
  }
  camera.on_frame([this, sink = backend->frame_sink()](const camera::FramePtr& frame) {
    if (output) output->frame(*frame);
    if (sink != nullptr) sink->take(*frame);
    if (windows != nullptr) latest_frame.set(frame);
  });
}

void Session::Impl::open_windows() {
  if (windows == nullptr) return;
  hal::NotedBackend noted = hal::with_notes(std::move(backend));
  backend = std::move(noted.backend);
  notes = std::move(noted.notes);
  if (hal::Environment* const environment = backend->environment()) {
    auto watched = std::make_unique<FirstUse>(std::move(backend));
    watched->on_first_use(
        [this, environment] { show_world(*windows, *environment, joining.get()); });
    backend = std::move(watched);
  }
  const std::string robot = name.empty() ? "robot" : name;
  const std::string title = program_file().filename().string() + " – " + robot;
  windows->open_panel({title, screen.get(), keys.get(), &latest_frame, notes.get()});
  if (const hal::HandGuide* const guide = backend->hand_guide()) {
    windows->open_hand_view({title, guide, &latest_frame});
  }
}

bool Session::Impl::claim_end() {
  std::thread::id nobody{};
  const std::thread::id me = std::this_thread::get_id();
  return ending_thread.compare_exchange_strong(nobody, me) || nobody == me;
}

void Session::Impl::finish() {
  const Time simulated = clock.now();
  if (!output) return;
  camera::View* view = backend->camera_view();
  std::optional<world::Scene> scene;
  if (view != nullptr) scene = view->scene();
  output->finish(scene ? &*scene : nullptr, screen->snapshot(), text_of(*screen));
  if (!name.empty()) return;  // who runs them tells of all together
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - wall_start;
  fmt::print(
      stderr, "eyebridge: {:.2f} s on the robot's clock in {:.2f} s ({:.0f}x); results in {}\n",
      to_seconds(simulated), wall.count(), to_seconds(simulated) / wall.count(), out.string());
}

}  // namespace eyebridge::robios
