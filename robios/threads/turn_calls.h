/* What stands in the C library's place (locks.c, clocks.c, and whoever makes threads) asks of the
   library. C and C++. */
#ifndef EYEBRIDGE_THREADS_TURN_CALLS_H
#define EYEBRIDGE_THREADS_TURN_CALLS_H

#ifdef __cplusplus
extern "C" {
#endif

/* NOLINTBEGIN(readability-identifier-naming): the names of C */
enum {
  EYEBRIDGE_NO_TURNS = 0,   /* no robot's, or real time */
  EYEBRIDGE_IN_PROGRAM = 1, /* in a robot's program */
  EYEBRIDGE_IN_LIBRARY =
      2 /* in a call of it, and some robot has several threads: what a library waits for may be a
           thread of the process, but what it locks another robot's thread may have locked */
};

/* How a program ends by itself, and which exit handlers are called then. */
enum {
  EYEBRIDGE_EXIT = 0,       /* return from main(), exit() */
  EYEBRIDGE_QUICK_EXIT = 1, /* quick_exit() */
  EYEBRIDGE_AT_ONCE = 2,    /* _exit(): none */
  EYEBRIDGE_WITH_STATUS =
      3 /* of at_exit alone: as EYEBRIDGE_EXIT, and the handler is on_exit()'s */
};

struct sigaction;

/* What is asked when somebody calls the C library. */
struct eyebridge_robot_calls {
  /* End the caller's robot; return when the caller is no robot's program. */
  void (*leave)(int code, int how);
  void (*abort)(void);
  /* 1 when the caller's robot has a program and the address lies in one. */
  int (*is_program)(const void* address);
  /* `size` bytes of the caller's robot, all zero at first; null when it is none's. */
  void* (*state)(unsigned long size);
  /* 1 when `address` lies in a robot's program, in which `function` will be called at its end. */
  int (*at_exit)(int how, void* function, void* argument, const void* address);
  /* sigaction() of the caller's robot: 1 when the signal is its own; 0 when the process's handler
     is to be set, too. */
  int (*set_signal)(int signal, const struct sigaction* action, struct sigaction* before);
  /* raise() in its program: 1 when that has been done. */
  int (*raise)(int signal);
  /* Whether the caller's threads take turns, in virtual time: EYEBRIDGE_… below. The following are
   * asked then only. */
  int (*turns)(void);
  /* Nanoseconds on the clock of the caller's robot. */
  long long (*now)(void);
  /* The same for a program that looks at it, which takes time: so a loop that waits by looking
     ends. -1 when the caller's time is the computer's; without asking turns() before. */
  long long (*read_clock)(void);
  /* A thread of the caller's robot that runs start(argument); its number, never 0. */
  unsigned long (*create)(void* (*start)(void*), void* argument);
  /* The number of the calling thread; 0 when it is no created one. */
  unsigned long (*self)(void);
  /* Ends the calling thread. Does not return; but in real time, where it is none that has main().
   */
  void (*finish)(void* result);
  /* 0, or the error code of pthread_join(). */
  int (*join)(unsigned long thread, void** result);
  int (*detach)(unsigned long thread);
  /* As pthread_cancel(), but that it ends at once, and nothing is cleaned up. */
  int (*cancel)(unsigned long thread);
  /* The value of a key that is the calling thread's. */
  void* (*specific)(unsigned key);
  void (*set_specific)(unsigned key, const void* value);
  /* `destroy` (or null) is called with the values of threads that end. */
  void (*make_key)(unsigned key, void (*destroy)(void*));
  void (*forget_key)(unsigned key);
  /* A barrier for `count` threads; 0: it is gone. */
  void (*make_barrier)(const void* barrier, unsigned count);
  /* Waits for the others; 1 for the last one of them. */
  int (*meet)(const void* barrier);
  /* Lays the caller down until somebody wakes `what`, or until `deadline` (ns on its clock; -1:
     none). 1 when that came first. */
  int (*park)(const void* what, long long deadline);
  /* The same; is_free(what) tells when somebody else than the robot's threads may have woken it (a
     signal's handler, another process). Null where nobody asks. */
  int (*park_unless)(const void* what, long long deadline,
                     int (*is_free)(const void* what, long value), long value, int is_watched);
  void (*wake)(const void* what, int all);
  /* A lock that knows its owner: 1 when the caller has it now, else 0. */
  int (*own)(const void* lock);
  /* The owner's count of it: how often the caller has it still after this; -1 when it is not the
   * caller's. */
  int (*disown)(const void* lock);
  int (*owns)(const void* lock);
  /* In real time: what a new thread of the caller's robot begins with, given to begin_thread there.
   */
  void* (*robot)(void);
  void (*begin_thread)(void* robot);
  /* The new thread could not be made. */
  void (*forget_thread)(void* robot);
};

/* The launcher's: set by the library before the first program runs; all null before. */
extern struct eyebridge_robot_calls eyebridge_calls;

/* Runs the robots that the settings want. `argv`: PROGRAM and its arguments; without them the
   scenario names programs. Returns the exit code. Exported by the libraries. */
int EYEBRIDGERobotsMain(int argc, char** argv, struct eyebridge_robot_calls* calls);

/* NOLINTEND(readability-identifier-naming) */

#ifdef __cplusplus
}
#endif

#endif
