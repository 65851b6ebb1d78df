// The calls of multitasking; what they do is in the kernel.

#include <fmt/format.h>

#include "call.hpp"
#include "classic_lcd.hpp"
#include "eyebot.h"
#include "timer_slots.hpp"
#include "timers.hpp"

namespace {

using namespace eyebridge;
using robios::Session;
using robios::classic::call;
using robios::classic::doing;
using robios::classic::Kernel;

Kernel::Hooks hooks_of(Session& session) {
  return {
      [&session](Time deadline) { session.wait_until(deadline); },
      [&session] { return session.timers().next_due(); },
      [&session] { return robios::classic::timers_attached(session); },
      [&session] {
        session.abort_run({Errc::Timeout,
                           "all tasks wait for each other or are suspended, and nothing else could "
                           "wake one of them"});
      },
  };
}

/// A session's: never destroyed, as tasks may still call while the process ends.
struct SessionKernel {
  explicit SessionKernel(Session& session) : kernel(session.clock(), hooks_of(session)) {}
  Kernel kernel;
};

Kernel& the_kernel() { return robios::classic::kernel(); }

}  // namespace

Kernel& eyebridge::robios::classic::kernel() {
  return Session::instance().own<SessionKernel>().kernel;
}

int OSMTInit(BYTE mode) {
  return doing("OSMTInit", 1, [&](Session&) -> Result<void> {
    if (mode != COOP && mode != PREEMPT) {
      return fail(Errc::OutOfRange, fmt::format("mode {}, expected COOP or PREEMPT", mode));
    }
    if (the_kernel().start(mode == PREEMPT)) return {};
    return fail(Errc::OutOfRange, "multitasking has been started already");
  });
}

int OSMTStatus(void) {
  return call("OSMTStatus", NOTASK, [](Session&) -> Result<int> {
    if (!the_kernel().started()) return NOTASK;
    return the_kernel().preemptive() ? PREEMPT : COOP;
  });
}

struct tcb* OSSpawn(const char* name, void (*code)(void), int stksiz, int pri, int uid) {
  return call("OSSpawn", static_cast<tcb*>(nullptr), [&](Session&) -> Result<tcb*> {
    if (code == nullptr) return robios::null_pointer();
    if (pri < MIN_PRI || pri > MAX_PRI) {
      return fail(Errc::OutOfRange,
                  fmt::format("priority {}, expected {} … {}", pri, MIN_PRI, MAX_PRI));
    }
    return the_kernel().spawn(name == nullptr ? "" : name, code, stksiz, pri, uid);
  });
}

int OSReady(struct tcb* thread) {
  return doing("OSReady", 1, [&](Session&) { return the_kernel().ready(thread); });
}

int OSSuspend(struct tcb* thread) {
  return doing("OSSuspend", 1, [&](Session&) { return the_kernel().suspend(thread); });
}

int OSReschedule(void) {
  return doing("OSReschedule", 1, [](Session&) { return the_kernel().reschedule(); });
}

int OSYield(void) {
  return doing("OSYield", 1, [](Session&) { return the_kernel().reschedule(); });
}

int OSRun(struct tcb* thread) {
  return doing("OSRun", 1, [&](Session&) {
    return the_kernel().ready(thread).and_then([] { return the_kernel().reschedule(); });
  });
}

int OSGetUID(struct tcb* thread) {
  return call("OSGetUID", -1, [&](Session&) -> Result<int> { return the_kernel().uid(thread); });
}

int OSKill(struct tcb* thread) {
  if (thread == nullptr && the_kernel().is_main()) Session::instance().leave(0);
  return doing("OSKill", 1, [&](Session&) { return the_kernel().kill(thread); });
}

int OSExit(int code) {
  if (the_kernel().is_main()) Session::instance().leave(code);
  return doing("OSExit", 1, [&](Session& session) -> Result<void> {
    const Result<std::string> name = the_kernel().name(nullptr);
    if (!name) return tl::unexpected(name.error());
    robios::classic::lcd(session).print(fmt::format("{}: {}\n", *name, code));
    return the_kernel().kill(nullptr);
  });
}

int OSPanic(const char* msg) {
  return doing("OSPanic", 1, [&](Session& session) -> Result<void> {
    const char* const text = msg == nullptr ? "" : msg;
    robios::classic::lcd(session).print(text);
    session.abort_run({Errc::Unsupported, fmt::format("OSPanic: {}", text)});
  });
}

int OSForbid(void) {
  return call("OSForbid", 1, [](Session&) -> Result<int> {
    the_kernel().forbid();
    return 0;
  });
}

int OSPermit(void) {
  return doing("OSPermit", 1, [](Session&) { return the_kernel().permit(); });
}

int OSJoin(struct tcb* thread) {
  return doing("OSJoin", 1, [&](Session&) { return the_kernel().join(thread); });
}

int OSSemInit(struct sem* sem, int val) {
  return doing("OSSemInit", 1, [&](Session&) -> Result<void> {
    if (sem == nullptr) return robios::null_pointer();
    if (val < 0) return fail(Errc::OutOfRange, fmt::format("{}, expected at least 0", val));
    the_kernel().set(*sem, val);
    return {};
  });
}

int OSSemP(struct sem* sem) {
  return doing("OSSemP", 1, [&](Session&) -> Result<void> {
    if (sem == nullptr) return robios::null_pointer();
    return the_kernel().take(*sem);
  });
}

int OSSemV(struct sem* sem) {
  return doing("OSSemV", 1, [&](Session&) -> Result<void> {
    if (sem == nullptr) return robios::null_pointer();
    the_kernel().give(*sem);
    return {};
  });
}
