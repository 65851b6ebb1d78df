#include "robot_calls.hpp"

#include "crash_handler.hpp"
#include "flow.hpp"
#include "robot.hpp"
#include "session.hpp"

namespace eyebridge::robios {
namespace {

Strands* strands = nullptr;  // For functions that the C library's callers call.

Time deadline_of(long long nanoseconds) {
  return nanoseconds < 0 ? Lockstep::kNever : Time(nanoseconds);
}

int turns() {
  if (Session::here() == nullptr) return EYEBRIDGE_NO_TURNS;
  if (flow.calls == 0) return EYEBRIDGE_IN_PROGRAM;
  return strands->any() ? EYEBRIDGE_IN_LIBRARY : EYEBRIDGE_NO_TURNS;
}

long long now() { return Session::here()->clock().now() / std::chrono::nanoseconds(1); }

}  // namespace

eyebridge_robot_calls robot_calls(Strands* given) {
  strands = given;
  eyebridge_robot_calls calls{};
  calls.leave = [](int code) {
    if (Robot* const robot = Robot::current()) robot->quit(code);
  };
  calls.abort = [] {
    if (Robot* const robot = Robot::current()) {
      robot->fail("the program called abort(); it ends, the others go on", 134);
    }
  };
  if (given == nullptr) {
    calls.robot = []() -> void* { return Session::here(); };
    calls.begin_thread = [](void* robot) {
      static thread_local const CrashStack stack;
      Session::set_here(static_cast<Session*>(robot));
      flow.stack_mark = __builtin_frame_address(0);
    };
    return calls;
  }
  calls.turns = turns;
  calls.now = now;
  calls.read_clock = []() -> long long {
    if (turns() != EYEBRIDGE_IN_PROGRAM) return -1;
    return Session::here()->look_at_clock() / std::chrono::nanoseconds(1);
  };
  calls.create = [](void* (*start)(void*), void* argument) {
    return strands->create(start, argument);
  };
  calls.self = [] { return strands->self(); };
  calls.finish = [](void* result) { strands->finish(result); };
  calls.join = [](unsigned long thread, void** result) { return strands->join(thread, result); };
  calls.detach = [](unsigned long thread) { return strands->detach(thread); };
  calls.cancel = [](unsigned long thread) { return strands->cancel(thread); };
  calls.specific = [](unsigned key) { return strands->specifics().get(key); };
  calls.set_specific = [](unsigned key, const void* value) {
    strands->specifics().set(key, value);
  };
  calls.make_key = [](unsigned key, void (*destroy)(void*)) {
    strands->specifics().make(key, destroy);
  };
  calls.forget_key = [](unsigned key) { strands->specifics().forget(key); };
  calls.make_barrier = [](const void* barrier, unsigned count) {
    strands->make_barrier(barrier, count);
  };
  calls.meet = [](const void* barrier) { return strands->meet(barrier) ? 1 : 0; };
  calls.park = [](const void* what, long long deadline) {
    return strands->park(what, deadline_of(deadline)) ? 1 : 0;
  };
  calls.wake = [](const void* what, int all) { strands->wake(what, all != 0); };
  calls.own = [](const void* lock) { return strands->own(lock) ? 1 : 0; };
  calls.disown = [](const void* lock) { return strands->disown(lock); };
  calls.owns = [](const void* lock) { return strands->owns(lock) ? 1 : 0; };
  return calls;
}

}  // namespace eyebridge::robios
