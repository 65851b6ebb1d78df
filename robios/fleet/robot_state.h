/* What the C library keeps once in a process, and the launcher for each robot. */
#ifndef EYEBRIDGE_FLEET_ROBOT_STATE_H
#define EYEBRIDGE_FLEET_ROBOT_STATE_H

#include <stdlib.h>

#include "launcher_calls.h"

/* All zero at first. */
struct eyebridge_robot_state {
  char is_locked; /* The numbers are drawn by one thread at a time. */
  struct random_data random;
  int random_table[32]; /* 128 bytes, as in the C library */
  struct drand48_data random48;
  char* token;            /* strtok() */
  char is_not_with_stdio; /* std::ios::sync_with_stdio() */
};

/* The caller's robot's; null when it is none's. */
static inline struct eyebridge_robot_state* robot_state(void) {
  return eyebridge_calls.state != NULL ? eyebridge_calls.state(sizeof(struct eyebridge_robot_state))
                                       : NULL;
}

#endif
