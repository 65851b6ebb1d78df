/* eyebridge-robots [PROGRAM [ARGUMENTS]]: runs the programs of several robots in this process.
   Started by `eyebridge run` and by programs themselves, not by people.

   The program's copies and all libraries find the functions in launcher_*.c before those of the C
   library: where they would have ended the process they end a robot, and what the C library keeps
   once they keep for each robot. */
#include <pthread.h>
#include <stddef.h>

#include "launcher_calls.h"
#include "next.h"

EXPORTED struct eyebridge_robot_calls
    eyebridge_calls; /* by which the library knows the launcher, too */

/* For the leak checker: what a robot's program still has at its end was on a stack that is gone,
   and would have gone with the process. */
EXPORTED int __lsan_is_turned_off(void);
int __lsan_is_turned_off(void) { return 1; }

/* The child of fork() has one flow, whose signals are the process's. */
static void leave_signals(void) {
  eyebridge_calls.abort = NULL;
  eyebridge_calls.set_signal = NULL;
  eyebridge_calls.raise = NULL;
}

int main(int argc, char** argv) {
  pthread_atfork(NULL, NULL, leave_signals);
  return EYEBRIDGERobotsMain(argc - 1, argv + 1, &eyebridge_calls);
}
