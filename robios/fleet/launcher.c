/* eyebridge-robots [PROGRAM [ARGUMENTS]]: runs the programs of several robots in this process.
   Started by `eyebridge run` and by programs themselves, not by people.

   The program's copies and all libraries find the functions here, in launcher_*.c and in ../threads
   before those of the C library: where they would have ended the process they end a robot, and what
   the C library keeps once they keep for each robot. */
#include <pthread.h>
#include <stddef.h>

#include "next.h"
#include "turn_calls.h"

EXPORTED struct eyebridge_robot_calls
    eyebridge_calls; /* by which the library knows the launcher, too */

/* For the leak checker: what a robot's program still has at its end was on a stack that is gone,
   and would have gone with the process. */
EXPORTED int __lsan_is_turned_off(void);
int __lsan_is_turned_off(void) { return 1; }

/* The child of fork() has one flow, which is no robot's any more: it takes no turns. */
static void leave_turns(void) {
  const struct eyebridge_robot_calls all = eyebridge_calls;
  eyebridge_calls = (struct eyebridge_robot_calls){
      .leave = all.leave,
      .is_program = all.is_program,
      .state = all.state,
      .at_exit = all.at_exit,
  };
}

int main(int argc, char** argv) {
  pthread_atfork(NULL, NULL, leave_turns);
  return EYEBRIDGERobotsMain(argc - 1, argv + 1, &eyebridge_calls);
}
