/* What the launcher's functions in the C library's place (launcher_*.c) ask of the library. C and
   C++. */
#ifndef EYEBRIDGE_FLEET_LAUNCHER_CALLS_H
#define EYEBRIDGE_FLEET_LAUNCHER_CALLS_H

#ifdef __cplusplus
extern "C" {
#endif

/* NOLINTBEGIN(readability-identifier-naming): the names of C */
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
