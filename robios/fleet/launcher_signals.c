/* Signals of robots' programs: each robot has its own handlers. What a crash comes to, and Ctrl-C,
   stay the run's. */
#include <errno.h>
#include <signal.h>
#include <stddef.h>

#include "launcher_calls.h"
#include "next.h"

/* The functions here are called by libraries, too, for the whole process. */
static int is_programs(const void* caller, const struct sigaction* action) {
  if (eyebridge_calls.is_program == NULL || eyebridge_calls.set_signal == NULL) return 0;
  /* A last call of a function leaves no trace of where it came from. */
  return eyebridge_calls.is_program(caller) ||
         (action != NULL && eyebridge_calls.is_program(*(void* const*)&action->sa_handler));
}

static int set(int signal, const struct sigaction* action, struct sigaction* before,
               const void* caller) {
  NEXT(int, sigaction, (int, const struct sigaction*, struct sigaction*));
  if (signal < 1 || signal >= NSIG || !is_programs(caller, action)) {
    return next_sigaction(signal, action, before);
  }
  if (eyebridge_calls.set_signal(signal, action, before)) return 0;
  return action != NULL ? next_sigaction(signal, action, NULL) : 0;
}

EXPORTED int sigaction(int signal, const struct sigaction* action, struct sigaction* before) {
  return set(signal, action, before, __builtin_return_address(0));
}

static sighandler_t set_simply(int signal, sighandler_t handler, int flags, const void* caller) {
  struct sigaction action = {0};
  struct sigaction before = {0};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  if ((flags & SA_NODEFER) == 0 && signal > 0 && signal < NSIG) sigaddset(&action.sa_mask, signal);
  return set(signal, &action, &before, caller) == 0 ? before.sa_handler : SIG_ERR;
}

EXPORTED sighandler_t signal(int number, sighandler_t handler) {
  return set_simply(number, handler, SA_RESTART, __builtin_return_address(0));
}

EXPORTED sighandler_t bsd_signal(int number, sighandler_t handler);
sighandler_t bsd_signal(int number, sighandler_t handler) {
  return set_simply(number, handler, SA_RESTART, __builtin_return_address(0));
}

/* What signal() is with -std=c99 and the like. */
EXPORTED sighandler_t __sysv_signal(int number, sighandler_t handler) {
  const int flags = (int)((unsigned)SA_RESETHAND | SA_NODEFER);
  return set_simply(number, handler, flags, __builtin_return_address(0));
}

EXPORTED int raise(int number) {
  NEXT(int, raise, (int));
  if (is_programs(__builtin_return_address(0), NULL) && eyebridge_calls.raise(number)) return 0;
  return next_raise(number);
}

EXPORTED int kill(pid_t process, int number) {
  NEXT(int, kill, (pid_t, int));
  if (process == getpid() && is_programs(__builtin_return_address(0), NULL) && number > 0 &&
      eyebridge_calls.raise(number)) {
    return 0;
  }
  return next_kill(process, number);
}

/* A robot's crash has a stack of its own already, and its handlers run on the program's. */
EXPORTED int sigaltstack(const stack_t* stack, stack_t* before) {
  NEXT(int, sigaltstack, (const stack_t*, stack_t*));
  if (!is_programs(__builtin_return_address(0), NULL)) return next_sigaltstack(stack, before);
  if (before != NULL) *before = (stack_t){.ss_flags = SS_DISABLE};
  return 0;
}
