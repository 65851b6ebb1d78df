#include "program_threads.hpp"

#include <array>
#include <cstdio>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <pthread.h>
#include <unistd.h>

#include "costs.hpp"
#include "library_threads.hpp"
#include "program_threads.h"
#include "session.hpp"

namespace eyebridge::robios {
namespace {

using Member = ThreadTurns::Member;

Member& member_of(void* member) { return *static_cast<Member*>(member); }

ThreadState look_at(Member& member) { return look_at_thread(member.tid); }

void tell() {
  Session::instance().log().write(
      Severity::Warning,
      fmt::format("a thread of the program has computed for {:g} s without a call with which its "
                  "time passes; the others go on without it",
                  ThreadTurns::kPatience_s));
}

std::optional<Time> next_event() {
  Session* const session = Session::with_own_time();
  return session != nullptr ? session->next_event() : std::nullopt;
}

void run_events() {
  if (Session* const session = Session::with_own_time()) session->run_events();
}

void be(Member* member) {
  flow.member = member;
  flow.in_call = member != nullptr ? &member->is_in_call : nullptr;
  show_in_call(flow.calls > 0);
}

bool is_ours() {
  std::array<char, 16> name{};
  pthread_getname_np(pthread_self(), name.data(), name.size());
  return std::string_view(name.data()).starts_with(kLibraryThread);
}

/// The thread that loads the library is the main one, or an interpreter's that will call.
[[gnu::constructor]] void join_main_thread() {
  if (gettid() == getpid()) join_program_threads();
  pthread_atfork(
      [] {
        const InCall in_call;
        program_threads().before_fork();
      },
      [] {
        const InCall in_call;
        program_threads().after_fork();
      },
      [] {
        {
          const InCall in_call;
          program_threads().after_fork_in_child();
        }
        // It has one thread, with another number, and may begin a session if its parent had none.
        be(nullptr);
        if (!Session::has_begun()) join_program_threads();
      });
}

/// Made before all thread-local variables of the program, and so destroyed after them: they may
/// wait.
struct Leaving {
  Leaving() = default;
  ~Leaving() { leave_program_threads(); }
  Leaving(const Leaving&) = delete;
  Leaving& operator=(const Leaving&) = delete;
};

bool is_time_virtual = false;

Time moment(long long deadline) { return deadline < 0 ? ThreadTurns::kNever : Time(deadline); }
long long nanoseconds(Time time) { return time / std::chrono::nanoseconds(1); }

}  // namespace

ThreadTurns& program_threads() {
  static auto* const threads = new ThreadTurns(look_at, tell, {next_event, run_events});
  return *threads;
}

void join_program_threads() {
  if (flow.member != nullptr || is_ours()) return;
  be(&program_threads().adopt(gettid()));
}

void leave_program_threads() {
  Member* const member = flow.member;
  be(nullptr);  // nothing of it is there afterwards
  if (member != nullptr) program_threads().leave(*member);
}

void expect_virtual_time() { is_time_virtual = true; }

}  // namespace eyebridge::robios

using namespace eyebridge::robios;

extern "C" {

int eyebridge_is_in_program(void) {
  return flow.member != nullptr && flow.calls == 0 && flow.session == nullptr ? 1 : 0;
}

int eyebridge_takes_turns(void) {
  return eyebridge_is_in_program() != 0 && program_threads().have_begun() &&
                 Session::with_own_time() != nullptr
             ? 1
             : 0;
}

long long eyebridge_now(void) { return nanoseconds(program_threads().now()); }

long long eyebridge_read_clock(void) {
  if (flow.calls > 0) return -1;
  if (flow.session != nullptr) {
    Session* const session = Session::with_own_time();
    return session != nullptr && session->clock().is_virtual()
               ? nanoseconds(session->look_at_clock())
               : -1;
  }
  if (eyebridge_is_in_program() == 0) return -1;
  if (Session* const session = Session::has_begun() ? Session::with_own_time() : nullptr) {
    return program_threads().have_begun() ? nanoseconds(session->look_at_clock()) : -1;
  }
  if (!is_time_virtual || Session::has_begun()) return -1;
  flow.looked += kLookCost;
  return nanoseconds(flow.looked);
}

int eyebridge_park(const void* what, long long deadline) {
  if (!program_threads().park(*flow.member, what, moment(deadline))) return 0;
  const InCall in_call;
  if (Session* const session = Session::with_own_time()) session->check_limit();
  return 1;
}

int eyebridge_park_unless(const void* what, long long deadline, int (*is_free)(const void*, long),
                          long value, int else_may) {
  const ThreadTurns::Unless unless{is_free, value, else_may != EYEBRIDGE_NOBODY,
                                   else_may == EYEBRIDGE_ANYBODY};
  return program_threads().park(*flow.member, what, moment(deadline), unless) ? 1 : 0;
}

void eyebridge_wake(const void* what, int all) { program_threads().wake(what, all != 0); }

void eyebridge_begin_time(void) {
  if (is_time_virtual && eyebridge_is_in_program() != 0) (void)Session::instance();
}

void* eyebridge_thread_expected(void) { return &program_threads().expect(); }

void eyebridge_thread_is(void* member, unsigned long thread) {
  program_threads().name(member_of(member), thread);
}

void eyebridge_thread_starts(void* member) {
  static thread_local const Leaving leaving;
  be(&member_of(member));
  member_of(member).tid = gettid();
  program_threads().start(member_of(member));
}

void eyebridge_thread_failed(void* member) { program_threads().leave(member_of(member)); }

void eyebridge_hold_turn(void) {
  if (flow.calls++ == 0) show_in_call(true);
}

void eyebridge_release_turn(void) {
  if (--flow.calls == 0) show_in_call(false);
}

void eyebridge_thread_cancelled(unsigned long thread) { program_threads().cancel(thread); }

int eyebridge_thread_awaited(unsigned long thread, long long deadline) {
  using enum ThreadTurns::Ended;
  switch (program_threads().await_end(*flow.member, thread, moment(deadline))) {
    case Yes:
      return 1;
    case Unknown:
      return 0;
    case Late:
      break;
  }
  return -1;
}

}  // extern "C"
