/* The C library's own functions, behind ours of the same name. */
#ifndef EYEBRIDGE_THREADS_NEXT_H
#define EYEBRIDGE_THREADS_NEXT_H

#include <dlfcn.h>
#include <stdio.h>
#include <unistd.h>

#include "turn_calls.h"

#define EXPORTED __attribute__((visibility("default")))

static inline void* eyebridge_next(const char* name, void** known) {
  void* found = __atomic_load_n(known, __ATOMIC_RELAXED);
  if (found != NULL) return found;
  found = dlsym(RTLD_NEXT, name);
  if (found == NULL) {
    fprintf(stderr, "eyebridge: the C library has no %s()\n", name);
    _exit(1);
  }
  __atomic_store_n(known, found, __ATOMIC_RELAXED);
  return found;
}

/* NOLINTBEGIN(bugprone-macro-parentheses): a type and a list of parameters */
/* NEXT(int, pthread_join, (pthread_t, void**)) names a pointer `next_pthread_join` of that type. */
#define NEXT(RESULT, NAME, ARGUMENTS) \
  static void* known_##NAME;          \
  RESULT(*next_##NAME) ARGUMENTS;     \
  *(void**)&next_##NAME = eyebridge_next(#NAME, &known_##NAME)
/* NOLINTEND(bugprone-macro-parentheses) */

/* Whom these functions ask: the launcher's struct, or the library's own. */
#ifndef EYEBRIDGE_CALLS
#define EYEBRIDGE_CALLS eyebridge_calls
#endif
extern struct eyebridge_robot_calls EYEBRIDGE_CALLS;
#define CALLS EYEBRIDGE_CALLS

/* Threads of the system; else strands, which the C library takes for one. */
#define ARE_THREADS() (CALLS.own == NULL)

/* Unless is_free(what, value) says at the start, or, when it `is_watched`, later that it need not.
 */
static inline int eyebridge_park(const void* what, long long deadline,
                                 int (*is_free)(const void*, long), long value, int is_watched) {
  return CALLS.park_unless != NULL ? CALLS.park_unless(what, deadline, is_free, value, is_watched)
                                   : CALLS.park(what, deadline);
}

#define TURNS() (CALLS.turns != NULL ? CALLS.turns() : EYEBRIDGE_NO_TURNS)
#define TAKES_TURNS() (TURNS() == EYEBRIDGE_IN_PROGRAM)

#endif
