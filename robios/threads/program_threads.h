/* Which threads are the program's of the process's only robot. A thread that one of them makes is
   one, too, unless a call of the library makes it. C and C++. */
#ifndef EYEBRIDGE_THREADS_PROGRAM_THREADS_H
#define EYEBRIDGE_THREADS_PROGRAM_THREADS_H

#ifdef __cplusplus
extern "C" {
#endif

/* NOLINTBEGIN(readability-identifier-naming): the names of C */
/* 1 when the caller is one of them, outside of calls. */
int eyebridge_is_in_program(void);
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
