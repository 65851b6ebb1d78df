// The session of a process that runs one robot's program: it begins with the program's first call,
// and ends with the process.

#include <atomic>
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>
#include <pthread.h>
#include <unistd.h>

#include "eyebridge/base/log.hpp"
#include "eyebridge/camera/prepare_process.hpp"
#include "eyebridge/hal/shared_world.hpp"
#include "host.hpp"
#include "session_impl.hpp"
#include "signals.hpp"

namespace eyebridge::robios {
namespace {

// For the handlers of fork(), which may come at any time.
std::atomic<Session*> the_session = nullptr;

hal::Config read_config() {
  camera::prepare_process();  // before the session's threads
  hal::Config config = hal::Config::from_process(program_file());
  // A program of eyebridge-cc has become the launcher before its main() (fleet/start_several.cpp).
  if (hal::programs_wanted(config) > 1) {
    const hal::ConfigValue& robots = config.value("robots");
    throw ConfigError(robots.where, fmt::format("found {} robots, but this program can be that of "
                                                "one only; expected one built with eyebridge-cc or "
                                                "eyebridge-c++, or a Python program in a file",
                                                robots.text));
  }
  config.keep_outputs();
  return config;
}

}  // namespace

bool Session::has_begun() { return here() != nullptr || the_session != nullptr; }

Session* Session::with_own_time() {
  Session* session = here() != nullptr ? here() : the_session.load();
  if (session == nullptr || !session->impl_->is_running()) return nullptr;
  const bool wall = !session->impl_->is_virtual && session->config().number("factor") == 1.0;
  return wall ? nullptr : session;
}

Session& Session::only() {
  // Never destroyed: threads and exit handlers of the program may still call. It ends by end().
  static Session* const session = [] {
    const InCall in_call;  // the threads that begin here are ours
    try {
      auto* made = new Session(std::make_unique<Impl>(read_config()));
      the_session = made;
      publish_globals(*made);
      // Not atexit(): a run whose results are missing must not end as one that succeeded.
      on_exit(
          [](int status, void*) {
            const InCall in_end;
            only().end();
            int code = only().await_joined();
            if (only().impl_->results_lost || only().impl_->is_left_moving) code = 1;
            if (status != 0 || code == 0) return;
            std::fflush(nullptr);
            _exit(code);
          },
          nullptr);
      watch_forks();
      watch_signals(
          [](int) {
            only().end();
            if (only().impl_->joining) only().impl_->joining->end();
            if (Windows* const windows = only().impl_->windows) windows->complete_files();
          },
          [] { only().look_around(); });
      if (made->impl_->panel) made->impl_->panel->start();
      if (made->impl_->joining) made->impl_->joining->open(made->impl_->backend->shared_world());
      made->impl_->open_windows();
      return made;
    } catch (const ConfigError& error) {
      tell(error.what());
      std::exit(2);
    } catch (const std::exception& error) {
      tell(fmt::format("the robot cannot be started: {}", error.what()));
      std::exit(1);
    }
  }();
  return *session;
}

void Session::program_ends(int status) noexcept {
  Session* const session = the_session;
  if (session == nullptr || session->impl_->windows == nullptr) return;
  const InCall in_call;
  if (session->impl_->stage == Impl::Stage::Forked) return;
  session->end();
  session->await_joined();
  std::fflush(nullptr);  // whoever reads the program's output does not wait for the person
  session->impl_->windows->finish(
      status == 0 ? "The program has ended" : fmt::format("The program has ended with {}", status));
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
                   the_session.load()->impl_->stage = Impl::Stage::Forked;
                   leave_signals_alone();
                 });
}

}  // namespace eyebridge::robios
