/* eyebridge-robots LIBRARY [PROGRAM [ARGUMENTS]]: runs the programs of several robots in this process. Started
   by `eyebridge run` and by programs themselves, not by people.

   The program's copies and all libraries find the functions below before those of the C library: they
   end a robot where they would have ended the process. */
#include "launcher.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#define EXPORTED __attribute__((visibility("default")))

static struct eyebridge_robot_calls calls;

static void* next(const char* name) {
  void* found = dlsym(RTLD_NEXT, name);
  if (found != NULL) return found;
  fprintf(stderr, "eyebridge-robots: the C library has no %s()\n", name);
  _exit(1);
}

EXPORTED void exit(int code) {
  void (*real)(int);
  if (calls.leave != NULL) calls.leave(code);
  *(void**)&real = next("exit");
  real(code);
  for (;;) pause(); /* the C library's does not return */
}

EXPORTED void abort(void) {
  void (*real)(void);
  if (calls.abort != NULL) calls.abort();
  *(void**)&real = next("abort");
  real();
  for (;;) pause();
}

int main(int argc, char** argv) {
  if (argc < 2) {
    fprintf(stderr, "usage: eyebridge-robots LIBRARY [PROGRAM [ARGUMENTS]]; people use eyebridge run\n");
    return 2;
  }
  void* library = dlopen(argv[1], RTLD_NOW | RTLD_GLOBAL);
  eyebridge_robots_main* run = NULL;
  if (library != NULL) *(void**)&run = dlsym(library, "EYEBRIDGERobotsMain");
  if (run == NULL) {
    fprintf(stderr, "eyebridge-robots: %s\n", dlerror());
    return 1;
  }
  return run(argc - 2, argv + 2, &calls);
}
