#include "session.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "costs.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/hal/environment.hpp"
#include "flow.hpp"
#include "host.hpp"
#include "library_threads.hpp"
#include "program_threads.hpp"
#include "session_impl.hpp"
#include "terminal/terminal_mode.hpp"

namespace eyebridge::robios {

Session::Session(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Session::~Session() = default;

Session* Session::begin(SessionStart start) {
  auto* made = new Session(std::make_unique<Impl>(std::move(start)));
  Session* const before = std::exchange(flow.session, made);
  publish_globals(*made);
  made->impl_->open_windows();
  set_here(before);
  return made;
}

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

void Session::charge(const Call& call) {
  if (impl_->is_virtual && impl_->turn_clock) join_program_threads();
  // Two threads may count one call: that there was one is all that anybody asks.
  if (!Timers::is_calling()) {
    impl_->calls.store(impl_->calls.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }
  if (impl_->is_virtual) {
    const double cost = static_cast<double>(call.cost.count()) * impl_->cost_scale;
    impl_->clock.spend(Time(static_cast<Time::rep>(cost)) + take_looks());
    if (impl_->timers.any()) impl_->timers.run_due();
  }
  if (impl_->limit) check_limit();
}

std::uint64_t Session::calls() const { return impl_->calls.load(std::memory_order_relaxed); }

Time Session::look_at_clock() {
  // Others go on, too, while one does nothing but look.
  constexpr Time kMost = 100 * kLookCost;
  flow.looked += kLookCost;
  if (flow.looked >= kMost) {
    const InCall in_call;
    impl_->clock.spend(take_looks());
    if (impl_->timers.any()) impl_->timers.run_due();
    if (impl_->limit) check_limit();
  }
  return impl_->clock.now() + flow.looked;
}

void Session::wait_until(Time deadline) {
  for (;;) {
    Time until = impl_->limit ? std::min(deadline, *impl_->limit) : deadline;
    if (impl_->timers.any()) until = std::min(until, impl_->timers.next_due().value_or(until));
    impl_->clock.wait_until(until);
    if (impl_->timers.any()) impl_->timers.run_due();
    if (impl_->limit) check_limit();
    if (until >= deadline || impl_->clock.now() >= deadline) break;
    if (!impl_->is_running()) return;
  }
  if (!impl_->is_virtual) impl_->lateness.add(impl_->clock.now() - deadline);
}

std::optional<Time> Session::next_event() const {
  const std::optional<Time> due = impl_->timers.next_due();
  return due && impl_->limit ? std::min(*due, *impl_->limit) : due ? due : impl_->limit;
}

void Session::run_events() {
  impl_->timers.run_due();
  check_limit();
}

void Session::check_limit() {
  if (!impl_->limit || impl_->clock.now() < *impl_->limit) return;
  if (!impl_->is_running() || !impl_->claim_end()) return;
  impl_->log.write(Severity::Info,
                   fmt::format("the time limit of {} s is reached", to_seconds(*impl_->limit)));
  leave(0);
}

// Programs that wait for something else than the robot, or have only threads of ours left.
void Session::look_around() {
  if (impl_->joining) impl_->joining->look();
  if (!impl_->is_running()) return;
  if (impl_->clock.is_virtual()) {
    end_stuck();
    // Of several robots others tell what hangs.
    if (impl_->name.empty() && !(impl_->joining && impl_->joining->is_awaited())) {
      go_on_without_calls();
    }
  } else {
    check_limit();
  }
  if (only_library_threads_left() && impl_->claim_end()) std::exit(0);
}

// Nobody can wake one of its threads; a library that has a lock may still give it back.
void Session::end_stuck() {
  constexpr int kPatience_looks = 20;  // 2 s
  const bool is_stuck = impl_->turn_clock && program_threads().are_stuck();
  impl_->looks_stuck = is_stuck ? impl_->looks_stuck + 1 : 0;
  if (impl_->looks_stuck < kPatience_looks || !impl_->claim_end()) return;
  impl_->log.write(Severity::Error,
                   "all threads of the program wait for each other, and nobody else can wake one "
                   "of them; it ends");
  leave(1);
}

// A program that computes on makes no call with which virtual time would pass.
void Session::go_on_without_calls() {
  // While a person lets time stand still, whoever lets it pass would wait for him.
  hal::Environment* const world = impl_->backend->environment();
  const bool is_paused = world != nullptr && world->time().is_paused();
  const std::uint64_t calls = impl_->calls;
  const std::clock_t processor = std::clock();
  // Time passes without calls, too: each sched_yield() is a microsecond.
  const Time now = impl_->clock.now();
  const bool has_time_passed = std::exchange(impl_->time_seen, now) != now;
  if (std::exchange(impl_->calls_seen, calls) != calls || has_time_passed || is_paused) {
    impl_->processor_seen = processor;
    impl_->has_told_of_hang = false;
  }
  const double computed_s = static_cast<double>(processor - impl_->processor_seen) / CLOCKS_PER_SEC;
  if (computed_s < 1.0) return;
  if (impl_->timers.any()) {
    run_timers_of_waiting(calls);
    impl_->time_seen = impl_->clock.now();
  } else {
    end_hanging(computed_s);
  }
}

// It may wait in an empty loop for what its timer changes: time goes on from timer to timer;
// slowly, so that not many more are called than it waits for.
void Session::run_timers_of_waiting(std::uint64_t calls) {
  constexpr int kTimersAtOnce = 50;  // then signals are looked after, too
  for (int i = 0; i < kTimersAtOnce && impl_->calls == calls; ++i) {
    const std::optional<Time> due = impl_->timers.next_due();
    if (!due || !impl_->is_running()) return;
    impl_->clock.wait_until(*due);
    impl_->timers.run_due();
    check_limit();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

// Nothing changes what it waits for. In real time the limit would end it; here computing costs
// nothing, so that it may take some seconds more.
void Session::end_hanging(double computed_s) {
  constexpr double kAlways_s = 5.0;
  const double hang_s = impl_->config.number("hang_limit");
  const double limit_s = impl_->limit ? std::max(kAlways_s, to_seconds(*impl_->limit)) : hang_s;
  if (computed_s >= std::min(kAlways_s, hang_s / 2) &&
      !std::exchange(impl_->has_told_of_hang, true)) {
    impl_->log.write(Severity::Warning,
                     fmt::format("the program has computed for {:.0f} s without a call with which "
                                 "virtual time passes; that stands still",
                                 computed_s));
  }
  if (computed_s < std::min(limit_s, hang_s) || !impl_->claim_end()) return;
  const bool is_limit = impl_->limit && limit_s <= hang_s;
  impl_->log.write(
      is_limit ? Severity::Warning : Severity::Error,
      is_limit ? fmt::format("it has computed for longer than the time limit of {} s; it ends",
                             to_seconds(*impl_->limit))
               : fmt::format("it is ended after {:g} s; --hang-limit says when", hang_s));
  leave(is_limit ? 0 : 124);
}

bool Session::may_call(std::string_view call) const {
  const Impl::Stage stage = impl_->stage;
  if (stage == Impl::Stage::Forked) {
    tell(
        fmt::format("error: {}: called in a forked process; only the process that started the "
                    "robot can use it",
                    call));
    _exit(1);
  }
  if (stage == Impl::Stage::Running) return true;
  if (stage == Impl::Stage::Beginning) {
    if (impl_->runner != nullptr) {
      impl_->runner->arrive();
    } else {
      const InCall in_call;
      impl_->backend->arrive();
    }
    auto beginning = Impl::Stage::Beginning;
    return impl_->stage.compare_exchange_strong(beginning, Impl::Stage::Running) || may_call(call);
  }
  if (impl_->runner != nullptr && !impl_->claim_end()) impl_->runner->hold_thread();
  return false;
}

bool Session::is_before_first_call() const {
  return impl_->is_virtual && impl_->stage == Impl::Stage::Beginning;
}

void Session::note_fork() { impl_->stage = Impl::Stage::Forked; }

void* Session::variable(const char* name) const {
  return impl_->runner != nullptr ? impl_->runner->variable(name) : nullptr;
}

Runner* Session::runner() const { return impl_->runner; }

std::function<void()> Session::bound(void (*function)()) {
  return [this, function] {
    if (impl_->runner != nullptr) set_here(this);
    const OutOfCall program;
    function();
  };
}

std::size_t Session::next_own_place() {
  static std::atomic<std::size_t> places = 0;
  return places++;
}

OwnPart& Session::own_part(std::size_t place, std::unique_ptr<OwnPart> (*make)(Session&)) {
  std::atomic<OwnPart*>& known = impl_->own_parts.at(place);
  if (OwnPart* const part = known.load(std::memory_order_acquire)) return *part;
  const std::lock_guard lock(impl_->own_mutex);
  if (known == nullptr) known = impl_->own.emplace_back(make(*this)).get();
  return *known;
}

void Session::leave(int code) {
  if (impl_->runner != nullptr) impl_->runner->leave(code);
  // Destructors of the program come before ours, and may wait for threads.
  if (impl_->turn_clock) program_threads().end();
  const OutOfCall program;
  std::exit(code);
}

void Session::await_end() {
  if (impl_->claim_end()) return;
  if (impl_->runner != nullptr) impl_->runner->hold_thread();
  for (;;) pause();
}

void Session::abort_run(const Error& error) {
  await_end();  // another thread may be ending the process already
  impl_->log.write(Severity::Error, error.what);
  leave(1);
}

void Session::succeeded(std::string_view call) { impl_->failures.succeeded(call); }

void Session::failed(std::string_view call, const Error& error) {
  const bool is_new = impl_->failures.add(call, error);
  if (error.code == Errc::NoDevice && impl_->config.text("missing_devices") == "error") {
    abort_run({error.code, fmt::format("{}: {}; the program ends (--missing-devices error)", call,
                                       error.what)});
  }
  if (is_new) impl_->log.write(Severity::Warning, fmt::format("{}: {}", call, error.what));
}

std::string Session::last_error() const { return impl_->failures.last(); }

// Who runs several tells of all together.
void Session::tell_of_overruns() {
  hal::Environment* const world = impl_->backend->environment();
  if (!impl_->name.empty() || world == nullptr || world->time().overruns() == 0) return;
  impl_->log.write(
      Severity::Warning,
      fmt::format("the computer was too slow {} times: time slipped", world->time().overruns()));
}

// On the robot's clock, so that what a person's pause takes does not count.
void Session::tell_of_lateness() {
  constexpr double kLate = 0.25;  // seconds: a robot at 400 mm/s has gone its own length
  const Lateness& late = impl_->lateness;
  if (late.count() == 0) return;
  const double real = 1.0 / impl_->config.number("factor");
  const double most = real * to_seconds(late.worst());
  const double usual = real * to_seconds(late.percentile99());
  if (const auto world = impl_->backend->shared_world()) {
    world->note("wait_late_99", usual);
    world->note("wait_late_most", most);
  }
  impl_->log.write(
      most > kLate ? Severity::Warning : Severity::Info,
      fmt::format("{} waits: 99 of 100 ended at most {:.1f} ms too late, one {:.1f} ms{}",
                  late.count(), 1e3 * usual, 1e3 * most,
                  most > kLate ? "; the computer is too busy" : ""));
}

// Nobody may take a robot that drives on for one whose program has ended.
void Session::confirm(const Result<void>& stopped) {
  if (stopped) return;
  impl_->is_left_moving = true;
  impl_->log.write(
      Severity::Error,
      fmt::format("the robot may still be moving: it was told to stand, but {}; expected that it "
                  "answers: switch its motors off",
                  stopped.error().what));
}

// Robots that joined go on to their ends.
int Session::await_joined() {
  return impl_->joining && impl_->stage != Impl::Stage::Forked ? impl_->joining->await_end() : 0;
}

bool Session::has_lost_results() const { return impl_->results_lost; }

void Session::end() noexcept {
  if (impl_->stage == Impl::Stage::Forked) return;
  std::call_once(impl_->ended, [this] {
    impl_->claim_end();
    impl_->stage = Impl::Stage::Ended;
    // Destructors may wait for threads.
    if (impl_->turn_clock) program_threads().end();
    if (impl_->runner == nullptr) {
      impl_->timers.stop();
    } else {
      impl_->timers.let_go();  // the session stays, of many robots maybe
    }
    impl_->recorder.stop();
    tell_of_lateness();  // in the report, which ends with stop()
    // Where others go on it keeps its last command, as one of several robots does.
    const bool stops = !impl_->joining || !impl_->joining->is_busy();
    if (stops) static_cast<void>(impl_->backend->stop());
    if (impl_->panel) impl_->panel->stop();
    if (impl_->runner == nullptr) {
      release_terminal();
      host_ending();
    }
    impl_->backend->trace_to(nullptr);
    tell_of_overruns();
    try {
      impl_->finish();
    } catch (const std::exception& error) {
      impl_->results_lost = true;
      impl_->log.write(Severity::Error, error.what());
    }
    if (const std::string lost = impl_->backend->lost_results(); !lost.empty()) {
      impl_->results_lost = true;
      impl_->log.write(Severity::Error, lost);
    }
    // Again: another thread's call may have been under way.
    if (stops) confirm(impl_->backend->stop());
  });
}

}  // namespace eyebridge::robios
