/* Random numbers, strtok() and the streams of C++, for each robot: the same numbers as a program
   that has its process to itself draws. */
#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "next.h"
#include "robot_state.h"

typedef struct eyebridge_robot_state State;

/* Begins, as the C library does, as if srandom(1) had been called. */
static State* locked(void) {
  State* const mine = robot_state();
  if (mine == NULL) return NULL;
  while (__atomic_test_and_set(&mine->is_locked, __ATOMIC_ACQUIRE)) {
  }
  if (mine->random.state == NULL) {
    initstate_r(1, (char*)mine->random_table, sizeof mine->random_table, &mine->random);
  }
  return mine;
}

static void unlock(State* mine) { __atomic_clear(&mine->is_locked, __ATOMIC_RELEASE); }

EXPORTED long random(void) {
  NEXT(long, random, (void));
  State* const mine = locked();
  if (mine == NULL) return next_random();
  int32_t drawn = 0;
  random_r(&mine->random, &drawn);
  unlock(mine);
  return drawn;
}

EXPORTED int rand(void) { return (int)random(); }

EXPORTED void srandom(unsigned seed) {
  NEXT(void, srandom, (unsigned));
  State* const mine = locked();
  if (mine == NULL) {
    next_srandom(seed);
    return;
  }
  srandom_r(seed, &mine->random);
  unlock(mine);
}

EXPORTED void srand(unsigned seed) { srandom(seed); }

/* Where programs expect the state's beginning. */
static char* beginning_of(const struct random_data* random) { return (char*)(random->state - 1); }

EXPORTED char* initstate(unsigned seed, char* table, size_t size) {
  NEXT(char*, initstate, (unsigned, char*, size_t));
  State* const mine = locked();
  if (mine == NULL) return next_initstate(seed, table, size);
  char* const before = beginning_of(&mine->random);
  const int failed = initstate_r(seed, table, size, &mine->random);
  unlock(mine);
  return failed != 0 ? NULL : before;
}

EXPORTED char* setstate(char* table) {
  NEXT(char*, setstate, (char*));
  State* const mine = locked();
  if (mine == NULL) return next_setstate(table);
  char* const before = beginning_of(&mine->random);
  const int failed = setstate_r(table, &mine->random);
  unlock(mine);
  return failed != 0 ? NULL : before;
}

/* A function of that family, which draws by that with _r behind its name. */
#define DRAW48(RESULT, NAME, PARAMETERS, ARGUMENTS, BY) \
  EXPORTED RESULT NAME PARAMETERS {                     \
    NEXT(RESULT, NAME, PARAMETERS);                     \
    State* const mine = locked();                       \
    if (mine == NULL) return next_##NAME ARGUMENTS;     \
    RESULT drawn = 0;                                   \
    NAME##_r BY;                                        \
    unlock(mine);                                       \
    return drawn;                                       \
  }

DRAW48(double, drand48, (void), (), (&mine->random48, &drawn))
DRAW48(long, lrand48, (void), (), (&mine->random48, &drawn))
DRAW48(long, mrand48, (void), (), (&mine->random48, &drawn))
DRAW48(double, erand48, (unsigned short state[3]), (state), (state, &mine->random48, &drawn))
DRAW48(long, nrand48, (unsigned short state[3]), (state), (state, &mine->random48, &drawn))
DRAW48(long, jrand48, (unsigned short state[3]), (state), (state, &mine->random48, &drawn))

EXPORTED void srand48(long seed) {
  NEXT(void, srand48, (long));
  State* const mine = locked();
  if (mine == NULL) {
    next_srand48(seed);
    return;
  }
  srand48_r(seed, &mine->random48);
  unlock(mine);
}

EXPORTED unsigned short* seed48(unsigned short seed[3]) {
  NEXT(unsigned short*, seed48, (unsigned short*));
  State* const mine = locked();
  if (mine == NULL) return next_seed48(seed);
  seed48_r(seed, &mine->random48);
  unlock(mine);
  return mine->random48.__old_x;
}

EXPORTED void lcong48(unsigned short parameters[7]) {
  NEXT(void, lcong48, (unsigned short*));
  State* const mine = locked();
  if (mine == NULL) {
    next_lcong48(parameters);
    return;
  }
  lcong48_r(parameters, &mine->random48);
  unlock(mine);
}

EXPORTED char* strtok(char* text, const char* separators) {
  NEXT(char*, strtok, (char*, const char*));
  State* const mine = robot_state();
  if (mine == NULL) return next_strtok(text, separators);
  return strtok_r(text, separators, &mine->token);
}

/* std::ios_base::sync_with_stdio(). The real one would give the process's std::cout & co. other
   buffers; the copies that programs have would still use the old ones. So all stay in step, which
   is allowed. */
/* NOLINTBEGIN(readability-identifier-naming) */
EXPORTED _Bool _ZNSt8ios_base15sync_with_stdioEb(_Bool is_synced);
_Bool _ZNSt8ios_base15sync_with_stdioEb(_Bool is_synced) {
  NEXT(_Bool, _ZNSt8ios_base15sync_with_stdioEb, (_Bool));
  State* const mine = robot_state();
  if (mine == NULL) return next__ZNSt8ios_base15sync_with_stdioEb(is_synced);
  const _Bool before = !mine->is_not_with_stdio;
  mine->is_not_with_stdio = !is_synced;
  return before;
}
/* NOLINTEND(readability-identifier-naming) */
