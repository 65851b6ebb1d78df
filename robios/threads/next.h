/* The C library's own functions, behind ours of the same name. */
#ifndef EYEBRIDGE_THREADS_NEXT_H
#define EYEBRIDGE_THREADS_NEXT_H

#include <dlfcn.h>
#include <stdio.h>
#include <unistd.h>

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

#endif
