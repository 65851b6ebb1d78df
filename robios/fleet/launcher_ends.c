/* Ends of the process that are a robot's: exit() and its kin, and what is to happen there. */
#include <err.h>
#include <errno.h>
#include <error.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "launcher_calls.h"
#include "next.h"

EXPORTED void exit(int code) {
  NEXT(void, exit, (int));
  if (eyebridge_calls.leave != NULL) eyebridge_calls.leave(code, EYEBRIDGE_EXIT);
  next_exit(code);
  for (;;) pause(); /* the C library's does not return */
}

/* Libraries end their forked children so: only programs' calls are meant. */
static void leave_without_exit(int code, int how, const void* caller) {
  if (eyebridge_calls.is_program != NULL && eyebridge_calls.is_program(caller))
    eyebridge_calls.leave(code, how);
}

EXPORTED void _exit(int code) {
  NEXT(void, _exit, (int));
  leave_without_exit(code, EYEBRIDGE_AT_ONCE, __builtin_return_address(0));
  next__exit(code);
  for (;;) pause();
}

EXPORTED void _Exit(int code) {
  NEXT(void, _Exit, (int));
  leave_without_exit(code, EYEBRIDGE_AT_ONCE, __builtin_return_address(0));
  next__Exit(code);
  for (;;) pause();
}

EXPORTED void quick_exit(int code) {
  NEXT(void, quick_exit, (int));
  leave_without_exit(code, EYEBRIDGE_QUICK_EXIT, __builtin_return_address(0));
  next_quick_exit(code);
  for (;;) pause();
}

EXPORTED void abort(void) {
  NEXT(void, abort, (void));
  if (eyebridge_calls.abort != NULL) eyebridge_calls.abort();
  next_abort();
  for (;;) pause();
}

static int keep(int when, void* function, void* argument, const void* program) {
  return eyebridge_calls.at_exit != NULL &&
         eyebridge_calls.at_exit(when, function, argument, program);
}

/* NOLINTBEGIN(readability-identifier-naming) */
/* What atexit() and the destructors of static objects come to. */
EXPORTED int __cxa_atexit(void (*function)(void*), void* argument, void* program);
int __cxa_atexit(void (*function)(void*), void* argument, void* program) {
  NEXT(int, __cxa_atexit, (void (*)(void*), void*, void*));
  void* const address = *(void**)&function;
  if (keep(EYEBRIDGE_EXIT, address, argument, program)) return 0;
  return next___cxa_atexit(function, argument, program);
}

EXPORTED int __cxa_at_quick_exit(void (*function)(void*), void* program);
int __cxa_at_quick_exit(void (*function)(void*), void* program) {
  NEXT(int, __cxa_at_quick_exit, (void (*)(void*), void*));
  void* const address = *(void**)&function;
  if (keep(EYEBRIDGE_QUICK_EXIT, address, NULL, program)) return 0;
  return next___cxa_at_quick_exit(function, program);
}

/* NOLINTEND(readability-identifier-naming) */

EXPORTED int on_exit(void (*function)(int, void*), void* argument) {
  NEXT(int, on_exit, (void (*)(int, void*), void*));
  void* const address = *(void**)&function;
  if (keep(EYEBRIDGE_WITH_STATUS, address, argument, address)) return 0;
  return next_on_exit(function, argument);
}

/* Those of the C library call an exit() of its own. They write a line in pieces: the lock keeps the
   lines of two robots apart that end at the same time. */
EXPORTED void verr(int code, const char* format, va_list arguments) {
  flockfile(stderr);
  vwarn(format, arguments);
  funlockfile(stderr);
  exit(code);
}

EXPORTED void verrx(int code, const char* format, va_list arguments) {
  flockfile(stderr);
  vwarnx(format, arguments);
  funlockfile(stderr);
  exit(code);
}

EXPORTED void err(int code, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  verr(code, format, arguments);
}

EXPORTED void errx(int code, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  verrx(code, format, arguments);
}

EXPORTED void error(int code, int number, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  fflush(stdout);
  /* Not under the lock: a function of the program's may end it. */
  if (error_print_progname != NULL) error_print_progname();
  flockfile(stderr);
  if (error_print_progname == NULL) fprintf(stderr, "%s: ", program_invocation_name);
  vfprintf(stderr, format, arguments);
  va_end(arguments);
  if (number != 0) fprintf(stderr, ": %s", strerror(number));
  fputc('\n', stderr);
  funlockfile(stderr);
  ++error_message_count;
  if (code != 0) exit(code);
}
