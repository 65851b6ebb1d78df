/* What stands in the C library's place here asks of the library: which threads are the program's of
   the process's only robot, and how they take turns. A thread that one of them makes is one, too,
   unless a call of the library makes it. C and C++. */
#ifndef EYEBRIDGE_THREADS_PROGRAM_THREADS_H
#define EYEBRIDGE_THREADS_PROGRAM_THREADS_H

#ifdef __cplusplus
extern "C" {
#endif

/* NOLINTBEGIN(readability-identifier-naming): the names of C */
/* 1 when the caller is one of them, outside of calls. */
int eyebridge_is_in_program(void);
/* The same, and its threads take turns, in virtual time: eyebridge_now(), …_park() and …_wake() are
   called then only. */
int eyebridge_takes_turns(void);
/* Nanoseconds on the robot's clock. */
long long eyebridge_now(void);
/* The same for a program that looks at it, which takes time: so a loop that waits by looking ends.
   -1 when the caller's time is the computer's. Also for programs of several robots. */
long long eyebridge_read_clock(void);
/* Lays the caller down until somebody wakes `what`, or until `deadline` (ns on the robot's clock;
   -1: none). 1 when that came first; then the robot's time limit may end the program. */
int eyebridge_park(const void* what, long long deadline);
/* Threads of the program end each other's waits by eyebridge_wake(). Who else may end one: */
enum {
  EYEBRIDGE_NOBODY = 0,
  EYEBRIDGE_LIBRARIES = 1, /* a thread of a library */
  EYEBRIDGE_ANYBODY = 2    /* a signal's handler, another process, too: at any time */
};
/* The same, but the time limit does not end the program here, and the wait ends without a wake when
   is_free(what, value) is true. That is asked once at the start; and again and again where
   `else_may` names somebody. */
int eyebridge_park_unless(const void* what, long long deadline,
                          int (*is_free)(const void* what, long value), long value, int else_may);
void eyebridge_wake(const void* what, int all);
/* Before the caller sleeps, or makes a thread: begins the session where time will be virtual. */
void eyebridge_begin_time(void);
/* One that is about to be started by the caller; what the following take. */
void* eyebridge_thread_expected(void);
/* Its number, as its creator has it. */
void eyebridge_thread_is(void* member, unsigned long thread);
/* What the thread does first; it leaves by itself, after its thread-local variables. */
void eyebridge_thread_starts(void* member);
/* It cannot be started. */
void eyebridge_thread_failed(void* member);
/* From one to the other the caller sleeps only for what comes by itself: time waits for it. */
void eyebridge_hold_turn(void);
void eyebridge_release_turn(void);
/* pthread_cancel() was called for it. */
void eyebridge_thread_cancelled(unsigned long thread);
/* Returns when the thread is about to end: in virtual time the caller's turn is over till then. 0
   when it is none of them, and may go on for long; -1 when `deadline` (ns on the robot's clock; -1:
   none) came first. */
int eyebridge_thread_awaited(unsigned long thread, long long deadline);
/* NOLINTEND(readability-identifier-naming) */

#ifdef __cplusplus
}
#endif

#endif
