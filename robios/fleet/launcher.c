/* eyebridge-robots [PROGRAM [ARGUMENTS]]: runs the programs of several robots in this process.
   Started by `eyebridge run` and by programs themselves, not by people.

   The program's copies and all libraries find the functions here and in launcher_threads.c and
   ../threads before those of the C library: where they would have ended the process they end a
   robot. */
#include <stdlib.h>
#include <unistd.h>

#include "next.h"
#include "turn_calls.h"

EXPORTED struct eyebridge_robot_calls
    eyebridge_calls; /* by which the library knows the launcher, too */

/* Whose end is a robot's: what a program forked has a process of its own to end. */
static pid_t robots_process;

static void leave(int code) {
  if (eyebridge_calls.leave != NULL && getpid() == robots_process) eyebridge_calls.leave(code);
}

EXPORTED void exit(int code) {
  NEXT(void, exit, (int));
  leave(code);
  next_exit(code);
  for (;;) pause(); /* the C library's does not return */
}

EXPORTED void _exit(int code) {
  NEXT(void, _exit, (int));
  leave(code);
  next__exit(code);
  for (;;) pause();
}

EXPORTED void _Exit(int code) { _exit(code); }

EXPORTED void quick_exit(int code) {
  NEXT(void, quick_exit, (int));
  leave(code);
  next_quick_exit(code);
  for (;;) pause();
}

EXPORTED void abort(void) {
  NEXT(void, abort, (void));
  if (eyebridge_calls.abort != NULL && getpid() == robots_process) eyebridge_calls.abort();
  next_abort();
  for (;;) pause();
}

/* For the leak checker: what a robot's program still has at its end was on a stack that is gone,
   and would have gone with the process. */
EXPORTED int __lsan_is_turned_off(void);
int __lsan_is_turned_off(void) { return 1; }

int main(int argc, char** argv) {
  robots_process = getpid();
  return EYEBRIDGERobotsMain(argc - 1, argv + 1, &eyebridge_calls);
}
